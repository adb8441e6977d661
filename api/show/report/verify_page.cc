#include "api/show/report/verify_page.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "api/show/report/verdict_text.h"
#include "calibration/verify/skill_set.h"
#include "calibration/verify/verdict.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using constants::nan;

bool is_current(const calibration::SkillSet& set) {
  return set.of.variable == calibration::current_variable && !set.of.column;
}

/// What is drawn and tabled together: forecasts of one origin under one wind policy.
struct Group {
  ForecastOrigin origin = ForecastOrigin::forecast;
  WindPolicy wind = WindPolicy::best;
  auto operator<=>(const Group&) const = default;
};

template <typename Of>
bool is_in(const Group& group, const Of& of) {
  return of.wind == group.wind && of.origin == group.origin;
}

/// "best", "best, hindcasts".
std::string text_of(const Group& group) {
  return std::string(name_of(group.wind)) +
         (group.origin == ForecastOrigin::hindcast ? ", hindcasts" : "");
}

void add_hour(SkillLine& line, const calibration::SkillSet& set, double rmse_m_s,
              const std::optional<calibration::Interval95>& interval) {
  line.lead_h.push_back(set.of.lead.to_h);
  line.rmse_m_s.push_back(rmse_m_s);
  line.low_m_s.push_back(interval ? interval->low : nan);
  line.high_m_s.push_back(interval ? interval->high : nan);
}

/// The lines of skill by lead hour, the forecast first. A baseline that has fewer days or values
/// than the forecast at some hour is called so, and the forecast over the same days and values is
/// the line behind it.
std::vector<SkillLine> lines_of(const std::vector<calibration::SkillSet>& sets,
                                const Group& group) {
  std::map<double, const calibration::SkillSet*> ours;
  std::map<calibration::Method, std::vector<const calibration::SkillSet*>> by_method;
  for (const calibration::SkillSet& set : sets) {
    if (!is_current(set) || !is_hour(set.of.lead) || !is_in(group, set.of)) continue;
    by_method[set.of.method].push_back(&set);
    if (set.of.method == calibration::Method::forecast) ours[set.of.lead.to_h] = &set;
  }
  const auto is_part = [&](const calibration::SkillSet* set) {
    const auto beside = ours.find(set->of.lead.to_h);
    return beside != ours.end() && calibration::is_part_of(*set, *beside->second);
  };
  std::vector<SkillLine> lines;
  for (const auto& [method, hours] : by_method) {
    const bool in_part = std::any_of(hours.begin(), hours.end(), is_part);
    SkillLine line;
    SkillLine beside;
    line.method = std::string(name_of(method)) + (in_part ? " (in part)" : "");
    beside.method = "forecast beside " + std::string(name_of(method));
    for (const calibration::SkillSet* set : hours) {
      add_hour(line, *set, set->score.rmse, set->score.rmse_interval);
      if (set->forecast_rmse) add_hour(beside, *set, *set->forecast_rmse, {});
    }
    const bool is_ours = method == calibration::Method::forecast;
    lines.insert(is_ours ? lines.begin() : lines.end(), std::move(line));
    if (in_part) lines.push_back(std::move(beside));
  }
  return lines;
}

/// At most four levels, spread evenly over those of which the forecast speaks.
std::vector<std::size_t> drawn_levels(const calibration::ForecastTrace& trace) {
  const std::size_t levels = trace.depth_m.size();
  std::vector<std::size_t> there;
  for (std::size_t k = 0; k < levels; ++k) {
    bool any = false;
    for (std::size_t t = 0; t < trace.time.size() && !any; ++t)
      any = !std::isnan(trace.truth_m_s[t * levels + k].real());
    if (any) there.push_back(k);
  }
  if (there.size() <= 4) return there;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < 4; ++i) chosen.push_back(there[i * (there.size() - 1) / 3]);
  return chosen;
}

SkillTrack track_of(const calibration::ForecastTrace& trace) {
  SkillTrack track;
  track.label = format_day(trace.day) + ", issued " + format_utc(trace.issued);
  track.time = trace.time;
  track.water_depth_m = trace.water_depth_m;
  const std::size_t levels = trace.depth_m.size();
  const std::vector<std::size_t> drawn = drawn_levels(trace);
  // A product's levels go on below the bed; there is nothing to draw of those.
  std::set<double> scored;
  for (const auto& [place, sum] : trace.misfit) scored.insert(place.second);
  track.depth_m.assign(scored.begin(), scored.end());
  for (const std::size_t k : drawn) track.drawn_depth_m.push_back(trace.depth_m[k]);
  for (std::size_t t = 0; t < trace.time.size(); ++t) {
    for (const double depth : track.depth_m) {
      const auto cell = trace.misfit.find({trace.time[t], depth});
      track.misfit_m_s.push_back(
          cell == trace.misfit.end() ? nan : std::sqrt(cell->second.sum / cell->second.weight));
    }
    for (const std::size_t k : drawn) {
      track.forecast_m_s.push_back(trace.forecast_m_s[t * levels + k]);
      track.truth_m_s.push_back(trace.truth_m_s[t * levels + k]);
    }
  }
  return track;
}

/// Squared errors of all forecasts by hour of lead and depth.
void pool_misfit(const std::vector<calibration::ForecastTrace>& traces, const Group& group,
                 SkillPolicy& policy) {
  std::map<std::pair<double, double>, calibration::BlockSum> pooled;
  std::set<double> hours;
  std::set<double> depths;
  for (const calibration::ForecastTrace& trace : traces) {
    if (!is_in(group, trace)) continue;
    policy.water_depth_m = std::max(policy.water_depth_m, trace.water_depth_m);
    const UtcTime end = UtcTime(trace.day) + std::chrono::days(1);
    for (const auto& [place, sum] : trace.misfit) {
      const auto hour = calibration::hour_of_lead(end, place.first);
      if (!hour) continue;
      const auto lead_h = static_cast<double>(*hour + 1);
      calibration::BlockSum& cell = pooled[{lead_h, place.second}];
      cell.sum += sum.sum;
      cell.weight += sum.weight;
      hours.insert(lead_h);
      depths.insert(place.second);
    }
  }
  policy.pooled_lead_h.assign(hours.begin(), hours.end());
  policy.pooled_depth_m.assign(depths.begin(), depths.end());
  for (const double hour : hours) {
    for (const double depth : depths) {
      const auto cell = pooled.find({hour, depth});
      policy.pooled_misfit_m_s.push_back(
          cell == pooled.end() ? nan : std::sqrt(cell->second.sum / cell->second.weight));
    }
  }
}

SkillPolicy policy_of(const Group& group, const calibration::Verification& result,
                      const std::vector<calibration::SkillSet>& sets,
                      const std::optional<calibration::Verdict>& verdict) {
  SkillPolicy policy;
  policy.wind = text_of(group);
  policy.by_lead = lines_of(sets, group);
  if (verdict && verdict->forecast.score.vector->reliability) {
    const calibration::Reliability& found = *verdict->forecast.score.vector->reliability;
    policy.probability.assign(found.probability.begin(), found.probability.end());
    policy.below.assign(found.below.begin(), found.below.end());
    policy.pit.assign(found.pit.begin(), found.pit.end());
  }
  for (const calibration::ForecastTrace& trace : result.traces)
    if (is_in(group, trace)) policy.tracks.push_back(track_of(trace));
  pool_misfit(result.traces, group, policy);
  return policy;
}

std::string cell(const std::optional<double>& value, FormatOf<double> format) {
  return value ? formatted(format, *value) : "";
}

/// An interval of a set; "few" where its pairs are.
std::string cell(const calibration::SetScore& set,
                 const std::optional<calibration::Interval95>& interval,
                 FormatOf<double, double> format, double factor) {
  if (interval) return formatted(format, factor * interval->low, factor * interval->high);
  return set.is_of_few() ? "few" : "";
}

/// Tables go down: the whole column first, then the bands by depth, the one near the bed last; by
/// day of lead; and by error as a share of ours, the yardstick that is no forecast last.
bool stands_before(const calibration::SkillSet& a, const calibration::SkillSet& b) {
  const auto key = [](const calibration::SkillSet& set) {
    const calibration::DepthBand band = set.of.band.value_or(calibration::DepthBand{});
    const bool is_whole = band.from_m <= 0 && band.to_m >= calibration::whole_column_m;
    return std::tuple(!is_whole, band.above_bed, band.from_m, band.to_m, set.of.lead.from_h,
                      set.of.method == calibration::Method::oracle_mean);
  };
  return key(a) != key(b) ? key(a) < key(b) : calibration::is_better(a, b);
}

std::vector<const calibration::SkillSet*> sorted_sets(
    const Group& group, const std::vector<calibration::SkillSet>& sets) {
  std::vector<const calibration::SkillSet*> sorted;
  for (const calibration::SkillSet& set : sets)
    if (is_current(set) && !is_hour(set.of.lead) && is_in(group, set.of)) sorted.push_back(&set);
  std::sort(sorted.begin(), sorted.end(),
            [](const auto* a, const auto* b) { return stands_before(*a, *b); });
  return sorted;
}

/// A table of these columns behind those that say what a row is of; our forecast's rows are marked.
template <typename CellsOf>
ReportTable table_of(std::string title, std::string note, std::vector<std::string> columns,
                     const std::vector<const calibration::SkillSet*>& sets,
                     const CellsOf& cells_of) {
  ReportTable table;
  table.title = std::move(title);
  table.note = std::move(note);
  table.columns = {"Depth", "Lead", "Method"};
  table.columns.insert(table.columns.end(), columns.begin(), columns.end());
  for (const calibration::SkillSet* set : sets) {
    if (set->of.method == calibration::Method::forecast)
      table.marked_rows.push_back(table.rows.size());
    std::vector<std::string> row{calibration::band_text(set->of.band),
                                 calibration::lead_text(set->of.lead),
                                 std::string(name_of(set->of.method))};
    for (std::string& text : cells_of(*set)) row.push_back(std::move(text));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// "80", "80 [75 to 84]", "80 (few)": the share of the truth inside the 80 % band.
std::string coverage_cell(const calibration::SetScore& set) {
  const calibration::VectorSetScore& v = set.vector.value();
  if (!v.coverage_80) return {};
  std::string text = formatted("{:.0f}", 100 * *v.coverage_80);
  const std::string interval = cell(set, v.coverage_interval, "{:.0f} to {:.0f}", 100);
  if (!interval.empty()) text += set.is_of_few() ? " (few)" : " [" + interval + "]";
  return text;
}

/// Two tables, each as wide as a page.
void add_tables(const Group& group, const std::vector<calibration::SkillSet>& sets,
                std::vector<ReportTable>& tables) {
  const std::vector<const calibration::SkillSet*> sorted = sorted_sets(group, sets);
  const std::string of_wind = ", wind " + text_of(group);
  tables.push_back(table_of(
      "Errors by depth, lead and method" + of_wind,
      "Pairs of days weigh the same. RMSE of the vector. Forecast there: the error of the forecast "
      "over the very days and values of the row, by whose share rows are ordered; a row of fewer "
      "pairs compares with nothing else. CRPS and the share inside the 80 % band pool east and "
      "north. 95 % intervals: block bootstrap of neighbouring pairs; few: fewer than five pairs, "
      "no "
      "interval. oracle-mean knows the day itself: a yardstick, not a forecast.",
      {"Pairs", "RMSE (m/s)", "95 %", "Forecast there (m/s)", "CRPS (m/s)", "In band (%)"}, sorted,
      [](const calibration::SkillSet& set) {
        const calibration::SetScore& s = set.score;
        return std::vector<std::string>{formatted("{}", s.pairs),
                                        formatted("{:.4f}", s.rmse),
                                        cell(s, s.rmse_interval, "{:.4f} to {:.4f}", 1),
                                        cell(set.forecast_rmse, "{:.4f}"),
                                        cell(s.vector.value().crps_m_s, "{:.4f}"),
                                        coverage_cell(s)};
      }));
  tables.push_back(table_of(
      "Biases, direction and correlation" + of_wind,
      "In the order of the errors above. Biases east, north and of the speed are forecast minus "
      "truth. Direction: mean absolute angle where both exceed 0.05 m/s. Correlation: modulus of "
      "the complex correlation.",
      {"Bias E (m/s)", "Bias N (m/s)", "Speed (m/s)", "Direction (deg)", "Correlation"}, sorted,
      [](const calibration::SkillSet& set) {
        const calibration::VectorSetScore& v = set.score.vector.value();
        return std::vector<std::string>{
            formatted("{:+.4f}", v.bias_east_m_s), formatted("{:+.4f}", v.bias_north_m_s),
            formatted("{:+.4f}", v.speed_bias_m_s), cell(v.direction_mae_deg, "{:.0f}"),
            cell(v.correlation_abs, "{:.2f}")};
      }));
}

ReportTable hourly_table_of(const SkillPolicy& policy) {
  ReportTable table;
  table.title = "Vector RMSE (m/s) by hour of lead, wind " + policy.wind;
  table.columns = {"Lead (h)"};
  std::map<double, std::vector<std::string>> rows;
  for (std::size_t j = 0; j < policy.by_lead.size(); ++j) {
    const SkillLine& line = policy.by_lead[j];
    table.columns.push_back(line.method);
    for (std::size_t i = 0; i < line.lead_h.size(); ++i) {
      auto& row = rows[line.lead_h[i]];
      row.resize(policy.by_lead.size() + 1);
      row[0] = formatted("{:g}", line.lead_h[i]);
      row[j + 1] = formatted("{:.4f}", line.rmse_m_s[i]);
    }
  }
  for (auto& [lead, row] : rows) table.rows.push_back(std::move(row));
  return table;
}

}  // namespace

SkillPage verify_page(const Site& site, const calibration::Verification& result,
                      const std::string& generated) {
  SkillPage page;
  page.title = "Skill of issued forecasts for " + site.name;
  page.site = position_text(site.point);
  page.generated = generated;
  const std::vector<calibration::SkillSet> sets = calibration::sets_of(result.entries).sets;
  std::set<Group> groups;
  std::set<std::string> truths;
  std::optional<UtcDay> first;
  std::optional<UtcDay> last;
  for (const calibration::SkillSet& set : sets) {
    if (!is_current(set)) continue;
    groups.insert({set.of.origin, set.of.wind});
    truths.insert(truth_text(set.of));
    first = first ? std::min(*first, set.first_day) : set.first_day;
    last = last ? std::max(*last, set.last_day) : set.last_day;
  }
  for (const Group& group : groups) {
    const auto verdict = calibration::verdict_of(result.entries, group.wind, group.origin);
    if (verdict) {
      page.headline += verdict_text(*verdict) + " ";
      if (verdict->best) page.headline += outcome_text(*verdict) + " ";
      page.beaten = page.beaten || verdict->is_beaten();
    }
    page.policies.push_back(policy_of(group, result, sets, verdict));
    add_tables(group, sets, page.tables);
    page.tables.push_back(hourly_table_of(page.policies.back()));
  }
  if (page.policies.empty()) page.headline = "The truth of the issued forecasts is not in yet.";
  if (first && last)
    page.facts.emplace_back("Days D", format_day(*first) + " to " + format_day(*last));
  for (const std::string& truth : truths) page.facts.emplace_back("Truth", truth);
  if (!result.traces.empty()) {
    const GeoPoint& point = result.traces.front().point;
    page.place = position_text(point);
    page.facts.emplace_back("Hodographs at", page.place);
  }
  return page;
}

}  // namespace slackwater::api

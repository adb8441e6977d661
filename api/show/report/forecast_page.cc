#include "api/show/report/forecast_page.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "api/show/report/forecast_series.h"
#include "api/show/report/forecast_speed.h"
#include "api/show/report/time_text.h"
#include "calibration/verify/skill_set.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/service/field.h"
#include "fields/service/wave_source.h"

namespace slackwater::api {
namespace {

using calibration::ForecastMaking;
using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;

using constants::nan;

/// A stretch of the forecast, and the clock that its times are told by.
struct Span {
  UtcTime from{};
  UtcTime to{};
  PageClock clock;
  [[nodiscard]] bool holds(UtcTime time) const { return time >= from && time <= to; }
};

/// The day that is asked about, else the first whole UTC day after the issue; where the forecast
/// does not hold it, all of it.
Span answered_span(const Snapshot& s, const std::optional<UtcDay>& about, const PageClock& clock,
                   std::string& title) {
  const UtcTime midnight = about ? UtcTime(*about) : std::chrono::ceil<days>(s.issued);
  if (midnight >= s.time.front() && midnight + days(1) <= s.time.back()) {
    title = "on " + date_text(midnight) + ", 00:00 to 24:00 UTC";
    return {midnight, midnight + days(1), clock};
  }
  title = "from " + PageClock().stamp(s.time.front()) + " to " + PageClock().stamp(s.time.back()) +
          " UTC";
  return {s.time.front(), s.time.back(), clock};
}

/// "06:30", with the date where the span is longer than a day.
std::string moment(const Span& span, UtcTime time) {
  return span.to - span.from <= days(1) ? span.clock.clock(time) : span.clock.stamp(time);
}

/// ", nearly sure 10:20–10:40", ", never nearly sure".
std::string sure_text(const SlackWindow& window, const Span& span) {
  if (!window.sure_from || *window.sure_to <= span.from || *window.sure_from >= span.to)
    return ", never nearly sure";
  const UtcTime from = std::max(*window.sure_from, span.from);
  const UtcTime to = std::min(*window.sure_to, span.to);
  return ", nearly sure " + (span.to - span.from == days(1)
                                 ? span.clock.clocks(from, to)
                                 : moment(span, from) + "–" + moment(span, to));
}

std::string slack_text(const ReportSpeed& speed, const ReportSpeedAtDepth& at, const Span& span) {
  if (!speed.no_tide.empty()) return speed.no_tide;
  std::string text;
  const bool is_day = span.to - span.from == days(1);
  for (const SlackWindow& window : at.slack) {
    if (window.to <= span.from || window.from >= span.to) continue;
    const UtcTime from = std::max(window.from, span.from);
    const UtcTime to = std::min(window.to, span.to);
    if (from == span.from && to == span.to)
      return formatted("the likely speed is below {:g} m/s throughout", speed.slack_below_m_s) +
             sure_text(window, span);
    text += (text.empty() ? "" : "; ") +
            (is_day ? span.clock.clocks(from, to) : moment(span, from) + "–" + moment(span, to)) +
            sure_text(window, span);
  }
  if (text.empty())
    return formatted("none: the likely speed never falls below {:g} m/s", speed.slack_below_m_s);
  return text + formatted(" (likely speed below {:g} m/s)", speed.slack_below_m_s);
}

void answer_current(const ReportSpeed& speed, const Span& span, ReportInput& page) {
  const ReportSpeedAtDepth& at = speed.depths[speed.first];
  std::optional<std::size_t> strongest;
  for (std::size_t t = 0; t < speed.time.size(); ++t) {
    if (!span.holds(speed.time[t]) || std::isnan(at.likely_m_s[t])) continue;
    if (!strongest || at.likely_m_s[t] > at.likely_m_s[*strongest]) strongest = t;
  }
  if (!strongest) {
    page.answer.emplace_back("Current", "no value at this depth");
    return;
  }
  page.answer.emplace_back("Slack", slack_text(speed, at, span));
  page.answer.emplace_back("Strongest current",
                           speed_text(at, *strongest) + " at " +
                               moment(span, speed.time[*strongest]) +
                               formatted(", to {:03.0f}°", at.towards_deg[*strongest]));
  std::string turns;
  for (const StrongestStream& stream : strongest_streams(speed, at)) {
    if (!span.holds(speed.time[stream.index])) continue;
    turns += (turns.empty() ? "" : ", ") + moment(span, speed.time[stream.index]) +
             formatted(" to {:03.0f}°", at.towards_deg[stream.index]);
  }
  if (!turns.empty()) page.answer.emplace_back("Tidal stream strongest", turns);
}

/// "up to 12.3 m/s (10.9 to 13.8) at 15:00".
void answer_highest(const std::string& label, const char* unit, const ReportLine& line,
                    const std::vector<UtcTime>& time, const Span& span, ReportInput& page) {
  if (line.values.empty()) {
    page.answer.emplace_back(label, "not in this forecast");
    return;
  }
  std::optional<std::size_t> highest;
  for (std::size_t t = 0; t < time.size(); ++t) {
    if (!span.holds(time[t]) || std::isnan(line.values[t])) continue;
    if (!highest || line.values[t] > line.values[*highest]) highest = t;
  }
  if (!highest) {
    page.answer.emplace_back(label, "no value");
    return;
  }
  std::string text = formatted("up to {:.1f} {}", line.values[*highest], unit);
  if (!line.low.empty())
    text += formatted(" (8 in 10: {:.1f} to {:.1f})", line.low[*highest], line.high[*highest]);
  page.answer.emplace_back(label, text + " at " + moment(span, time[*highest]));
}

/// Half-hourly, metre by metre (deeper waters coarser): smooth to look at.
ReportProfile profile_of(const Field& field, const ForecastTruth& truth) {
  const Snapshot& s = field.snapshot();
  const ForecastColumn& column = s.columns.front();
  ReportProfile profile;
  profile.water_depth_m = column.water_depth_m;
  const double step_m = std::max(1.0, std::ceil(column.water_depth_m / 60));
  for (double depth = 0; depth < column.water_depth_m; depth += step_m)
    profile.depth_m.push_back(depth);
  for (UtcTime time = s.time.front(); time <= s.time.back(); time += minutes(30))
    profile.time.push_back(time);
  std::vector<CurrentSample> samples(profile.depth_m.size());
  for (const UtcTime time : profile.time) {
    field.sample_profile(column.point.longitude_deg(), column.point.latitude_deg(), time,
                         profile.depth_m, samples);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const bool there = has_value(samples[k].status);
      profile.current_m_s.push_back(there ? samples[k].velocity_m_s : Horizontal(nan, nan));
      profile.sigma_m_s.push_back(there ? samples[k].sigma_m_s : nan);
      if (!truth.current) continue;
      const auto found = truth.current(profile.depth_m[k], time);
      profile.truth_m_s.push_back(found.value_or(Horizontal(nan, nan)));
    }
  }
  profile.hodograph_time = s.time.front() + hours(12);
  return profile;
}

/// The numbers every three hours, for a reader without plots and for paper.
ReportTable numbers_table(const ReportInput& page, const SurfaceSeries& surface,
                          const PageClock& clock) {
  ReportTable table;
  const ReportSpeedAtDepth* at = page.speed ? &page.speed->depths[page.speed->first] : nullptr;
  table.title = "Every three hours";
  table.note = "After each value: 10 to 90 %. " + clock.note();
  table.columns = {"UTC"};
  if (at != nullptr) {
    table.columns.push_back("Current at " + at->label + ", m/s");
    table.columns.emplace_back("flowing to");
  }
  if (!surface.wind.values.empty()) table.columns.emplace_back("Wind, m/s");
  if (!surface.waves.values.empty()) table.columns.emplace_back("Hs, m");
  if (!surface.level.values.empty()) table.columns.emplace_back("Level of the sea, m");
  const auto with_band = [](const ReportLine& line, std::size_t t) {
    if (std::isnan(line.values[t])) return std::string("no value");
    // No "-0.0": adding 0 takes its sign.
    const auto tenths = [](double value) { return std::round(10 * value) / 10 + 0.0; };
    std::string text = formatted("{:.1f}", tenths(line.values[t]));
    if (!line.low.empty())
      text += formatted(" ({:.1f} to {:.1f})", tenths(line.low[t]), tenths(line.high[t]));
    return text;
  };
  for (std::size_t t = 0; t < page.series_time.size(); t += 3) {
    std::vector<std::string> row{clock.stamp(page.series_time[t])};
    if (at != nullptr) {
      const auto found =
          std::lower_bound(page.speed->time.begin(), page.speed->time.end(), page.series_time[t]);
      const auto i = static_cast<std::size_t>(found - page.speed->time.begin());
      const bool there = i < page.speed->time.size() && !std::isnan(at->likely_m_s[i]);
      row.push_back(there ? formatted("{:.2f} ({:.2f} to {:.2f})", at->likely_m_s[i],
                                      at->low_m_s[i], at->high_m_s[i])
                          : "no value");
      row.push_back(there ? formatted("{:03.0f}°", at->towards_deg[i]) : "");
    }
    if (!surface.wind.values.empty()) row.push_back(with_band(surface.wind, t));
    if (!surface.waves.values.empty()) row.push_back(with_band(surface.waves, t));
    if (!surface.level.values.empty()) row.push_back(with_band(surface.level, t));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable streams_table(const ReportSpeed& speed, const PageClock& clock) {
  const ReportSpeedAtDepth& at = speed.depths[speed.first];
  ReportTable table;
  table.title = "When the stream is strongest at " + at.label;
  table.note =
      "After each speed: 10 to 90 %. Between these times the current is weaker. " + clock.note();
  table.columns = {"UTC", "Speed", "Flowing to"};
  for (const StrongestStream& stream : strongest_streams(speed, at)) {
    table.rows.push_back({clock.stamp(speed.time[stream.index]), speed_text(at, stream.index),
                          formatted("{:03.0f}°", at.towards_deg[stream.index])});
  }
  if (table.rows.empty()) table.rows.push_back({"the current hardly changes", "", ""});
  return table;
}

/// A baseline that has fewer days or values than the forecast at any lead is called so, and what
/// the forecast has over the same days and values stands beside it.
std::vector<ReportSkill> skill_of(const std::vector<calibration::SkillEntry>& entries,
                                  WindPolicy wind) {
  using calibration::Method;
  using calibration::SkillSet;
  std::vector<SkillSet> sets =
      calibration::sets_of(calibration::whole_current(entries, wind, ForecastOrigin::forecast))
          .sets;
  std::stable_sort(sets.begin(), sets.end(), [](const SkillSet& a, const SkillSet& b) {
    const auto order = [](const SkillSet& set) {  // ours first in each lead
      return std::tuple(set.of.lead.from_h, set.of.method != Method::forecast, set.of.method);
    };
    return order(a) < order(b);
  });
  std::set<Method> in_part;
  const SkillSet* ours = nullptr;
  for (const SkillSet& set : sets) {
    if (set.of.method == Method::forecast) ours = &set;
    if (ours != nullptr && set.of.lead == ours->of.lead && calibration::is_part_of(set, *ours))
      in_part.insert(set.of.method);
  }
  std::vector<ReportSkill> rows;
  for (const SkillSet& set : sets) {
    ReportSkill row;
    row.method = name_of(set.of.method);
    row.lead = formatted("{:.0f}–{:.0f} h", set.of.lead.from_h, set.of.lead.to_h);
    row.rmse_m_s = set.score.rmse;
    if (const auto& interval = set.score.rmse_interval)
      row.interval_95_m_s = std::pair(interval->low, interval->high);
    const bool is_part = in_part.contains(set.of.method);
    if (is_part) row.method += " (in part)";
    rows.push_back(row);
    if (!is_part || !set.forecast_rmse) continue;
    row.method = "forecast beside " + std::string(name_of(set.of.method));
    row.rmse_m_s = *set.forecast_rmse;
    row.interval_95_m_s.reset();
    rows.push_back(row);
  }
  return rows;
}

ReportTable calibration_table(const ForecastMaking::Fit& fit) {
  ReportTable table;
  table.title = "Parameters fitted on day D";
  table.columns = {"parameter", "value", "unit", "prior", "note"};
  for (const auto& p : fit.parameters) {
    std::string note = p.at_bound ? "at its bound" : "";
    if (p.weakly_determined) note += note.empty() ? "weakly determined" : ", weakly determined";
    table.rows.push_back(
        {p.name, formatted("{:.4g}", p.value), p.unit, formatted("{:.4g}", p.prior), note});
  }
  table.note = formatted("Misfit {:.3f} m/s over {} values. ", fit.rms_m_s, fit.observations) +
               fit.termination;
  return table;
}

/// Weights by method, a column for each day of lead.
ReportTable blend_table(const ForecastMaking::Mixture& mixture) {
  ReportTable table;
  table.title = "What was mixed";
  table.columns = {"method"};
  for (std::size_t day = 0; day < mixture.by_day.size(); ++day)
    table.columns.push_back(formatted("{}-{} h", 24 * day, 24 * (day + 1)));
  for (std::size_t method = 0; method < mixture.by_day.front().size(); ++method) {
    std::vector<std::string> row{mixture.by_day.front()[method].method};
    bool counts = false;
    for (const auto& shares : mixture.by_day) {
      const double weight = shares[method].weight;
      counts = counts || weight > 0;
      row.push_back(weight > 0 ? formatted("{:.0f} %", 100 * weight) : "");
    }
    if (counts) table.rows.push_back(std::move(row));
  }
  table.note = mixture.provenance + formatted(" Spread times {:.2f}. ", mixture.spread_scale) +
               mixture.spread_provenance;
  if (mixture.simulated_days > 0) {
    table.note += formatted(
        " {} of the rehearsed days have no stored wind run from that time: the later analysis with "
        "a random forecast error is used.",
        mixture.simulated_days);
  }
  return table;
}

/// A table of one column; none where it has no rows.
void fold_lines(const std::string& title, const std::string& column,
                const std::vector<std::string>& lines, ReportInput& page) {
  if (lines.empty()) return;
  ReportTable table;
  table.title = title;
  table.columns = {column};
  for (const std::string& line : lines) table.rows.push_back({line});
  page.folded.push_back(std::move(table));
}

void fold_making(const ForecastMaking& making, ReportInput& page) {
  page.folded_title = "How it was made: calibration, mixture, notes";
  if (making.fit) {
    page.folded.push_back(calibration_table(*making.fit));
  } else {
    ReportTable table;
    table.title = "Not calibrated";
    table.note = making.no_fit;
    page.folded.push_back(std::move(table));
  }
  if (making.mixture) page.folded.push_back(blend_table(*making.mixture));
  fold_lines("Whose values count", "quantity, product and run, from, to, why", making.sources,
             page);
  fold_lines("Notes", "note", making.notes, page);
}

std::string wind_policy_text(WindPolicy wind) {
  switch (wind) {
    case WindPolicy::best:
      return "best: the newest wind known then";
    case WindPolicy::forecast:
      return "forecast: as published by then";
    case WindPolicy::persist:
      return "persist: the last known wind, fading";
  }
  return {};
}

void add_facts(const Snapshot& s, const PageClock& clock, ReportInput& page) {
  page.facts = {{"Issued (UTC)", clock.stamp(s.issued)},
                {"Valid (UTC)", clock.stamp(s.time.front()) + " to " + clock.stamp(s.time.back())},
                {"Fitted on day D", format_day(s.day)}};
  if (s.wind_policy) page.facts.emplace_back("Wind", wind_policy_text(*s.wind_policy));
  if (const std::string waves = wave_sources_text(s); !waves.empty())
    page.facts.emplace_back("Waves", waves);
}

}  // namespace

double page_depth_m(const Snapshot& forecast, std::optional<double> asked_m) {
  const double water_m = forecast.columns.front().water_depth_m;
  if (!asked_m) return std::min(10.0, std::floor(water_m / 2));
  if (*asked_m >= 0 && *asked_m <= water_m) return *asked_m;
  throw Error(ErrorKind::usage, formatted("--html-depth: found {:g} m, but the water is {:.1f} m "
                                          "deep there; give a depth from 0 to {:.1f}",
                                          *asked_m, water_m, water_m));
}

ReportInput forecast_page(const ForecastPage& what) {
  const Snapshot& s = *what.forecast;
  const ForecastColumn& column = s.columns.front();
  ReportInput page;
  page.title = "Forecast for " + s.site_name;
  page.site = position_text(column.point) +
              formatted(", {:.0f} m of water; forecast issued ", column.water_depth_m) +
              format_utc(s.issued).substr(0, 10) + " " + format_utc(s.issued).substr(11, 5) +
              " UTC";
  if (s.columns.size() > 1) page.site += formatted("; the first of {} columns", s.columns.size());
  page.headline = s.headline;
  page.degraded = s.degraded;
  page.issued = s.issued;
  const PageClock clock(what.time_zone);
  add_facts(s, clock, page);
  if (what.time_zone) {
    page.time_zone = what.time_zone->name();
    page.clock_changes = what.time_zone->changes(s.time.front(), s.time.back());
  }
  std::string when;
  const Span span = answered_span(s, what.about, clock, when);
  const Field field(what.forecast);
  if (has_currents(column)) {
    page.speed = speed_of(field, page_depth_m(s, what.depth_m), what.slack_below_m_s, clock);
    page.profile = profile_of(field, what.truth);
    page.answer_title = "At " + page.speed->depths[page.speed->first].label + " " + when;
    answer_current(*page.speed, span, page);
  } else {
    page.answer_title = "The answer " + when;
    page.answer.emplace_back("Current", "not in this forecast: see the sentence above");
  }
  const SurfaceSeries surface = surface_series(s, what.truth, what.chart_datum);
  page.series_time = s.time;
  page.series = surface.panels;
  page.series_note = surface.note;
  answer_highest("Wind at 10 m", "m/s", surface.wind, s.time, span, page);
  answer_highest("Waves (Hs)", "m", surface.waves, s.time, span, page);
  if (!what.verified.empty()) page.answer.emplace_back("How good it was", what.verified);
  if (page.speed && page.speed->no_tide.empty())
    page.tables.push_back(streams_table(*page.speed, clock));
  page.tables.push_back(numbers_table(page, surface, clock));
  page.skill = skill_of(what.skill, s.wind_policy.value_or(WindPolicy::best));
  page.skill_note = what.skill_note;
  if (what.making) fold_making(*what.making, page);
  page.attributions = s.attributions;
  page.generated = what.generated;
  return page;
}

}  // namespace slackwater::api

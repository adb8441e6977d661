#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "api/show/report/skill_table.h"
#include "api/show/report/verdict_text.h"
#include "calibration/verify/skill_set.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr const char* explanation =
    "Pairs of days (D, D+1) weigh the same. RMSE is of the vector; ours: of our forecast over the "
    "very days and\nvalues of that row, by whose share rows are ordered. [95 %]: block bootstrap "
    "that "
    "draws neighbouring pairs of\ndays; few: fewer than five pairs, no interval. dir: mean "
    "absolute "
    "angle in degrees where both exceed 0.05 m/s.\ncorr: complex correlation. CRPS and the share "
    "inside the 80 % band pool east and north.\n";

/// Right in a column.
std::string right(const std::string& text, std::size_t width) {
  return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::string dash(std::size_t width) { return right("-", width); }

std::string or_dash(const std::optional<double>& value, FormatOf<double> format,
                    std::size_t width) {
  return value ? formatted(format, *value) : dash(width);
}

/// The interval of a set; "few" where its pairs are.
std::string interval_text(const calibration::SetScore& set,
                          const std::optional<calibration::Interval95>& interval,
                          FormatOf<double, double> format, std::size_t width) {
  if (interval) return formatted(format, interval->low, interval->high);
  return set.is_of_few() ? right("few", width) : dash(width);
}

std::string heading(const calibration::SkillEntry& e) {
  std::string text = "\n" + e.variable + ", " + calibration::band_text(e.band) + ", lead " +
                     calibration::lead_text(e.lead) + ", wind " + wind_text(e) +
                     (e.origin == ForecastOrigin::hindcast ? ", hindcasts" : "") + ", truth " +
                     truth_text(e) + "\n";
  if (e.scalar)
    return text + formatted("  {:<15} {:>5} {:>8} {:>8} {:>8} {:>17} {:>8}\n", "method", "pairs",
                            "values", "rmse m", "ours", "[95 %]", "bias m");
  return text +
         formatted(
             "  {:<15} {:>5} {:>8} {:>8} {:>8} {:>17} {:>7} {:>7} {:>7} {:>5} {:>5} {:>7} {:>7} "
             "{:>9}\n",
             "method", "pairs", "values", "rmse m/s", "ours", "[95 %]", "bias E", "bias N", "speed",
             "dir", "corr", "CRPS", "in 80%", "[95 %]");
}

std::string row(const calibration::SkillSet& set) {
  const calibration::SetScore& s = set.score;
  std::string line = formatted("{} {:<15} {:>5} {:>8} {:>8.4f} ",
                               set.of.method == calibration::Method::forecast ? " >" : "  ",
                               name_of(set.of.method), s.pairs, s.n, s.rmse);
  line += or_dash(set.forecast_rmse, "{:>8.4f}", 8) + " ";
  line += interval_text(s, s.rmse_interval, "[{:>7.4f},{:>7.4f}]", 17);
  if (!s.vector) return line + formatted(" {:>+7.4f}\n", s.bias.value_or(0));
  const calibration::VectorSetScore& v = *s.vector;
  line += formatted(" {:>+7.4f} {:>+7.4f} {:>+7.4f} ", v.bias_east_m_s, v.bias_north_m_s,
                    v.speed_bias_m_s);
  line += or_dash(v.direction_mae_deg, "{:>5.0f}", 5) + " ";
  line += or_dash(v.correlation_abs, "{:>5.2f}", 5);
  if (!v.coverage_80) return line + "\n";
  line += " " + or_dash(v.crps_m_s, "{:>7.4f}", 7);
  line += formatted(" {:>6.0f}% ", 100 * *v.coverage_80);
  std::optional<calibration::Interval95> percent = v.coverage_interval;
  if (percent) percent = {100 * percent->low, 100 * percent->high};
  return line + interval_text(s, percent, "[{:>3.0f},{:>3.0f}]", 9) + "\n";
}

std::string reliability_line(const calibration::Reliability& reliability) {
  std::string line = "    truth below the quantile";
  for (std::size_t i = 0; i < reliability.below.size(); ++i)
    line += formatted("  {:.0f}%: {:.0f}%", 100 * calibration::Reliability::probability[i],
                      100 * reliability.below[i]);
  return line + "\n";
}

bool is_hour_of_a_band(const calibration::SkillEntry& e) { return e.band && is_hour(e.lead); }

/// What one block of the table shares.
auto block_of(const calibration::SkillEntry& e) {
  const calibration::DepthBand band = e.band.value_or(calibration::DepthBand{});
  return std::tuple(e.variable, e.origin, e.wind, band.from_m, band.to_m, band.above_bed,
                    e.lead.from_h, e.lead.to_h);
}

std::string block_text(std::vector<const calibration::SkillSet*> sets) {
  std::sort(sets.begin(), sets.end(),
            [](const auto* a, const auto* b) { return calibration::is_better(*a, *b); });
  std::string text = heading(sets.front()->of);
  for (const calibration::SkillSet* set : sets) text += row(*set);
  for (const calibration::SkillSet* set : sets)
    if (set->score.vector && set->score.vector->reliability)
      text += reliability_line(*set->score.vector->reliability);
  return text;
}

using SetsByMethod = std::map<calibration::Method, const calibration::SkillSet*>;
using SetsByLead = std::map<std::pair<double, double>, SetsByMethod>;

std::string error_cell(const SetsByMethod& sets, calibration::Method method) {
  const auto found = sets.find(method);
  return found == sets.end() ? formatted(" {:>10}", "-")
                             : formatted(" {:>10.3f}", found->second->score.rmse);
}

/// Whether a baseline has fewer days or values than our forecast in one of the sets of a lead.
bool is_part(const SetsByMethod& sets, calibration::Method method) {
  const auto ours = sets.find(calibration::Method::forecast);
  const auto found = sets.find(method);
  return ours != sets.end() && found != sets.end() &&
         calibration::is_part_of(*found->second, *ours->second);
}

bool is_part_at_any_lead(const SetsByLead& by_lead, calibration::Method method) {
  return std::any_of(by_lead.begin(), by_lead.end(),
                     [&](const auto& lead) { return is_part(lead.second, method); });
}

/// Our own error over the days and values of a baseline.
std::string forecast_there_cell(const SetsByMethod& sets, calibration::Method method) {
  const auto found = sets.find(method);
  return found == sets.end() || !found->second->forecast_rmse
             ? formatted(" {:>10}", "-")
             : formatted(" {:>10.3f}", *found->second->forecast_rmse);
}

}  // namespace

std::string short_skill_table(const std::vector<calibration::SkillEntry>& entries, WindPolicy wind,
                              ForecastOrigin origin) {
  using calibration::Method;
  SetsByLead by_lead;
  const calibration::SkillSets all =
      calibration::sets_of(calibration::whole_current(entries, wind, origin));
  for (const calibration::SkillSet& set : all.sets)
    by_lead[{set.of.lead.from_h, set.of.lead.to_h}][set.of.method] = &set;
  if (by_lead.empty()) return {};
  const auto& first = by_lead.begin()->second;
  std::vector<const calibration::SkillSet*> rows;
  rows.reserve(first.size());
  for (const auto& [method, set] : first) rows.push_back(set);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto* a, const auto* b) { return calibration::is_better(*a, *b); });
  std::string table =
      "\nError of the current, all depths, vector RMSE in m/s by hours after day D:\n";
  table += formatted("  {:<15} {:>5}", "method", "pairs");
  for (const auto& [lead, sets] : by_lead)
    table += formatted(" {:>10}", calibration::lead_text({lead.first, lead.second}));
  table += formatted(" {:>7}\n", "in 80%");
  for (const calibration::SkillSet* row : rows) {
    const Method method = row->of.method;
    table += formatted("{} {:<15} {:>5}", method == Method::forecast ? " >" : "  ", name_of(method),
                       row->score.pairs);
    for (const auto& [lead, sets] : by_lead) table += error_cell(sets, method);
    const auto& coverage = row->score.vector->coverage_80;
    table += coverage ? formatted(" {:>6.0f}%\n", 100 * *coverage) : "\n";
    if (is_part_at_any_lead(by_lead, method)) {
      table += formatted("    {:<13} {:>5}", "forecast there", "");
      for (const auto& [lead, sets] : by_lead) table += forecast_there_cell(sets, method);
      table += "\n";
    }
  }
  if (first.contains(Method::oracle_mean))
    table += "oracle-mean knows the day itself: a yardstick, not a forecast.\n";
  const auto is_few = [](const auto* row) { return row->score.is_of_few(); };
  if (std::any_of(rows.begin(), rows.end(), is_few))
    table += "Fewer than five pairs of days: too few for an interval.\n";
  return table;
}

std::string skill_table(const std::vector<calibration::SkillEntry>& entries) {
  const calibration::SkillSets all = calibration::sets_of(entries);
  std::vector<std::vector<const calibration::SkillSet*>> blocks;
  std::map<decltype(block_of(entries.front())), std::size_t> index;
  for (const calibration::SkillSet& set : all.sets) {
    if (set.of.column || is_hour_of_a_band(set.of)) continue;
    const auto [found, is_new] = index.try_emplace(block_of(set.of), blocks.size());
    if (is_new) blocks.emplace_back();
    blocks[found->second].push_back(&set);
  }
  std::string table = "\n";
  table += explanation;
  for (auto& block : blocks) table += block_text(std::move(block));
  return table;
}

std::string hourly_table(const std::vector<calibration::SkillEntry>& entries) {
  const calibration::SkillSets all = calibration::sets_of(entries);
  std::map<std::pair<ForecastOrigin, WindPolicy>, SetsByLead> tables;
  for (const calibration::SkillSet& set : all.sets) {
    if (set.of.column || !is_hour_of_a_band(set.of)) continue;
    tables[{set.of.origin, set.of.wind}][{set.of.lead.from_h, set.of.lead.to_h}][set.of.method] =
        &set;
  }
  std::string text;
  for (const auto& [of, by_lead] : tables) {
    std::set<calibration::Method> methods;
    for (const auto& [lead, sets] : by_lead)
      for (const auto& [method, set] : sets) methods.insert(method);
    text += "\nvector RMSE (m/s) by hour of lead, wind " + std::string(name_of(of.second)) +
            (of.first == ForecastOrigin::hindcast ? ", hindcasts" : "") + "\n  lead h";
    for (const calibration::Method method : methods) {
      text += formatted(" {:>14}", name_of(method));
      if (is_part_at_any_lead(by_lead, method)) text += formatted(" {:>14}", "forecast there");
    }
    text += "\n";
    for (const auto& [lead, sets] : by_lead) {
      text += formatted("  {:>6g}", lead.second);
      for (const calibration::Method method : methods) {
        const auto found = sets.find(method);
        const calibration::SkillSet* const set = found == sets.end() ? nullptr : found->second;
        text +=
            set == nullptr ? formatted(" {:>14}", "-") : formatted(" {:>14.4f}", set->score.rmse);
        if (!is_part_at_any_lead(by_lead, method)) continue;
        text += set == nullptr || !set->forecast_rmse
                    ? formatted(" {:>14}", "-")
                    : formatted(" {:>14.4f}", *set->forecast_rmse);
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace slackwater::api

#include "calibration/day/given/spread_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "calibration/day/given/wind_ensemble.h"
#include "calibration/skill/bootstrap.h"
#include "fields/base/text.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Hourly means are stamped half an hour beside the members' times; across more than this a line is
/// too smooth to be the truth.
constexpr Duration between_truths = hours(2);

/// Mean squares of a component, summed over what falls into one day.
struct DaySums {
  double error = 0;
  double spread = 0;
  double pairs = 0;
};
using DaysOfLead = std::vector<std::map<UtcDay, DaySums>>;

VectorColumn analysed_part(const VectorColumn& wind, UtcTime until) {
  VectorColumn truth;
  truth.point = wind.point;
  for (std::size_t t = 0; t < wind.times(); ++t) {
    const bool is_past =
        wind.source[t] == DataStatus::analysis || wind.source[t] == DataStatus::observation;
    if (!is_past || wind.time[t].centre() > until || !wind.has(t)) continue;
    truth.time.push_back(wind.time[t]);
    truth.value.push_back(wind.value[wind.offset(t, 0)]);
    truth.status.push_back(wind.status[wind.offset(t, 0)]);
    truth.source.push_back(wind.source[t]);
  }
  return truth;
}

/// What the members say at each time that any of them has.
std::map<UtcTime, std::vector<Horizontal>> said_by(const WindEnsemble& ensemble) {
  std::map<UtcTime, std::vector<Horizontal>> said;
  for (const VectorColumn& member : ensemble.members) {
    for (std::size_t t = 0; t < member.times(); ++t)
      said[member.time[t].centre()].push_back(member.value[t]);
  }
  return said;
}

void hold_against(const VectorColumn& truth, const WindEnsemble& ensemble, DaysOfLead& leads) {
  for (const auto& [time, members] : said_by(ensemble)) {
    if (time <= ensemble.run.reference_time || members.size() < fewest_wind_members) continue;
    const auto wind = value_at(truth, time, between_truths);
    if (!wind) continue;
    const auto count = static_cast<double>(members.size());
    const Horizontal mean = std::accumulate(members.begin(), members.end(), Horizontal{}) / count;
    double squares = 0;
    for (const Horizontal member : members) squares += 0.5 * std::norm(member - mean);
    const Duration lead = time - ensemble.run.reference_time;
    const auto day = static_cast<std::size_t>((lead - Duration(1)) / hours(24));
    if (leads.size() <= day) leads.resize(day + 1);
    DaySums& sums = leads[day][day_of(time - Duration(1))];  // midnight is the end of a day
    sums.error += 0.5 * std::norm(mean - *wind);
    sums.spread += (count + 1) / count * squares / (count - 1);
    sums.pairs += 1;
  }
}

CheckedLead judged(const std::map<UtcDay, DaySums>& by_day) {
  CheckedLead lead;
  std::vector<BlockSum> ratio;
  double error = 0;
  double spread = 0;
  for (const auto& [day, sums] : by_day) {
    ratio.push_back({sums.error / sums.pairs, sums.spread / sums.pairs});
    error += ratio.back().sum;
    spread += ratio.back().weight;
  }
  lead.days = by_day.size();
  if (lead.days == 0) return lead;
  lead.rms_error_m_s = std::sqrt(error / static_cast<double>(lead.days));
  lead.rms_spread_m_s = std::sqrt(spread / static_cast<double>(lead.days));
  if (!lead.is_checked() || spread <= 0) return lead;
  Rng random(1, "calibration/spread_check");
  const auto interval = bootstrap_mean(ratio, random);
  if (!interval || (interval->low <= 1 && interval->high >= 1)) return lead;
  lead.factor = std::clamp(std::sqrt(error / spread), least_spread_factor, most_spread_factor);
  return lead;
}

}  // namespace

bool SpreadCheck::is_checked() const noexcept {
  return std::any_of(lead.begin(), lead.end(), [](const CheckedLead& l) { return l.is_checked(); });
}

double SpreadCheck::factor_at(double lead_h) const noexcept {
  double before_h = 0;
  const CheckedLead* before = nullptr;
  for (std::size_t day = 0; day < lead.size(); ++day) {
    if (!lead[day].is_checked()) continue;
    const double middle_h = 24.0 * static_cast<double>(day) + 12.0;
    if (lead_h <= middle_h) {
      if (before == nullptr) return lead[day].factor;
      const double share = (lead_h - before_h) / (middle_h - before_h);
      return before->factor + share * (lead[day].factor - before->factor);
    }
    before = &lead[day];
    before_h = middle_h;
  }
  return before == nullptr ? 1.0 : before->factor;
}

SpreadCheck check_spread(const VectorRecord& wind, const std::string& dataset,
                         const Knowledge& knowledge, const VectorColumn& truth, UtcTime until) {
  const VectorColumn analysed = analysed_part(truth, until);
  DaysOfLead days;
  for (const WindEnsemble& past : wind_ensembles(wind, dataset, knowledge, until))
    hold_against(analysed, past, days);
  SpreadCheck check;
  for (const auto& of_lead : days) check.lead.push_back(judged(of_lead));
  return check;
}

std::string text_of(const SpreadCheck& check) {
  if (!check.is_checked()) {
    std::size_t most = 0;
    for (const CheckedLead& lead : check.lead) most = std::max(most, lead.days);
    return formatted(
        "its spread is not checked yet: {} days with an analysed wind are stored, {} are needed",
        most, fewest_checked_days);
  }
  std::string text = "its spread was checked against its error: ";
  bool is_first = true;
  for (std::size_t day = 0; day < check.lead.size(); ++day) {
    const CheckedLead& lead = check.lead[day];
    if (!lead.is_checked()) continue;
    const std::string verdict =
        lead.factor == 1 ? "agrees" : formatted("times {:.2f}", lead.factor);
    text += formatted("{}day {} {} ({:.1f} of {:.1f} m/s, {} days)", is_first ? "" : ", ", day + 1,
                      verdict, lead.rms_error_m_s, lead.rms_spread_m_s, lead.days);
    is_first = false;
  }
  return text;
}

}  // namespace slackwater::calibration

#include "calibration/day/given/driving_ensemble.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::calibration {

namespace {

/// The mean of what the members say at a stamp; NaN where none says anything.
Horizontal mean_at(const std::vector<WindMember>& members, std::size_t t) {
  Horizontal sum{};
  double count = 0;
  for (const WindMember& member : members) {
    if (std::isnan(member.wind_m_s[t].real())) continue;
    sum += member.wind_m_s[t];
    count += 1;
  }
  return sum / count;
}

}  // namespace

WindDepartures departures_of(const HorizonWind& wind, std::span<const UtcTime> stamps) {
  using constants::nan;
  std::vector<double> factor;
  std::vector<Horizontal> mean;
  for (std::size_t t = 0; t < wind.wind_m_s.size(); ++t) {
    const double lead_h = hours_between(wind.member_run.reference_time, stamps[t]);
    factor.push_back(wind.member_run.spread.factor_at(lead_h));
    mean.push_back(mean_at(wind.members, t));
  }
  WindDepartures departures;
  bool any = false;
  for (const WindMember& member : wind.members) {
    departures.number.push_back(member.number);
    for (std::size_t t = 0; t < wind.wind_m_s.size(); ++t) {
      const bool is_over =
          wind.source[t] == DataStatus::analysis || wind.source[t] == DataStatus::observation;
      const Horizontal said = factor[t] == 1 ? member.wind_m_s[t]
                                             : mean[t] + factor[t] * (member.wind_m_s[t] - mean[t]);
      departures.departure_m_s.push_back(is_over ? Horizontal(nan, nan) : said - wind.wind_m_s[t]);
      any = any || !std::isnan(departures.departure_m_s.back().real());
    }
  }
  return any ? departures : WindDepartures{};
}

std::string text_of(const WindEnsembleRun& run) {
  return run.product_id + " issued " + format_utc(run.reference_time);
}

std::string note_on(const WindEnsembleRun& run, const WindDepartures& ensemble, std::size_t members,
                    const ForecastPlan& plan) {
  const std::vector<double> variance = ensemble_variance(ensemble, plan.stamps.size());
  const double least = least_ensemble_sigma_m_s() * least_ensemble_sigma_m_s();
  std::size_t raised = 0;
  std::size_t silent = 0;
  std::size_t after = 0;
  for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
    if (plan.stamps[t] <= plan.end_of_day()) continue;
    ++after;
    if (std::isnan(variance[t])) ++silent;
    if (variance[t] < least) ++raised;
  }
  std::string note = "wind of " + std::to_string(members) + " members from " +
                     std::to_string(run.number.size()) + " of " + text_of(run) +
                     ", numbers recorded; " + text_of(run.spread);
  if (raised > 0) {
    note += formatted(
        "; at {} of {} hours its spread was too small and is raised to {:.1f} m/s, the error of an "
        "analysis",
        raised, after, least_ensemble_sigma_m_s());
  }
  if (silent > 0) {
    note += formatted("; it has no value at {} of {} hours; the usual wind error is used there",
                      silent, after);
  }
  return note;
}

bool looks_ahead(const WindEnsembleRun& run, const ForecastPlan& plan) {
  const Knowledge known{plan.best.known_by, plan.best.known_by, plan.best.known_by};
  return plan.wind == WindPolicy::best &&
         std::any_of(run.origins.begin(), run.origins.end(), [&](const Origin* origin) {
           return !is_known(*origin, TimeCell::instant(run.reference_time), known);
         });
}

}  // namespace slackwater::calibration

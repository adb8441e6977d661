#include <cmath>
#include <numbers>

#include "calibration/day/given/horizon.h"
#include "calibration/day/given/horizon_input.h"
#include "calibration/day/given/simulated_run.h"

namespace slackwater::calibration {
namespace {

void append(VectorColumn& series, UtcTime time, Horizontal value, DataStatus source) {
  series.time.push_back(TimeCell::instant(time));
  series.value.push_back(value);
  series.status.push_back(SampleStatus::ok);
  series.source.push_back(source);
}

/// Share of a 10 m wind by which it may be wrong that was brought down from another height on the
/// profile of neutral air: the exponent of the wind over sea lies between 0.05 and 0.20, and 0.06
/// about its mean of 0.11 to 0.14 (IEC 61400-1 and -3), so 0.06 |ln(h/10)|: 14 % from 100 m. Ours.
double error_of_height(double height_m) {
  constexpr double exponent_sigma = 0.06;
  return exponent_sigma * std::abs(std::log(height_m / 10.0));
}

/// What bringing the wind to 10 m adds to its error at the stamps.
void add_error_of_height(const Chosen<Horizontal>& known, std::span<const UtcTime> stamps,
                         const std::vector<Horizontal>& wind, std::vector<double>& sigma_m_s) {
  for (const Stretch& stretch : known.stretches) {
    if (!stretch.from_height_m) continue;
    for (std::size_t t = 0; t < stamps.size(); ++t) {
      if (stamps[t] < stretch.from || stamps[t] > stretch.to) continue;
      const double error = error_of_height(*stretch.from_height_m) * std::abs(wind[t]);
      sigma_m_s[t] = std::hypot(sigma_m_s[t], error * std::numbers::sqrt2 / 2);
    }
  }
}

/// Nothing of a weather forecast is looked at where the wind persists.
void add_members(const VectorRecord& wind, WindPolicy policy, UtcTime end_of_day,
                 std::span<const UtcTime> stamps, const BestInputs& best, const VectorColumn& known,
                 HorizonWind& result) {
  if (policy == WindPolicy::persist) return;
  const Knowledge knowledge = knowledge_of(policy, end_of_day, best);
  const auto ensemble = newest_wind_ensemble(wind, knowledge, stamps);
  if (!ensemble) return;
  result.members = members_at(*ensemble, stamps);
  result.member_run = ensemble->run;
  result.member_run.spread =
      check_spread(wind, ensemble->run.dataset, knowledge, known, end_of_day);
}

/// The wind as chosen, over the stamps.
HorizonWind wind_over(const Chosen<Horizontal>& known, std::span<const UtcTime> stamps) {
  HorizonWind result;
  result.stretches = known.stretches;
  VectorColumn series;
  series.point = known.column.point;
  for (std::size_t t = 0; t < known.column.times(); ++t) {
    if (!known.column.has(t)) continue;
    append(series, known.column.time[t].centre(), known.column.value[t], known.column.source[t]);
    result.origins.push_back(known.origin[t]);
  }
  if (series.times() == 0) return result;
  FilledWind filled = fill_wind(series, stamps);
  add_error_of_height(known, stamps, filled.wind_m_s, filled.hole_sigma_m_s);
  result.wind_m_s = std::move(filled.wind_m_s);
  result.source = std::move(filled.source);
  result.extra_sigma_m_s = std::move(filled.hole_sigma_m_s);
  result.gaps = std::move(filled.gaps);
  result.series = std::move(filled.series);
  return result;
}

}  // namespace

HorizonWind horizon_wind(const VectorRecord& wind, WindPolicy policy, UtcTime end_of_day,
                         std::span<const UtcTime> stamps, const BestInputs& best) {
  Chosen<Horizontal> known = choose_input(wind, policy, end_of_day, best);
  HorizonWind result = wind_over(known, stamps);
  if (best.simulated_seed && policy != WindPolicy::persist &&
      !reaches_beyond(result, stamps, end_of_day)) {
    known = with_simulated_run(choose_analysed(wind, end_of_day, best), end_of_day, best);
    HorizonWind simulated = wind_over(known, stamps);
    if (reaches_beyond(simulated, stamps, end_of_day)) {
      simulated.simulated = true;
      return simulated;
    }
    return result;
  }
  result.hindsight = looks_ahead(known, best);
  add_members(wind, policy, end_of_day, stamps, best, known.column, result);
  return result;
}

}  // namespace slackwater::calibration

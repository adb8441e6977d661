#pragma once
#include <span>

#include "calibration/propagate/propagate.h"
#include "tests/calibration/solve/unsteady_day.h"

namespace slackwater::calibration {

inline constexpr UtcTime end_of_synthetic_day = synthetic_midnight + std::chrono::hours(24);

/// Whole hours of lead.
inline std::vector<UtcTime> leads(int from_h, int to_h) {
  std::vector<UtcTime> times;
  for (int h = from_h; h <= to_h; ++h) times.push_back(add_hours(end_of_synthetic_day, h));
  return times;
}

/// A shelf day in the north with interior, trend and inertial motion.
inline UnsteadyDay usual_day(SteadyForm form = SteadyForm::finite_depth) {
  UnsteadyDay day;
  day.form = form;
  day.truth.interior_east_m_s = 0.2;
  day.truth.interior_north_m_s = -0.1;
  day.inertial_m_s = {0.08, -0.05};
  if (form == SteadyForm::mixed_layer) day.water_depth_m = 90;
  if (form == SteadyForm::three_layer) day.water_depth_m = 420;
  return day;
}

/// The day under a wind that has never changed and with nothing else that moves.
inline CalibrationInput steady_wind_input(const UnsteadyDay& day, Horizontal wind_m_s = {8, 3}) {
  CalibrationInput input = synthetic_input(day);
  input.is_unsteady = true;
  const StressSeries veering(*input.wind, input.drag_law);
  std::fill(input.wind->value.begin(), input.wind->value.end(), wind_m_s);
  const Horizontal stress = wind_stress_pa(wind_m_s, input.drag_law);
  const LevelResponses r =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    for (std::size_t k = 0; k < r.levels(); ++k)
      input.current.value[input.current.offset(t, k)] +=
          (stress - *veering.over(input.current.time[t])) * r.stress(k);
  }
  return input;
}

inline Propagated outlook(const Calibration& fitted, std::span<const UtcTime> times,
                          const std::optional<VectorColumn>& wind,
                          const WindErrorGrowth& wind_error = {}, std::uint64_t seed = 1,
                          const Spread& spread = {}) {
  return propagate(std::span(&fitted, 1), times, wind, end_of_synthetic_day, wind_error, spread,
                   seed);
}

}  // namespace slackwater::calibration

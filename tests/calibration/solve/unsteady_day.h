#pragma once
#include "fields/current/column_modes.h"
#include "fields/current/coriolis.h"
#include "tests/calibration/solve/synthetic_day.h"
#include "tests/support/unsteady_column.h"

namespace slackwater::calibration {

/// A synthetic day whose water remembers: the steady form, the transient of its wind, an interior
/// with a trend and free inertial motion, from the lines of fields/current and none of calibration.
struct UnsteadyDay : SyntheticDay {
  Horizontal trend_m_s_d{};   ///< of the interior, about noon
  Horizontal inertial_m_s{};  ///< of the gravest mode at 00:00
};

/// The truth at instants, without noise; the wind of the three days before D is felt.
inline std::vector<Horizontal> unsteady_truth(const UnsteadyDay& day,
                                              const std::vector<TimeCell>& cells) {
  const Angle latitude = Angle::from_degrees(day.latitude_deg);
  const StressSeries series(synthetic_wind(day), DragLaw::paper_linear);
  const LevelResponses responses =
      level_responses(day.form, day.truth, latitude, day.water_depth_m, day.depth_m);
  // The calibration looks as far back, so that the free motion is the same on both sides.
  const UnsteadyColumn column(
      day.form, day.truth, latitude, day.water_depth_m, day.depth_m,
      HourlyStress::sample(series, synthetic_midnight, stress_history_h, 73));
  const ColumnShape<double> shape = shape_of(day.form, day.truth);
  const double layer_m = moving_layer_m(day.form, day.truth, day.water_depth_m);
  const double k = mode_root(0, shape.bottom * layer_m / shape.eddy_viscosity_m2_s) / layer_m;
  const Horizontal lambda_1_s(shape.eddy_viscosity_m2_s * k * k,
                              coriolis_parameter_rad_s(latitude));
  std::vector<Horizontal> out = synthetic_truth(day, cells);
  std::vector<Horizontal> transient(day.depth_m.size());
  for (std::size_t t = 0; t < cells.size(); ++t) {
    column.transient(cells[t], transient);
    const double hour = hours_between(synthetic_midnight, cells[t].centre());
    for (std::size_t j = 0; j < day.depth_m.size(); ++j) {
      Horizontal& w = out[t * day.depth_m.size() + j];
      w += transient[j] + (hour / 24 - 0.5) * day.trend_m_s_d * responses.interior(j);
      if (day.form == SteadyForm::three_layer) continue;
      const double d = day.depth_m[j];
      const double taper = d > layer_m ? std::exp(-4 * (d - layer_m) / layer_m) : 1.0;
      w += day.inertial_m_s * std::exp(-3600.0 * hour * lambda_1_s) * taper *
           std::cos(k * std::min(d, layer_m));
    }
  }
  return out;
}

/// The day, its noise and its gaps those of `synthetic_input`.
inline CalibrationInput unsteady_input(const UnsteadyDay& day) {
  CalibrationInput input = synthetic_input(day);
  input.is_unsteady = true;
  const std::vector<Horizontal> steady = synthetic_truth(day, input.current.time);
  const std::vector<Horizontal> moving = unsteady_truth(day, input.current.time);
  for (std::size_t i = 0; i < steady.size(); ++i) input.current.value[i] += moving[i] - steady[i];
  return input;
}

/// Estimate minus truth of each parameter, in the terms of its sigma.
inline std::vector<double> estimate_errors(const Calibration& fitted, const UnsteadyDay& day) {
  std::vector<double> errors = estimate_errors(fitted, day.truth);
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Parameter& p = fitted.parameters[i];
    if (p.name == "interior_trend_east") errors[i] = p.value - day.trend_m_s_d.real();
    if (p.name == "interior_trend_north") errors[i] = p.value - day.trend_m_s_d.imag();
    if (p.name == "inertial_east") errors[i] = p.value - day.inertial_m_s.real();
    if (p.name == "inertial_north") errors[i] = p.value - day.inertial_m_s.imag();
  }
  return errors;
}

/// A day drawn within the priors, in either hemisphere.
inline UnsteadyDay random_unsteady_day(SteadyForm form, std::uint64_t seed) {
  UnsteadyDay day;
  day.form = form;
  day.seed = seed;
  Rng rng(seed, "tests/unsteady_truth");
  day.truth.interior_east_m_s = rng.uniform(-0.4, 0.4);
  day.truth.interior_north_m_s = rng.uniform(-0.4, 0.4);
  day.truth.eddy_viscosity_m2_s = 0.03 * std::exp(0.7 * rng.normal());
  day.truth.bottom_friction_m_s = 5e-4 * std::exp(0.5 * rng.normal());
  day.truth.base_friction_m_s = 1e-4 * std::exp(0.5 * rng.normal());
  day.truth.mixed_layer_depth_m = 25 * std::exp(0.3 * rng.normal());
  day.truth.stress_factor = std::exp(0.2 * rng.normal());
  day.latitude_deg = (seed % 2 == 0 ? 1 : -1) * rng.uniform(25, 65);
  day.trend_m_s_d = {0.05 * rng.normal(), 0.05 * rng.normal()};
  day.inertial_m_s = {0.15 * rng.normal(), 0.15 * rng.normal()};
  if (form == SteadyForm::mixed_layer) day.water_depth_m = 120;
  if (form == SteadyForm::three_layer) {
    day.water_depth_m = 420;
    day.depth_m = {0.5, 3, 6, 10, 15, 22, 30, 45, 70, 120, 250, 380, 400, 410, 415, 418};
  }
  return day;
}

}  // namespace slackwater::calibration

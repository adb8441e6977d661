#pragma once
#include <cmath>
#include <vector>

#include "calibration/solve/calibration.h"
#include "fields/base/numbers/random.h"
#include "fields/current/stress_series.h"

namespace slackwater::calibration {

/// A day whose truth is known: the forward model with these parameters, a turning wind, white
/// noise, gaps.
struct SyntheticDay {
  SteadyForm form = SteadyForm::finite_depth;
  SteadyParameters truth;
  double latitude_deg = 54;
  double water_depth_m = 45;
  std::vector<double> depth_m{0.5, 2, 4, 7, 10, 14, 19, 25, 31, 37, 42};
  double noise_m_s = 0.02;
  double missing_share = 0;
  bool is_mean = false;
  double wind_speed_m_s = 11;
  std::uint64_t seed = 1;
};

inline constexpr UtcTime synthetic_midnight = UtcDay(std::chrono::year(2024) / 3 / 1);

inline VectorColumn synthetic_wind(const SyntheticDay& day) {
  VectorColumn wind;
  for (int h = -80; h <= 74; ++h) {
    wind.time.push_back(TimeCell::instant(add_hours(synthetic_midnight, h)));
    wind.value.push_back(
        vector_from_direction(day.wind_speed_m_s * (1 + 0.4 * std::sin(0.4 * h)), 230.0 + 6.0 * h));
    wind.status.push_back(SampleStatus::ok);
    wind.source.push_back(DataStatus::analysis);
  }
  return wind;
}

/// The truth at instants or means, without noise.
inline std::vector<Horizontal> synthetic_truth(const SyntheticDay& day,
                                               const std::vector<TimeCell>& cells) {
  const StressSeries series(synthetic_wind(day), DragLaw::paper_linear);
  const LevelResponses responses = level_responses(
      day.form, day.truth, Angle::from_degrees(day.latitude_deg), day.water_depth_m, day.depth_m);
  std::vector<Horizontal> out;
  for (const TimeCell& cell : cells) {
    for (std::size_t k = 0; k < responses.levels(); ++k) {
      out.push_back(day.truth.interior_m_s() * responses.interior(k) +
                    *series.over(cell) * responses.stress(k));
    }
  }
  return out;
}

inline CalibrationInput synthetic_input(const SyntheticDay& day) {
  CalibrationInput input;
  input.latitude = Angle::from_degrees(day.latitude_deg);
  input.water_depth_m = day.water_depth_m;
  input.form = day.form;
  input.wind = synthetic_wind(day);
  VectorColumn& current = input.current;
  current.vertical = VerticalKind::depth_m;
  current.levels_m = day.depth_m;
  for (int h = 0; h < (day.is_mean ? 24 : 25); ++h) {
    const UtcTime from = add_hours(synthetic_midnight, h);
    current.time.push_back(day.is_mean ? TimeCell{from, add_hours(from, 1)}
                                       : TimeCell::instant(from));
    current.source.push_back(DataStatus::analysis);
  }
  current.value = synthetic_truth(day, current.time);
  Rng rng(day.seed, "tests/synthetic_day");
  for (Horizontal& value : current.value) {
    value += Horizontal{day.noise_m_s * rng.normal(), day.noise_m_s * rng.normal()};
    const bool is_missing = rng.uniform() < day.missing_share;
    current.status.push_back(is_missing ? SampleStatus::missing : SampleStatus::ok);
    if (is_missing) value = {99, 99};
  }
  return input;
}

/// Estimate minus truth of each parameter, in the terms of its sigma.
inline std::vector<double> estimate_errors(const Calibration& fitted,
                                           const SteadyParameters& truth) {
  std::vector<double> errors;
  for (const Parameter& p : fitted.parameters) {
    double expected = 0;
    if (p.name == "interior_east") expected = truth.interior_east_m_s;
    if (p.name == "interior_north") expected = truth.interior_north_m_s;
    if (p.name == "eddy_viscosity") expected = truth.eddy_viscosity_m2_s;
    if (p.name == "bottom_friction") expected = truth.bottom_friction_m_s;
    if (p.name == "base_friction") expected = truth.base_friction_m_s;
    if (p.name == "mixed_layer_depth") expected = truth.mixed_layer_depth_m;
    if (p.name == "bottom_eddy_viscosity") expected = truth.bottom_eddy_viscosity_m2_s;
    if (p.name == "stress_factor") expected = truth.stress_factor;
    errors.push_back(p.is_logarithmic ? std::log(p.value / expected) : p.value - expected);
  }
  return errors;
}

}  // namespace slackwater::calibration

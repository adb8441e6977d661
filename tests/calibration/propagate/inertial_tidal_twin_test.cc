// A day of tide, turning wind and inertial motion in 35 m of water at 48.9 N, made by integrating
// the equations on a grid: what the column with memory and tide knows of D+1 that the steady one
// does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/propagate/propagate.h"
#include "fields/base/random.h"
#include "fields/current/coriolis.h"
#include "fields/current/stress_series.h"
#include "fields/current/tidal_shape.h"
#include "tests/support/crank_nicolson_column.h"

namespace slackwater::calibration {
namespace {

constexpr double rho = constants::sea_water_density_kg_m3;
constexpr double m2_rad_s = 1.405189e-4;
constexpr double depth_m = 35;
constexpr double viscosity = 0.03;
constexpr double friction = 1e-3;
const Angle latitude = Angle::from_degrees(48.9);
const UtcTime day_start = parse_utc("2024-03-01T00:00:00Z");
const UtcTime day_end = add_hours(day_start, 24);
const std::vector<double> levels{0.5, 2, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 33.5};

/// 12 m/s that turns by 90 degrees within six hours.
VectorColumn turning_wind(double turn_from_h) {
  VectorColumn wind;
  for (int h = -120; h <= 54; ++h) {
    const double share = std::clamp((h - turn_from_h) / 6.0, 0.0, 1.0);
    wind.time.push_back(TimeCell::instant(add_hours(day_start, h)));
    wind.value.push_back(vector_from_direction(12, 225 + 90 * share));
    wind.status.push_back(SampleStatus::ok);
    wind.source.push_back(DataStatus::analysis);
  }
  return wind;
}

/// Pressure gradient of one sense of the M2 current whose mean over the column is `mean`.
Horizontal acceleration(Horizontal mean, double speed_rad_s) {
  const double turning = coriolis_parameter_rad_s(latitude) + speed_rad_s;
  const auto column =
      FiniteDepthColumn<double>::linear_bottom_stress(viscosity, friction, turning, rho, depth_m);
  return mean * Horizontal(0, turning) / to_horizontal(column.depth_mean().interior);
}

/// Currents at the levels at every hour 0..48 of D and D+1: five days of spin-up, second-order
/// scheme. The mean over the column of the M2 ellipse has half axes 0.5 and 0.15 m/s, turning
/// counter-clockwise; a steady slope drives 0.11 m/s.
std::vector<std::vector<Horizontal>> truth(const VectorColumn& wind) {
  const StressSeries stress(wind, DragLaw::paper_linear);
  const double f = coriolis_parameter_rad_s(latitude);
  const Horizontal slope = Horizontal(0, f) * Horizontal(0.1, -0.05);
  const Horizontal plus = acceleration(std::polar(0.325, 0.6), m2_rad_s);
  const Horizontal minus = acceleration(std::polar(0.175, 1.1), -m2_rad_s);
  constexpr double step_s = 60;
  CrankNicolsonColumn column(depth_m, 140, viscosity, friction, f, step_s);
  std::vector<std::vector<Horizontal>> hours;
  for (int minute = -120 * 60; minute <= 48 * 60; ++minute) {
    if (minute >= 0 && minute % 60 == 0) {
      hours.emplace_back();
      for (const double d : levels) hours.back().push_back(column.at_depth(d));
    }
    const double t_s = 60 * (minute + 0.5);
    column.step(
        *stress.at(add_hours(day_start, t_s / 3600)) / rho,
        slope + plus * std::polar(1.0, m2_rad_s * t_s) + minus * std::polar(1.0, -m2_rad_s * t_s));
  }
  return hours;
}

CalibrationInput observed(const std::vector<std::vector<Horizontal>>& hours,
                          const VectorColumn& wind) {
  CalibrationInput input;
  input.latitude = latitude;
  input.water_depth_m = depth_m;
  input.form = SteadyForm::finite_depth;
  input.wind = wind;
  input.current.vertical = VerticalKind::depth_m;
  input.current.levels_m = levels;
  Rng rng(1, "tests/inertial_tidal_twin");
  for (int h = 0; h <= 24; ++h) {
    input.current.time.push_back(TimeCell::instant(add_hours(day_start, h)));
    input.current.source.push_back(DataStatus::analysis);
    for (const Horizontal& w : hours[static_cast<std::size_t>(h)]) {
      const double east = 0.02 * rng.normal();
      input.current.value.push_back(w + Horizontal(east, 0.02 * rng.normal()));
      input.current.status.push_back(SampleStatus::ok);
    }
  }
  return input;
}

std::vector<UtcTime> next_day() {
  std::vector<UtcTime> times;
  for (int h = 1; h <= 24; ++h) times.push_back(add_hours(day_end, h));
  return times;
}

double rmse(const std::vector<Horizontal>& forecast,
            const std::vector<std::vector<Horizontal>>& hours) {
  double squares = 0;
  for (std::size_t i = 0; i < forecast.size(); ++i)
    squares += std::norm(forecast[i] - hours[25 + i / levels.size()][i % levels.size()]);
  return std::sqrt(squares / static_cast<double>(forecast.size()));
}

/// Interior and steady answer to the wind of D+1, nothing else.
std::vector<Horizontal> steady_forecast(const Calibration& fitted, const VectorColumn& wind) {
  const StressSeries series(wind, fitted.drag_law);
  std::vector<Horizontal> stress;
  for (const UtcTime time : next_day()) stress.push_back(*series.at(time));
  std::vector<Horizontal> out(stress.size() * levels.size());
  evaluate_steady(
      level_responses(fitted.form, steady_parameters(fitted), latitude, depth_m, levels),
      steady_parameters(fitted).interior_m_s(), stress, out);
  return out;
}

struct Scores {
  double steady = 0;       ///< interior and steady answer to the wind
  double steady_tide = 0;  ///< steady column and M2 fitted, carried on with its memory
  double unsteady_tide = 0;
};

Scores scores(double turn_from_h) {
  const VectorColumn wind = turning_wind(turn_from_h);
  const auto hours = truth(wind);
  CalibrationInput input = observed(hours, wind);
  Scores out;
  out.steady = rmse(steady_forecast(calibrate_day(input), wind), hours);
  input.tide = {{"M2", m2_rad_s}};
  const auto carried = [&] {
    const std::vector<Calibration> forms{calibrate_day(input)};
    return rmse(propagate(forms, next_day(), wind, day_end, {}, Spread{}, 1).mean_m_s, hours);
  };
  out.steady_tide = carried();
  input.is_unsteady = true;
  out.unsteady_tide = carried();
  std::printf("turn from %+.0f h: steady %.4f, steady + M2 + memory %.4f, unsteady + M2 %.4f m/s\n",
              turn_from_h, out.steady, out.steady_tide, out.unsteady_tide);
  return out;
}

TEST(InertialTidalTwin, UnsteadyWithTideHasAtMostSixTenthsOfTheSteadyErrorOnTheNextDay) {
  for (const double turn_from_h : {6.0, 15.0, 30.0}) {  // on D, late on D, on D+1
    const Scores s = scores(turn_from_h);
    EXPECT_LE(s.unsteady_tide, 0.6 * s.steady) << turn_from_h;
    // Not the tide alone: the wind's memory is worth something beside the same tide.
    EXPECT_LT(s.unsteady_tide, s.steady_tide) << turn_from_h;
    EXPECT_LT(s.unsteady_tide, 0.03) << turn_from_h;
  }
}

TEST(InertialTidalTwin, TheEllipseComesBackInBothSenses) {
  const VectorColumn wind = turning_wind(6);
  CalibrationInput input = observed(truth(wind), wind);
  input.tide = {{"M2", m2_rad_s}};
  input.is_unsteady = true;
  const Calibration fitted = calibrate_day(input);
  const auto phasor = [&](const std::string& sense) {
    return Horizontal(find_parameter(fitted, "M2_" + sense + "_east")->value,
                      find_parameter(fitted, "M2_" + sense + "_north")->value);
  };
  EXPECT_LT(std::abs(phasor("counter_clockwise") - std::polar(0.325, 0.6)), 0.02);
  EXPECT_LT(std::abs(phasor("clockwise") - std::polar(0.175, 1.1)), 0.05);
}

}  // namespace
}  // namespace slackwater::calibration

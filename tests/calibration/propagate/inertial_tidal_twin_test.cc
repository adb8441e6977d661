// A month of tide, then a day of turning wind and inertial motion in 35 m of water at 48.9 N, made
// by integrating the equations on a grid: what the daily job's sequence (harmonic tide, column with
// memory) knows of D+1 that the steady column does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "calibration/day/column/column_calibration.h"
#include "calibration/propagate/propagate.h"
#include "fields/base/numbers/random.h"
#include "fields/current/coriolis.h"
#include "fields/current/finite_depth.h"
#include "fields/current/stress_series.h"
#include "fields/record/slice.h"
#include "tests/support/crank_nicolson_column.h"

namespace slackwater::calibration::inertial_tidal_twin_test {
namespace {

constexpr double rho = constants::sea_water_density_kg_m3;
constexpr double m2_rad_s = 1.405189e-4;
constexpr double depth_m = 35;
constexpr double viscosity = 0.03;
constexpr double friction = 1e-3;
const Angle latitude = Angle::from_degrees(48.9);
/// Of the record, before D: N2 is told from M2.
constexpr int days_before = 29;
const UtcTime day_start = parse_utc("2024-03-01T00:00:00Z");
const UtcTime day_end = add_hours(day_start, 24);
const std::vector<double> levels{0.5, 2, 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 33.5};

/// 12 m/s that turns by 90 degrees within six hours.
VectorColumn turning_wind(double turn_from_h) {
  VectorColumn wind;
  for (int h = -24 * days_before - 120; h <= 54; ++h) {
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

/// Currents at the levels at every hour of the record, D and D+1: five days of spin-up, a
/// second-order scheme. The mean over the column of the M2 ellipse has half axes 0.5 and 0.15 m/s,
/// turning counter-clockwise; a steady slope drives 0.11 m/s.
std::vector<std::vector<Horizontal>> truth(const VectorColumn& wind) {
  const StressSeries stress(wind, DragLaw::paper_linear);
  const double f = coriolis_parameter_rad_s(latitude);
  const Horizontal slope = Horizontal(0, f) * Horizontal(0.1, -0.05);
  const Horizontal plus = acceleration(std::polar(0.325, 0.6), m2_rad_s);
  const Horizontal minus = acceleration(std::polar(0.175, 1.1), -m2_rad_s);
  constexpr int step_min = 2;
  constexpr double step_s = 60 * step_min;
  CrankNicolsonColumn column(depth_m, 140, viscosity, friction, f, step_s);
  std::vector<std::vector<Horizontal>> hours;
  for (int minute = (-24 * days_before - 120) * 60; minute <= 48 * 60; minute += step_min) {
    if (minute >= -24 * days_before * 60 && minute % 60 == 0) {
      hours.emplace_back();
      for (const double d : levels) hours.back().push_back(column.at_depth(d));
    }
    const double t_s = 60 * minute + 0.5 * step_s;
    column.step(
        *stress.at(add_hours(day_start, t_s / 3600)) / rho,
        slope + plus * std::polar(1.0, m2_rad_s * t_s) + minus * std::polar(1.0, -m2_rad_s * t_s));
  }
  return hours;
}

/// The record up to the end of D, with 2 cm/s of noise.
VectorColumn observed(const std::vector<std::vector<Horizontal>>& hours) {
  VectorColumn current;
  current.vertical = VerticalKind::depth_m;
  current.levels_m = levels;
  Rng rng(1, "tests/inertial_tidal_twin");
  for (int h = -24 * days_before; h <= 24; ++h) {
    current.time.push_back(TimeCell::instant(add_hours(day_start, h)));
    current.source.push_back(DataStatus::analysis);
    for (const Horizontal& w : hours[static_cast<std::size_t>(h + 24 * days_before)]) {
      const double east = 0.02 * rng.normal();
      current.value.push_back(w + Horizontal(east, 0.02 * rng.normal()));
      current.status.push_back(SampleStatus::ok);
    }
  }
  return current;
}

/// D alone, ready to be fitted steady.
CalibrationInput steady_day(const VectorColumn& record, const VectorColumn& wind,
                            const FittedTide& tide) {
  CalibrationInput input;
  input.latitude = latitude;
  input.water_depth_m = depth_m;
  input.form = SteadyForm::finite_depth;
  input.wind = wind;
  input.current = slice(record, day_start, day_end);
  for (std::size_t t = 0; t < input.current.times(); ++t)
    for (std::size_t k = 0; k < levels.size(); ++k)
      input.current.value[input.current.offset(t, k)] -= tide.at(k, input.current.time[t]);
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
    squares += std::norm(forecast[i] -
                         hours[24 * days_before + 25 + i / levels.size()][i % levels.size()]);
  return std::sqrt(squares / static_cast<double>(forecast.size()));
}

/// Interior and steady answer to the wind of D+1, nothing else.
std::vector<Horizontal> steady_forecast(const Calibration& fitted, const VectorColumn& wind) {
  const StressSeries series(wind, fitted.drag_law);
  const LevelResponses responses =
      level_responses(fitted.form, steady_parameters(fitted), latitude, depth_m, levels);
  std::vector<Horizontal> out;
  for (const UtcTime time : next_day()) {
    const Horizontal stress = *series.at(time);
    for (std::size_t k = 0; k < levels.size(); ++k)
      out.push_back(steady_parameters(fitted).interior_m_s() * responses.interior(k) +
                    stress * responses.stress(k));
  }
  return out;
}

/// Carried on, with the tide back in.
std::vector<Horizontal> forecast_of(const std::vector<Calibration>& forms, const FittedTide& tide,
                                    const VectorColumn& wind) {
  const std::vector<UtcTime> times = next_day();
  std::vector<Horizontal> out = propagate(forms, times, wind, day_end, {}, Spread{}, 1).mean_m_s;
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] += tide.at(i % levels.size(), TimeCell::instant(times[i / levels.size()]));
  return out;
}

struct Scores {
  double steady = 0;       ///< interior and steady answer to the wind
  double steady_tide = 0;  ///< the same beside the tide, carried on with its memory
  double unsteady_tide = 0;
};

Scores scores(double turn_from_h) {
  const VectorColumn wind = turning_wind(turn_from_h);
  const auto hours = truth(wind);
  const VectorColumn record = observed(hours);
  const FittedTide tide = fit_column_tide(record, latitude);
  Scores out;
  out.steady = rmse(steady_forecast(calibrate_day(steady_day(record, wind, {})), wind), hours);
  out.steady_tide =
      rmse(forecast_of({calibrate_day(steady_day(record, wind, tide))}, tide, wind), hours);
  const ColumnCalibration column =
      calibrate_column(record, tide, UtcDay(day_of(day_start)), latitude, depth_m, wind);
  out.unsteady_tide = rmse(forecast_of(column.forms, tide, wind), hours);
  std::printf("turn from %+.0f h: steady %.4f, tide + steady + memory %.4f, daily job %.4f m/s\n",
              turn_from_h, out.steady, out.steady_tide, out.unsteady_tide);
  return out;
}

TEST(InertialTidalTwin, UnsteadyWithTideHasAtMostSixTenthsOfTheSteadyErrorOnTheNextDay) {
  for (const double turn_from_h : {6.0, 15.0, 30.0}) {  // on D, late on D, on D+1
    const Scores s = scores(turn_from_h);
    EXPECT_LE(s.unsteady_tide, 0.6 * s.steady) << turn_from_h;
    // Not the tide alone: the wind's memory is worth something beside the same tide.
    EXPECT_LT(s.unsteady_tide, s.steady_tide) << turn_from_h;
    // A wind that turns on D+1 alone has left D nothing to tell the forms apart by.
    EXPECT_LT(s.unsteady_tide, turn_from_h < 24 ? 0.03 : 0.07) << turn_from_h;
  }
}

TEST(InertialTidalTwin, TheEllipseOfEveryLevelIsThatOfTheColumnInBothSenses) {
  const VectorColumn record = observed(truth(turning_wind(6)));
  const FittedTide tide = fit_column_tide(record, latitude);
  for (const double speed_rad_s : {m2_rad_s, -m2_rad_s}) {
    const auto column = FiniteDepthColumn<double>::linear_bottom_stress(
        viscosity, friction, coriolis_parameter_rad_s(latitude) + speed_rad_s, rho, depth_m);
    const Horizontal mean = speed_rad_s > 0 ? std::polar(0.325, 0.6) : std::polar(0.175, 1.1);
    for (std::size_t k = 0; k < levels.size(); ++k) {
      const auto term = std::find_if(tide.levels[k].terms.begin(), tide.levels[k].terms.end(),
                                     [](const TideTerm& t) { return t.name == "M2"; });
      ASSERT_NE(term, tide.levels[k].terms.end());
      const Horizontal exact =
          mean * to_horizontal(column.interior_at_depth(levels[k])) /
          to_horizontal(column.depth_mean().interior) *
          std::polar(1.0, speed_rad_s * seconds_between(day_start, tide.levels[k].reference));
      EXPECT_LT(std::abs((speed_rad_s > 0 ? term->counter_clockwise : term->clockwise) - exact),
                0.02)
          << levels[k];
    }
  }
}

}  // namespace
}  // namespace slackwater::calibration::inertial_tidal_twin_test

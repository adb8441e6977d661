#include "calibration/propagate/propagate.h"

#include <gtest/gtest.h>

#include "calibration/propagate/inertial_memory.h"
#include "fields/current/coriolis.h"
#include "tests/calibration/solve/synthetic_day.h"

namespace slackwater::calibration {
namespace {

SyntheticDay usual_day() {
  SyntheticDay day;
  day.truth.interior_east_m_s = 0.2;
  day.truth.interior_north_m_s = -0.1;
  return day;
}

const UtcTime end_of_day = add_hours(synthetic_midnight, 24);

std::vector<UtcTime> hourly(int from, int to) {
  std::vector<UtcTime> times;
  for (int h = from; h <= to; ++h) times.push_back(add_hours(end_of_day, h));
  return times;
}

/// The day under a wind that never changes: no transient.
CalibrationInput steady_wind_input(const SyntheticDay& day, Horizontal wind_m_s = {8, 3}) {
  CalibrationInput input = synthetic_input(day);
  const StressSeries veering(*input.wind, input.drag_law);
  std::fill(input.wind->value.begin(), input.wind->value.end(), wind_m_s);
  const StressSeries steady(*input.wind, input.drag_law);
  const LevelResponses responses =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    const TimeCell& cell = input.current.time[t];
    for (std::size_t k = 0; k < day.depth_m.size(); ++k) {
      input.current.value[input.current.offset(t, k)] +=
          (*steady.over(cell) - *veering.over(cell)) * responses.stress(k);
    }
  }
  return input;
}

/// No belief in any motion: constant misfit and last hours alone.
PropagationSettings without_oscillation() {
  PropagationSettings settings;
  settings.memory_prior.oscillation_m_s = settings.memory_prior.slab_share = 1e-9;
  return settings;
}

TEST(Propagate, WithAConstantWindAndNoResidualItIsTheSteadyForecast) {
  for (const bool is_mean : {false, true}) {
    SyntheticDay day = usual_day();
    day.is_mean = is_mean;
    const CalibrationInput input = steady_wind_input(day);
    Calibration fitted = calibrate_day(input);
    std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
    const auto times = hourly(0, 48);
    const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
    const LevelResponses responses = level_responses(
        fitted.form, steady_parameters(fitted), fitted.latitude, fitted.water_depth_m, day.depth_m);
    const std::vector<Horizontal> stress(times.size(), wind_stress_pa({8, 3}, fitted.drag_law));
    std::vector<Horizontal> steady(forecast.mean_m_s.size());
    evaluate_steady(responses, steady_parameters(fitted).interior_m_s(), stress, steady);
    EXPECT_EQ(forecast.mean_m_s, steady);
  }
}

TEST(Propagate, ForecastsTheSteadyOceanItWasFittedTo) {
  const SyntheticDay day = usual_day();
  const CalibrationInput input = steady_wind_input(day);
  const Calibration fitted = calibrate_day(input);
  const auto times = hourly(0, 48);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  const LevelResponses responses =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  const Horizontal stress = wind_stress_pa({8, 3}, fitted.drag_law);
  for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
    const std::size_t k = i % day.depth_m.size();
    const Horizontal truth =
        day.truth.interior_m_s() * responses.interior(k) + stress * responses.stress(k);
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - truth), 4 * forecast.sigma_m_s[i]);
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - truth),
              0.06);  // noise of three values in the last hours, decaying
  }
  EXPECT_EQ(forecast.wind_missing, 0u);
}

TEST(Propagate, AnInertialOscillationOnASteadyColumnGoesOnTurning) {
  // In both hemispheres, from hourly means and from values every six hours; the prior keeps 2 %.
  for (const double latitude : {54.0, -33.0}) {
    for (const bool is_mean : {true, false}) {
      SyntheticDay day = usual_day();
      day.latitude_deg = latitude;
      day.noise_m_s = 0;
      day.is_mean = is_mean;
      const CalibrationInput input = steady_wind_input(day);
      Calibration fitted = calibrate_day(input);
      const Horizontal lambda(inertial_damping_per_h(fitted, 48),
                              3600.0 * coriolis_parameter_rad_s(fitted.latitude));
      const InertialBasis basis(end_of_day, lambda);
      const Horizontal at_end(0.12, -0.2);
      for (std::size_t t = 0; t < fitted.residual.times(); ++t) {
        for (std::size_t k = 0; k < fitted.residual.levels(); ++k) {
          const std::size_t at = fitted.residual.offset(t, k);
          fitted.residual.value[at] = at_end * basis.over(fitted.residual.time[t])(2);
          if (!is_mean && t % 6 != 0) fitted.residual.status[at] = SampleStatus::missing;
        }
      }
      const auto times = hourly(0, 36);
      const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
      for (std::size_t t = 0; t < times.size(); ++t) {
        const Horizontal truth = at_end * std::exp(-lambda * static_cast<double>(t));
        EXPECT_LT(std::abs(forecast.carried_m_s[t * day.depth_m.size() + 4] - truth), 0.008)
            << latitude << ' ' << is_mean << ' ' << t;
      }
    }
  }
}

TEST(Propagate, AWindThatTurnsAfterTheDayMakesNewInertialMotion) {
  // The steady forecast jumps to its new place; the sea circles about it and comes to rest there.
  SyntheticDay day = usual_day();
  day.noise_m_s = 0;
  day.truth.bottom_friction_m_s = 2e-3;
  CalibrationInput input = steady_wind_input(day);
  const Calibration fitted = calibrate_day(input);
  for (std::size_t t = 0; t < input.wind->times(); ++t) {
    if (input.wind->time[t].start > end_of_day) input.wind->value[t] = {-8, 6};
  }
  const std::vector<UtcTime> times{add_hours(end_of_day, 1.5), add_hours(end_of_day, 48)};
  const std::vector<double> depth{2.0};
  const Propagated forecast = propagate(fitted, times, depth, input.wind, end_of_day);
  const Horizontal response = level_responses(fitted.form, steady_parameters(fitted),
                                              fitted.latitude, fitted.water_depth_m, depth)
                                  .stress(0);
  const Horizontal before = response * wind_stress_pa({8, 3}, fitted.drag_law);
  const Horizontal after = response * wind_stress_pa({-8, 6}, fitted.drag_law);
  EXPECT_GT(std::abs(forecast.wind_driven_m_s[0] - after), 0.25 * std::abs(after - before));
  EXPECT_LT(std::abs(forecast.wind_driven_m_s[1] - after), 0.1 * std::abs(after - before));
}

TEST(Propagate, TurnsWithTheAxes) {
  for (const SteadyForm form : {SteadyForm::finite_depth, SteadyForm::three_layer}) {
    SyntheticDay day = usual_day();
    day.form = form;
    day.water_depth_m = form == SteadyForm::finite_depth ? 45 : 2000;
    const CalibrationInput input = synthetic_input(day);
    Calibration fitted = calibrate_day(input);
    const auto times = hourly(0, 30);
    const Propagated a = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
    const Horizontal turn = std::exp(Horizontal(0, 2.1));
    VectorColumn wind = *input.wind;
    for (Horizontal& w : wind.value) w *= turn;
    for (Horizontal& r : fitted.residual.value) r *= turn;
    const Horizontal interior = turn * steady_parameters(fitted).interior_m_s();
    fitted.parameters[0].value = interior.real();
    fitted.parameters[1].value = interior.imag();
    const Propagated b = propagate(fitted, times, day.depth_m, wind, end_of_day);
    for (std::size_t i = 0; i < a.mean_m_s.size(); ++i)
      EXPECT_LT(std::abs(turn * a.mean_m_s[i] - b.mean_m_s[i]), 1e-12);
  }
}

TEST(Propagate, OneDailyMeanIsCarriedAsAConstant) {
  SyntheticDay day = usual_day();
  const CalibrationInput input = steady_wind_input(day);
  Calibration fitted = calibrate_day(input);
  VectorColumn& residual = fitted.residual;
  const std::size_t levels = residual.levels();
  residual.time = {{synthetic_midnight, end_of_day}};
  residual.source.resize(1);
  residual.value.assign(levels, {0.06, -0.02});
  residual.status.assign(levels, SampleStatus::ok);
  const auto times = hourly(0, 48);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  for (std::size_t t = 0; t < times.size(); ++t) {
    const double left = std::exp(-static_cast<double>(t) / 120.0);
    for (std::size_t k = 0; k < levels; ++k) {
      EXPECT_LT(std::abs(forecast.carried_m_s[t * levels + k] - left * Horizontal(0.06, -0.02)),
                1e-15);
      // A day that cannot tell a motion keeps the whole misfit in its spread.
      EXPECT_GE(forecast.sigma_m_s[t * levels + k], std::hypot(0.06, 0.02) / std::sqrt(2.0));
    }
  }
}

TEST(Propagate, AtTheEndOfTheDayTheRecentResidualIsWholeAndThenDecays) {
  const SyntheticDay day = usual_day();
  Calibration fitted = calibrate_day(synthetic_input(day));
  // A residual of known size at one level: 0.1 east in the last three hours, nothing before.
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
  for (const std::size_t t : {22u, 23u, 24u})
    fitted.residual.value[fitted.residual.offset(t, 3)] = {0.1, 0};
  const std::vector<double> depths{7.0, 8.5,
                                   4.0};  // the level itself, halfway to the next, the level above
  const auto times = hourly(0, 24);
  const Propagated forecast =
      propagate(fitted, times, depths, std::nullopt, end_of_day, without_oscillation());
  for (std::size_t t = 0; t < times.size(); ++t) {
    // Three of 25 values make the mean, which decays more slowly.
    const double mean = 0.3 / 25;
    const auto lead_h = static_cast<double>(t);
    const double left = mean * std::exp(-lead_h / 120) + (0.1 - mean) * std::exp(-lead_h / 12);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t] - left), 1e-14);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t + 1] - 0.5 * left), 1e-14);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t + 2]), 1e-15);
  }
}

TEST(Propagate, TheMeanMisfitOfADepthIsCarriedLongerThanThatOfTheLastHours) {
  Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{0.05, 0});
  const std::vector<double> depths{10};
  const Propagated forecast = propagate(fitted, hourly(0, 24), depths, std::nullopt, end_of_day);
  EXPECT_NEAR(forecast.carried_m_s.front().real(), 0.05, 1e-15);
  EXPECT_NEAR(forecast.carried_m_s.back().real(), 0.05 * std::exp(-24.0 / 120.0), 1e-15);
}

TEST(Propagate, AnOldResidualIsAlreadyDecayedAtTheEndOfTheDay) {
  Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
  for (std::size_t t = 0; t < 25; ++t) {
    for (std::size_t k = 0; k < fitted.residual.levels(); ++k) {
      const std::size_t at = fitted.residual.offset(t, k);
      if (t > 18) fitted.residual.status[at] = SampleStatus::missing;
      if (t > 15 && t <= 18) fitted.residual.value[at] = {0, 0.1};
    }
  }
  const std::vector<double> depths{10};
  const Propagated forecast =
      propagate(fitted, hourly(0, 0), depths, std::nullopt, end_of_day, without_oscillation());
  const double mean = 0.3 / 19;
  EXPECT_NEAR(forecast.carried_m_s.front().imag(), mean + (0.1 - mean) * std::exp(-6.0 / 12.0),
              1e-14);
}

TEST(Propagate, SigmaIsNotBelowTheMisfitAndGrowsWithLead) {
  const SyntheticDay day = usual_day();
  const CalibrationInput input = steady_wind_input(day);  // the parameters' share is constant
  const Calibration fitted = calibrate_day(input);
  const auto times = hourly(0, 48);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  for (std::size_t k = 0; k < day.depth_m.size(); ++k) {
    // The memory explains three numbers' worth of 25 values of white noise.
    EXPECT_GE(forecast.sigma_m_s[k], 0.85 * fitted.misfit[k].rms_m_s / std::sqrt(2.0));
    for (std::size_t t = 1; t < times.size(); ++t) {
      EXPECT_GT(forecast.sigma_m_s[t * day.depth_m.size() + k],
                forecast.sigma_m_s[(t - 1) * day.depth_m.size() + k]);
    }
  }
}

TEST(Propagate, ParameterVarianceAgreesWithASampleOfTheParameters) {
  // Independent oracle: the spread of the forward model over draws from the posterior (diagonal
  // case).
  const SyntheticDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  Calibration fitted = calibrate_day(input);
  fitted.covariance.assign(25, 0.0);
  const std::vector<double> sigma{0.01, 0.02, 0.05, 0.05, 0.03};
  for (std::size_t i = 0; i < 5; ++i) fitted.covariance[i * 6] = sigma[i] * sigma[i];
  // One value without misfit: nothing to remember, and the doubt is that of the parameters alone.
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
  std::fill(fitted.residual.status.begin() + static_cast<std::ptrdiff_t>(fitted.residual.levels()),
            fitted.residual.status.end(), SampleStatus::missing);
  std::fill(input.wind->value.begin(), input.wind->value.end(), Horizontal(8, 3));
  const auto times = hourly(0, 0);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);

  Rng rng(13, "tests/posterior");
  const StressSeries series(*input.wind, fitted.drag_law);
  const std::vector<Horizontal> stress{*series.at(end_of_day)};
  const SteadyParameters best = steady_parameters(fitted);
  constexpr int draws = 4000;
  std::vector<double> squares(day.depth_m.size());
  std::vector<Horizontal> sums(day.depth_m.size());
  for (int i = 0; i < draws; ++i) {
    SteadyParameters p = best;
    p.interior_east_m_s += sigma[0] * rng.normal();
    p.interior_north_m_s += sigma[1] * rng.normal();
    p.eddy_viscosity_m2_s *= std::exp(sigma[2] * rng.normal());
    p.bottom_friction_m_s *= std::exp(sigma[3] * rng.normal());
    p.stress_factor *= std::exp(sigma[4] * rng.normal());
    std::vector<Horizontal> w(day.depth_m.size());
    evaluate_steady(
        level_responses(fitted.form, p, fitted.latitude, fitted.water_depth_m, day.depth_m),
        p.interior_m_s(), stress, w);
    for (std::size_t k = 0; k < w.size(); ++k) {
      sums[k] += w[k];
      squares[k] += std::norm(w[k]);
    }
  }
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const double variance = squares[k] / draws - std::norm(sums[k] / static_cast<double>(draws));
    // 4000 draws: 1.6 % of a standard deviation; curvature of the logarithms adds about as much.
    EXPECT_NEAR(forecast.sigma_m_s[k] / std::sqrt(0.5 * variance), 1.0, 0.05);
  }
}

TEST(Propagate, WhereTheWindIsMissingTheInteriorIsLeftAndItIsCounted) {
  const SyntheticDay day = usual_day();
  CalibrationInput input = steady_wind_input(day);
  const Calibration fitted = calibrate_day(input);
  for (std::size_t t = 0; t < input.wind->times(); ++t) {
    if (input.wind->time[t].start > add_hours(end_of_day, 6))
      input.wind->status[t] = SampleStatus::missing;
  }
  const auto times = hourly(0, 24);  // wind to 6 h, held to 9 h, missing for the last 15
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  EXPECT_EQ(forecast.wind_missing, 15u);
  EXPECT_TRUE(forecast.has_wind[9]);
  EXPECT_FALSE(forecast.has_wind[10]);
  const std::size_t levels = day.depth_m.size();
  const SteadyParameters p = steady_parameters(fitted);
  const LevelResponses responses =
      level_responses(fitted.form, p, fitted.latitude, fitted.water_depth_m, day.depth_m);
  for (std::size_t k = 0; k < levels; ++k) {
    const std::size_t at = 10 * levels + k;
    EXPECT_EQ(forecast.wind_driven_m_s[at], Horizontal(0, 0));
    EXPECT_LT(std::abs(forecast.mean_m_s[at] - forecast.carried_m_s[at] -
                       forecast.wind_driven_m_s[at] - p.interior_m_s() * responses.interior(k)),
              1e-14);
  }
  EXPECT_GT(forecast.sigma_m_s[10 * levels], 1.2 * forecast.sigma_m_s[9 * levels]);
  EXPECT_EQ(propagate(fitted, times, day.depth_m, std::nullopt, end_of_day).wind_missing,
            times.size());
}

TEST(Propagate, ADayFittedWithoutWindIsNotGivenTheWindTwice) {
  const SyntheticDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  const std::optional<VectorColumn> wind = input.wind;
  input.wind.reset();
  const Calibration fitted = calibrate_day(input);
  const auto times = hourly(1, 5);
  const Propagated with = propagate(fitted, times, day.depth_m, wind, end_of_day);
  const Propagated without = propagate(fitted, times, day.depth_m, std::nullopt, end_of_day);
  EXPECT_EQ(with.mean_m_s, without.mean_m_s);
  EXPECT_EQ(with.sigma_m_s, without.sigma_m_s);
  EXPECT_EQ(with.wind_missing, 0u);
  EXPECT_FALSE(with.has_wind[0]);
}

TEST(Propagate, WorksInTheEquatorialBand) {
  SyntheticDay day = usual_day();
  day.latitude_deg = 2;
  const CalibrationInput input = synthetic_input(day);
  const Calibration fitted = calibrate_day(input);
  const Propagated forecast = propagate(fitted, hourly(1, 24), day.depth_m, input.wind, end_of_day);
  for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - day.truth.interior_m_s()), 0.05);
    EXPECT_GT(forecast.sigma_m_s[i], 0.0);
  }
}

}  // namespace
}  // namespace slackwater::calibration

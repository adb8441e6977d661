#include "calibration/propagate/propagate.h"

#include <gtest/gtest.h>

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

/// Constant misfit and last hours alone.
PropagationSettings without_oscillation() {
  PropagationSettings settings;
  settings.inertial_prior_observations.reset();
  return settings;
}

TEST(Propagate, ForecastsTheSteadyOceanItWasFittedTo) {
  const SyntheticDay day = usual_day();
  const CalibrationInput input = synthetic_input(day);
  const Calibration fitted = calibrate_day(input);
  const auto times = hourly(0, 48);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  std::vector<TimeCell> cells;
  for (const UtcTime t : times) cells.push_back(TimeCell::instant(t));
  const std::vector<Horizontal> truth = synthetic_truth(day, cells);
  ASSERT_EQ(forecast.mean_m_s.size(), truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - truth[i]), 4 * forecast.sigma_m_s[i]);
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - truth[i]),
              0.06);  // noise of three values in the last hours, decaying
  }
  EXPECT_EQ(forecast.wind_missing, 0u);
}

TEST(Propagate, AtTheEndOfTheDayTheRecentResidualIsWholeAndThenDecays) {
  const SyntheticDay day = usual_day();
  Calibration fitted = calibrate_day(synthetic_input(day));
  // A residual of known size at one level: 0.1 east in the last three hours, nothing before.
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
  for (const std::size_t t : {22u, 23u, 24u})
    fitted.residual.value[fitted.residual.offset(t, 3)] = {0.1, 0};
  for (MisfitAtDepth& m : fitted.misfit) m.bias_east_m_s = m.bias_north_m_s = 0;
  const std::vector<double> depths{7.0, 8.5,
                                   4.0};  // the level itself, halfway to the next, the level above
  const auto times = hourly(0, 24);
  const Propagated forecast =
      propagate(fitted, times, depths, std::nullopt, end_of_day, without_oscillation());
  for (std::size_t t = 0; t < times.size(); ++t) {
    const double left = std::exp(-static_cast<double>(t) / 12.0);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t] - 0.1 * left), 1e-15);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t + 1] - 0.05 * left), 1e-15);
    EXPECT_LT(std::abs(forecast.carried_m_s[3 * t + 2]), 1e-15);
  }
}

TEST(Propagate, TheMeanMisfitOfADepthIsCarriedLongerThanThatOfTheLastHours) {
  Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{0.05, 0});
  for (MisfitAtDepth& m : fitted.misfit) {
    m.bias_east_m_s = 0.05;
    m.bias_north_m_s = 0;
  }
  const std::vector<double> depths{10};
  const Propagated forecast = propagate(fitted, hourly(0, 24), depths, std::nullopt, end_of_day);
  EXPECT_NEAR(forecast.carried_m_s.front().real(), 0.05, 1e-15);
  EXPECT_NEAR(forecast.carried_m_s.back().real(), 0.05 * std::exp(-24.0 / 120.0), 1e-15);
}

TEST(Propagate, AnOldResidualIsAlreadyDecayedAtTheEndOfTheDay) {
  Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  std::fill(fitted.residual.value.begin(), fitted.residual.value.end(), Horizontal{});
  for (MisfitAtDepth& m : fitted.misfit) m.bias_east_m_s = m.bias_north_m_s = 0;
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
  EXPECT_NEAR(forecast.carried_m_s.front().imag(), 0.1 * std::exp(-6.0 / 12.0), 1e-15);
}

TEST(Propagate, SigmaIsNotBelowTheMisfitAndGrowsWithLead) {
  const SyntheticDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  for (Horizontal& wind : input.wind->value)
    wind = {8, 3};  // a steady wind: the parameters' share is constant
  const Calibration fitted = calibrate_day(input);
  const auto times = hourly(0, 48);
  const Propagated forecast = propagate(fitted, times, day.depth_m, input.wind, end_of_day);
  for (std::size_t k = 0; k < day.depth_m.size(); ++k) {
    EXPECT_GE(forecast.sigma_m_s[k], fitted.misfit[k].rms_m_s / std::sqrt(2.0));
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
  for (MisfitAtDepth& m : fitted.misfit) m.rms_m_s = 0;
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
  CalibrationInput input = synthetic_input(day);
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
                       p.interior_m_s() * responses.interior(k)),
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

#include "calibration/propagate/propagate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/current/coriolis.h"
#include "tests/calibration/propagate/outlook_for_tests.h"

namespace slackwater::calibration::propagate_test {
namespace {

const std::vector<SteadyForm> all_forms{SteadyForm::finite_depth, SteadyForm::mixed_layer,
                                        SteadyForm::three_layer};

TEST(Propagate, ContinuesTheDayWithoutAJumpBeyondItsSigma) {
  for (const SteadyForm form : all_forms) {
    UnsteadyDay day = usual_day(form);
    day.noise_m_s = 0.004;  // that of the memory's kernel
    const CalibrationInput input = unsteady_input(day);
    const Calibration fitted = calibrate_day(input);
    const std::vector<UtcTime> times{end_of_synthetic_day, add_hours(end_of_synthetic_day, 0.1)};
    const Propagated forecast = outlook(fitted, times, input.wind);
    const std::size_t levels = day.depth_m.size();
    for (std::size_t i = 0; i < 2 * levels; ++i) {
      const Horizontal last = input.current.value[24 * levels + i % levels];
      EXPECT_LT(std::abs(forecast.mean_m_s[i] - last), 4.5 * forecast.sigma_m_s[i])
          << name_of(form) << ' ' << i;
      EXPECT_LT(std::abs(forecast.mean_m_s[i] - last), 0.03);
    }
  }
}

TEST(Propagate, AConstantWindAndInteriorStayConstant) {
  for (const SteadyForm form : all_forms) {
    UnsteadyDay day = usual_day(form);
    day.noise_m_s = 0;
    const CalibrationInput input = steady_wind_input(day);
    const Propagated forecast = outlook(calibrate_day(input), leads(0, 48), input.wind);
    const std::size_t levels = day.depth_m.size();
    for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
      // Of 0.22 m/s the kernel takes 4 % for slow change, four tenths of which are gone by 48 h.
      EXPECT_LT(std::abs(forecast.mean_m_s[i] - input.current.value[24 * levels + i % levels]),
                0.006)
          << name_of(form) << ' ' << i;
    }
  }
}

TEST(Propagate, ForecastsTheMovingOceanItWasFittedTo) {
  for (const SteadyForm form : {SteadyForm::finite_depth, SteadyForm::mixed_layer}) {
    const UnsteadyDay day = usual_day(form);
    const CalibrationInput input = unsteady_input(day);
    const std::vector<UtcTime> times = leads(1, 24);
    std::vector<TimeCell> cells;
    for (const UtcTime time : times) cells.push_back(TimeCell::instant(time));
    const std::vector<Horizontal> truth = unsteady_truth(day, cells);
    const Propagated forecast = outlook(calibrate_day(input), times, input.wind);
    double squares = 0;
    double persistence = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      squares += std::norm(forecast.mean_m_s[i] - truth[i]);
      persistence += std::norm(
          input.current.value[24 * day.depth_m.size() + i % day.depth_m.size()] - truth[i]);
      EXPECT_LT(std::abs(forecast.mean_m_s[i] - truth[i]), 5 * forecast.sigma_m_s[i]);
    }
    EXPECT_LT(squares, 0.05 * persistence) << name_of(form);
  }
}

TEST(Propagate, AWindThatTurnsAfterTheDayMakesNewInertialMotion) {
  // A steady forecast jumps to its new place; the sea circles about it and comes to rest there.
  UnsteadyDay day = usual_day();
  day.noise_m_s = 0;
  day.truth.bottom_friction_m_s = 2e-3;
  CalibrationInput input = steady_wind_input(day);
  const Calibration fitted = calibrate_day(input);
  for (std::size_t t = 0; t < input.wind->times(); ++t) {
    if (input.wind->time[t].start > end_of_synthetic_day) input.wind->value[t] = {-8, 6};
  }
  const std::vector<UtcTime> times{add_hours(end_of_synthetic_day, 1.5),
                                   add_hours(end_of_synthetic_day, 48)};
  const Propagated forecast = outlook(fitted, times, input.wind);
  const LevelResponses r = level_responses(fitted.form, steady_parameters(fitted), fitted.latitude,
                                           fitted.water_depth_m, day.depth_m);
  const std::size_t k = 1;
  const Horizontal before = r.stress(k) * wind_stress_pa({8, 3}, fitted.drag_law);
  const Horizontal after = r.stress(k) * wind_stress_pa({-8, 6}, fitted.drag_law);
  EXPECT_GT(std::abs(forecast.wind_driven_m_s[k] - after), 0.25 * std::abs(after - before));
  EXPECT_LT(std::abs(forecast.wind_driven_m_s[r.levels() + k] - after),
            0.1 * std::abs(after - before));
}

TEST(Propagate, WhereTheWindIsMissingItIsFlaggedCountedAndDoubted) {
  const UnsteadyDay day = usual_day();
  CalibrationInput input = steady_wind_input(day);
  const Calibration fitted = calibrate_day(input);
  for (std::size_t t = 0; t < input.wind->times(); ++t) {
    if (input.wind->time[t].start > add_hours(end_of_synthetic_day, 6))
      input.wind->status[t] = SampleStatus::missing;
  }
  const auto times = leads(0, 24);  // wind to 6 h, held to 9 h, missing for the last 15
  const Propagated forecast = outlook(fitted, times, input.wind);
  EXPECT_EQ(forecast.wind_missing, 15u);
  EXPECT_TRUE(forecast.has_wind[9]);
  EXPECT_FALSE(forecast.has_wind[10]);
  const std::size_t levels = day.depth_m.size();
  for (std::size_t k = 0; k < levels; ++k) {
    // A wind that stops being known is no calm: it makes no new motion either.
    EXPECT_LT(std::abs(forecast.wind_driven_m_s[10 * levels + k]), 1e-3);
  }
  const LevelResponses r = level_responses(fitted.form, steady_parameters(fitted), fitted.latitude,
                                           fitted.water_depth_m, day.depth_m);
  EXPECT_GT(forecast.sigma_m_s[10 * levels], Spread{}.unknown_stress_pa * std::abs(r.stress(0)));
  EXPECT_EQ(outlook(fitted, times, std::nullopt).wind_missing, times.size());
}

TEST(Propagate, ADayFittedWithoutWindIgnoresTheWindItIsGiven) {
  CalibrationInput input = unsteady_input(usual_day());
  const std::optional<VectorColumn> wind = input.wind;
  input.wind.reset();
  const Calibration fitted = calibrate_day(input);
  const Propagated with = outlook(fitted, leads(1, 5), wind);
  const Propagated without = outlook(fitted, leads(1, 5), std::nullopt);
  EXPECT_EQ(with.mean_m_s, without.mean_m_s);
  EXPECT_EQ(with.sigma_m_s, without.sigma_m_s);
  EXPECT_EQ(with.departure_m_s, without.departure_m_s);
  EXPECT_EQ(with.wind_missing, 0u);
  EXPECT_FALSE(with.has_wind[0]);
}

TEST(Propagate, TurnsWithTheAxes) {
  for (const SteadyForm form : all_forms) {
    CalibrationInput input = unsteady_input(usual_day(form));
    Calibration fitted = calibrate_day(input);
    const Propagated a = outlook(fitted, leads(0, 30), input.wind);
    const Horizontal turn = std::exp(Horizontal(0, 2.1));
    for (Horizontal& w : input.wind->value) w *= turn;
    for (Horizontal& w : fitted.remembered.value) w *= turn;
    for (Horizontal& w : fitted.wind_driven_m_s) w *= turn;
    for (std::size_t i = 0; i + 1 < fitted.parameters.size(); ++i) {
      Parameter& east = fitted.parameters[i];
      if (!east.name.ends_with("_east")) continue;
      const Horizontal turned = turn * Horizontal(east.value, fitted.parameters[i + 1].value);
      east.value = turned.real();
      fitted.parameters[i + 1].value = turned.imag();
    }
    const Propagated b = outlook(fitted, leads(0, 30), input.wind);
    for (std::size_t i = 0; i < a.mean_m_s.size(); ++i) {
      EXPECT_LT(std::abs(turn * a.mean_m_s[i] - b.mean_m_s[i]), 1e-12);
      EXPECT_NEAR(a.sigma_m_s[i], b.sigma_m_s[i], 1e-12);
    }
  }
}

TEST(Propagate, TheForecastDoesNotDependOnTheOrderOfTheForms) {
  const CalibrationInput input = unsteady_input(usual_day());
  std::vector<Calibration> forms;
  for (const SteadyForm form : all_forms) {
    CalibrationInput one = input;
    one.form = form;
    forms.push_back(calibrate_day(one));
    forms.back().log_occam = 0;  // nearly one weight each, so that each form counts
    forms.back().misfit_sigma_m_s = 0.02;
  }
  const auto times = leads(1, 24);
  const Propagated a = propagate(forms, times, input.wind, end_of_synthetic_day, {}, {}, 1);
  std::reverse(forms.begin(), forms.end());
  const Propagated b = propagate(forms, times, input.wind, end_of_synthetic_day, {}, {}, 1);
  for (std::size_t f = 0; f < 3; ++f) {
    EXPECT_NEAR(a.form_weight[f], 1.0 / 3, 1e-12);
    EXPECT_NEAR(a.form_weight[f], b.form_weight[2 - f], 1e-12);
  }
  double a_squares = 0;
  double b_squares = 0;
  for (std::size_t i = 0; i < a.mean_m_s.size(); ++i) {
    EXPECT_LT(std::abs(a.mean_m_s[i] - b.mean_m_s[i]), 1e-13);
    EXPECT_LT(std::abs(a.wind_driven_m_s[i] - b.wind_driven_m_s[i]), 1e-13);
    a_squares += a.sigma_m_s[i] * a.sigma_m_s[i];
    b_squares += b.sigma_m_s[i] * b.sigma_m_s[i];
  }
  // Which members follow which form changes: the wind's part of the spread is a sample of 24.
  EXPECT_NEAR(std::sqrt(a_squares / b_squares), 1.0, 0.15);
}

TEST(Propagate, OneDailyMeanIsCarriedAsAConstant) {
  const UnsteadyDay day = usual_day();
  const CalibrationInput input = steady_wind_input(day);
  Calibration fitted = calibrate_day(input);
  const std::size_t levels = fitted.remembered.levels();
  fitted.remembered.time = {{synthetic_midnight, end_of_synthetic_day}};
  fitted.remembered.source.resize(1);
  fitted.remembered.value.assign(levels, {0.06, -0.02});
  fitted.remembered.status.assign(levels, SampleStatus::ok);
  fitted.wind_driven_m_s.assign(levels, Horizontal{});
  const Propagated forecast = outlook(fitted, leads(0, 48), input.wind);
  for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
    // Slow and recent change and a turn of inertial motion are a tenth of what the kernel allows.
    EXPECT_LT(
        std::abs(forecast.mean_m_s[i] - forecast.wind_driven_m_s[i] - Horizontal(0.06, -0.02)),
        0.006);
  }
}

TEST(Propagate, WorksInTheEquatorialBand) {
  UnsteadyDay day = usual_day();
  day.latitude_deg = 2;
  CalibrationInput input = synthetic_input(day);
  input.is_unsteady = true;
  const Propagated forecast = outlook(calibrate_day(input), leads(1, 24), input.wind);
  for (std::size_t i = 0; i < forecast.mean_m_s.size(); ++i) {
    EXPECT_LT(std::abs(forecast.mean_m_s[i] - day.truth.interior_m_s()), 0.05);
    EXPECT_GT(forecast.sigma_m_s[i], 0.0);
  }
}

}  // namespace
}  // namespace slackwater::calibration::propagate_test

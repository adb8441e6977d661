// Known truth in, the same parameters out: the column with memory, and the mixed layer.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/calibration/solve/unsteady_day.h"

namespace slackwater::calibration::unsteady_twin_test {
namespace {

// 40 days of 9 or more parameters: the mean square of normalised errors has a standard error below
// 0.08.
constexpr std::uint64_t days = 40;

using FitOfSeed = std::function<std::pair<Calibration, UnsteadyDay>(std::uint64_t)>;

double mean_square_of_normalised_errors(const FitOfSeed& fit_of, double worst_allowed) {
  double squares = 0;
  double n = 0;
  for (std::uint64_t seed = 1; seed <= days; ++seed) {
    const auto [fitted, day] = fit_of(seed);
    const std::vector<double> errors = estimate_errors(fitted, day);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const double normalised = errors[i] / fitted.parameters[i].sigma;
      EXPECT_LT(std::abs(normalised), worst_allowed)
          << "seed " << seed << ' ' << fitted.parameters[i].name;
      squares += normalised * normalised;
      n += 1;
    }
  }
  return squares / n;
}

FitOfSeed unsteady(SteadyForm form) {
  return [form](std::uint64_t seed) {
    const UnsteadyDay day = random_unsteady_day(form, seed);
    return std::pair{calibrate_day(unsteady_input(day)), day};
  };
}

TEST(UnsteadyTwin, TheWaterColumnIsFoundWithinItsSigma) {
  const double z2 = mean_square_of_normalised_errors(unsteady(SteadyForm::finite_depth), 4.5);
  RecordProperty("mean_square", std::to_string(z2));
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(UnsteadyTwin, TheMixedLayerIsFoundWithinItsSigma) {
  const double z2 = mean_square_of_normalised_errors(unsteady(SteadyForm::mixed_layer), 4.5);
  RecordProperty("mean_square", std::to_string(z2));
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(UnsteadyTwin, DeepWaterWithATrendIsFoundWithinItsSigma) {
  const double z2 = mean_square_of_normalised_errors(unsteady(SteadyForm::three_layer), 4.5);
  RecordProperty("mean_square", std::to_string(z2));
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(UnsteadyTwin, TheSteadyMixedLayerIsFoundWithinItsSigma) {
  const auto steady = [](std::uint64_t seed) {
    UnsteadyDay day = random_unsteady_day(SteadyForm::mixed_layer, seed);
    return std::pair{calibrate_day(synthetic_input(day)), day};
  };
  const double z2 = mean_square_of_normalised_errors(steady, 4.5);
  RecordProperty("mean_square", std::to_string(z2));
  EXPECT_GT(z2, 0.6);
  EXPECT_LT(z2, 1.4);
}

TEST(UnsteadyTwin, WithoutNoiseTheTruthComesBack) {
  for (const SteadyForm form :
       {SteadyForm::finite_depth, SteadyForm::mixed_layer, SteadyForm::three_layer}) {
    UnsteadyDay day = random_unsteady_day(form, 6);
    day.noise_m_s = 0;
    CalibrationInput input = unsteady_input(day);
    input.observation_sigma_m_s = 1e-6;  // the data outweigh the priors by ten digits
    const Calibration fitted = calibrate_day(input);
    for (std::size_t i = 0; i < fitted.parameters.size(); ++i)
      EXPECT_LT(std::abs(estimate_errors(fitted, day)[i]), 1e-4)
          << name_of(form) << ' ' << fitted.parameters[i].name;
    EXPECT_LT(fitted.rms_m_s, 1e-6);
  }
}

TEST(UnsteadyTwin, AnUnsteadyFitOfASteadyDayUnderAConstantWindFindsNoMotion) {
  UnsteadyDay day = random_unsteady_day(SteadyForm::finite_depth, 3);
  CalibrationInput input = unsteady_input(day);
  const LevelResponses r =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  std::fill(input.wind->value.begin(), input.wind->value.end(), Horizontal(9, 4));
  const Horizontal stress = wind_stress_pa({9, 4}, input.drag_law);
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    for (std::size_t k = 0; k < r.levels(); ++k)
      input.current.value[input.current.offset(t, k)] =
          day.truth.interior_m_s() * r.interior(k) + stress * r.stress(k);
  }
  const Calibration fitted = calibrate_day(input);
  for (const char* name :
       {"interior_trend_east", "interior_trend_north", "inertial_east", "inertial_north"})
    EXPECT_LT(std::abs(find_parameter(fitted, name)->value), 2e-3) << name;
}

TEST(UnsteadyTwin, WhatIsKnownBeforehandReplacesTheGeneralPriorAndIsNamed) {
  const UnsteadyDay day = random_unsteady_day(SteadyForm::mixed_layer, 5);
  CalibrationInput input = unsteady_input(day);
  const Calibration general = calibrate_day(input);
  input.known = {{"mixed_layer_depth", 31.0, 0.001}, {"no_such_parameter", 1.0, 1.0}};
  const Calibration fitted = calibrate_day(input);
  const Parameter* p = find_parameter(fitted, "mixed_layer_depth");
  EXPECT_EQ(p->prior, 31.0);
  EXPECT_EQ(p->prior_sigma, 0.001);
  EXPECT_EQ(p->source, "the day before, aged");
  // A prior a thousand times surer than the day is where the estimate stays.
  EXPECT_NEAR(std::log(p->value / 31.0), 0, 0.01);
  EXPECT_LE(p->sigma, 0.001);
  for (const char* name : {"eddy_viscosity", "base_friction", "stress_factor"})
    EXPECT_EQ(find_parameter(fitted, name)->source, find_parameter(general, name)->source);
}

TEST(UnsteadyTwin, ALayerBeyondTheBoundsIsFlaggedOnThem) {
  UnsteadyDay day = random_unsteady_day(SteadyForm::mixed_layer, 2);
  day.truth.mixed_layer_depth_m = 1.6;
  day.noise_m_s = 2e-4;
  day.depth_m = {0.2, 0.6, 1.0, 1.4, 1.8, 2.2, 2.6, 3.2, 4, 10};
  CalibrationInput input = unsteady_input(day);
  input.observation_sigma_m_s = 2e-4;
  input.known = {{"mixed_layer_depth", 4.0, 0.6}};
  const Calibration fitted = calibrate_day(input);
  EXPECT_TRUE(find_parameter(fitted, "mixed_layer_depth")->at_bound);
  for (const Parameter& p : fitted.parameters) {
    const bool is_named =
        std::any_of(fitted.warnings.begin(), fitted.warnings.end(), [&](const std::string& w) {
          return w.find(p.name + " ended at its") != std::string::npos;
        });
    EXPECT_EQ(p.at_bound, is_named) << p.name;
  }
}

}  // namespace
}  // namespace slackwater::calibration::unsteady_twin_test

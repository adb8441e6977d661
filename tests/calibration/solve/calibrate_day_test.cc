#include <gtest/gtest.h>

#include <algorithm>

#include "calibration/solve/determination.h"
#include "calibration/solve/residual_memory.h"
#include "fields/base/error.h"
#include "tests/calibration/solve/synthetic_day.h"

namespace slackwater::calibration::calibrate_day_test {
namespace {

bool warns_of(const Calibration& fitted, std::string_view text) {
  return std::any_of(fitted.warnings.begin(), fitted.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

SyntheticDay usual_day() {
  SyntheticDay day;
  day.truth.interior_east_m_s = 0.2;
  day.truth.interior_north_m_s = -0.1;
  return day;
}

TEST(CalibrateDay, ReportsMisfitByDepthAndAResidualThatAddsUp) {
  const SyntheticDay day = usual_day();
  const CalibrationInput input = synthetic_input(day);
  const Calibration fitted = calibrate_day(input);
  ASSERT_EQ(fitted.misfit.size(), day.depth_m.size());
  double squares = 0;
  for (std::size_t k = 0; k < fitted.misfit.size(); ++k) {
    EXPECT_EQ(fitted.misfit[k].depth_m, day.depth_m[k]);
    EXPECT_EQ(fitted.misfit[k].n, 25u);
    squares += 25 * fitted.misfit[k].rms_m_s * fitted.misfit[k].rms_m_s;
    EXPECT_NEAR(fitted.misfit[k].rms_m_s, 0.02 * std::sqrt(2.0),
                0.008);  // 50 normal numbers: 10 % each
  }
  EXPECT_NEAR(fitted.rms_m_s, std::sqrt(squares / (25.0 * 11)), 1e-12);
  EXPECT_EQ(fitted.observations, 275u);

  const LevelResponses responses = level_responses(
      fitted.form, steady_parameters(fitted), fitted.latitude, fitted.water_depth_m, day.depth_m);
  const StressSeries series(*input.wind, fitted.drag_law);
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    const Horizontal stress = *series.over(input.current.time[t]);
    for (std::size_t k = 0; k < day.depth_m.size(); ++k) {
      const Horizontal model = steady_parameters(fitted).interior_m_s() * responses.interior(k) +
                               stress * responses.stress(k);
      const std::size_t at = input.current.offset(t, k);
      EXPECT_LT(std::abs(fitted.residual.value[at] + model - input.current.value[at]), 1e-14);
    }
  }
}

TEST(CalibrateDay, SaysInASentenceHowItEnded) {
  const Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  EXPECT_TRUE(fitted.termination.starts_with("converged after ")) << fitted.termination;
  EXPECT_GT(fitted.iterations, 0);
}

TEST(CalibrateDay, TheCovarianceIsSymmetricPositiveAndTheSourceOfTheSigmas) {
  const Calibration fitted = calibrate_day(synthetic_input(usual_day()));
  const std::size_t n = fitted.parameters.size();
  ASSERT_EQ(n, 5u);
  ASSERT_EQ(fitted.covariance.size(), n * n);
  for (std::size_t i = 0; i < n; ++i) {
    EXPECT_NEAR(std::sqrt(fitted.covariance[i * n + i]), fitted.parameters[i].sigma, 1e-14);
    EXPECT_LT(fitted.parameters[i].sigma, fitted.parameters[i].prior_sigma);
    EXPECT_FALSE(fitted.parameters[i].source.empty());
    for (std::size_t j = 0; j < n; ++j) {
      EXPECT_NEAR(fitted.covariance[i * n + j], fitted.covariance[j * n + i],
                  1e-12 * fitted.parameters[i].sigma * fitted.parameters[j].sigma);
    }
  }
}

TEST(CalibrateDay, AMisfitWithMemoryWidensTheUncertainty) {
  const SyntheticDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  const Calibration white = calibrate_day(input);
  EXPECT_GT(white.effective_observations, 0.75 * static_cast<double>(white.observations));
  for (std::size_t t = 0; t < input.current.times(); ++t) {
    for (std::size_t k = 0; k < input.current.levels(); ++k) {
      input.current.value[input.current.offset(t, k)] +=
          std::polar(0.08, -0.42 * static_cast<double>(t));
    }
  }
  const Calibration inertial = calibrate_day(input);
  EXPECT_LT(inertial.effective_observations, 0.1 * static_cast<double>(inertial.observations));
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_GT(inertial.parameters[i].sigma, 2 * white.parameters[i].sigma);
  const std::vector<double> errors = estimate_errors(inertial, day.truth);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_LT(std::abs(errors[i]), 3 * inertial.parameters[i].sigma);
}

TEST(CalibrateDay, WithoutWindTheTermIsDroppedAndSaid) {
  SyntheticDay day = usual_day();
  CalibrationInput input = synthetic_input(day);
  day.wind_speed_m_s = 0;
  input.current = synthetic_input(day).current;
  input.wind.reset();
  const Calibration fitted = calibrate_day(input);
  EXPECT_FALSE(fitted.wind_used);
  EXPECT_EQ(fitted.parameters.size(), 4u);
  EXPECT_EQ(find_parameter(fitted, "stress_factor"), nullptr);
  EXPECT_TRUE(warns_of(fitted, "no wind for this day"));
  const std::vector<double> errors = estimate_errors(fitted, day.truth);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_LT(std::abs(errors[i]), 4 * fitted.parameters[i].sigma);
}

TEST(CalibrateDay, AWindThatNeverReachesTheDayIsDroppedAndSaid) {
  CalibrationInput input = synthetic_input(usual_day());
  for (TimeCell& cell : input.wind->time)
    cell = TimeCell::instant(cell.start - std::chrono::hours(24 * 10));
  const Calibration fitted = calibrate_day(input);
  EXPECT_FALSE(fitted.wind_used);
  EXPECT_TRUE(warns_of(fitted, "has no value at any time"));
}

TEST(CalibrateDay, CurrentsInAGapOfTheWindAreNotUsedAndItIsSaid) {
  CalibrationInput input = synthetic_input(usual_day());
  for (std::size_t t = 0; t < input.wind->times(); ++t) {
    const double h = hours_between(synthetic_midnight, input.wind->time[t].start);
    if (h > 4.5 && h < 13.5) input.wind->status[t] = SampleStatus::missing;
  }
  const Calibration fitted = calibrate_day(input);
  EXPECT_TRUE(fitted.wind_used);
  EXPECT_TRUE(warns_of(fitted, "no wind at 9 of 25 times"));
  EXPECT_EQ(fitted.observations, 16u * 11);
  EXPECT_FALSE(fitted.residual.has(8, 0));
  EXPECT_TRUE(fitted.residual.has(20, 0));
}

TEST(CalibrateDay, NearTheEquatorOnlyTheInteriorIsFittedAndItIsSaid) {
  SyntheticDay day = usual_day();
  day.latitude_deg = -1.5;
  const Calibration fitted = calibrate_day(synthetic_input(day));
  EXPECT_EQ(fitted.parameters.size(), 2u);
  EXPECT_FALSE(fitted.wind_used);
  EXPECT_TRUE(warns_of(fitted, "equator"));
  const std::vector<double> errors = estimate_errors(fitted, day.truth);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(errors[i]), 4 * fitted.parameters[i].sigma);
}

TEST(CalibrateDay, WhatADayCannotDetermineIsFlaggedAndNamed) {
  // The upper 60 m of 4 km of water say nothing about the bed; calm air says nothing about the
  // stress factor.
  SyntheticDay day = usual_day();
  day.form = SteadyForm::three_layer;
  day.water_depth_m = 4000;
  day.depth_m = {0.5, 5, 15, 30, 60};
  day.wind_speed_m_s = 0.1;
  const Calibration fitted = calibrate_day(synthetic_input(day));
  for (const char* name : {"eddy_viscosity", "bottom_eddy_viscosity", "stress_factor"}) {
    const Parameter* p = find_parameter(fitted, name);
    ASSERT_NE(p, nullptr);
    EXPECT_TRUE(p->weakly_determined) << name;
    EXPECT_NEAR(p->sigma, p->prior_sigma, 0.05 * p->prior_sigma) << name;
    EXPECT_FALSE(p->at_bound) << name;
    EXPECT_TRUE(warns_of(fitted, name)) << name;
  }
  EXPECT_FALSE(find_parameter(fitted, "interior_east")->weakly_determined);
  // One sentence for an operator, not one per parameter and direction.
  EXPECT_TRUE(
      warns_of(fitted,
               "the data of the day tell little about eddy_viscosity, bottom_eddy_viscosity and "
               "stress_factor: their values are mostly those assumed beforehand"));
  EXPECT_EQ(fitted.warnings.size(), 1u);
}

TEST(JudgeDetermination, AWeakCombinationOfStrongParametersIsNamedInWords) {
  // Both are known to 0.79 of the prior, their sum to 1.1, their difference to 0.2.
  std::vector<Parameter> parameters(2);
  parameters[0].name = "bottom_friction";
  parameters[1].name = "stress_factor";
  for (Parameter& p : parameters) {
    p.prior_sigma = 1;
    p.lower = -9;
    p.upper = 9;
  }
  Eigen::MatrixXd covariance(2, 2);
  covariance << 0.6241, 0.5841, 0.5841, 0.6241;
  const std::vector<std::string> warnings = judge_determination({0, 0}, covariance, parameters);
  EXPECT_FALSE(parameters[0].weakly_determined || parameters[1].weakly_determined);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_TRUE(warnings[0].starts_with("bottom_friction and stress_factor cannot be told apart"))
      << warnings[0];
}

TEST(JudgeDetermination, AWeakParameterIsNamedOnce) {
  std::vector<Parameter> parameters(2);
  parameters[0].name = "bottom_friction";
  parameters[1].name = "stress_factor";
  for (Parameter& p : parameters) {
    p.prior_sigma = 1;
    p.lower = -9;
    p.upper = 9;
  }
  Eigen::MatrixXd covariance(2, 2);
  covariance << 0.98, 0.1, 0.1, 0.02;
  const std::vector<std::string> warnings = judge_determination({0, 0}, covariance, parameters);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0],
            "the data of the day tell little about bottom_friction: its value is mostly the one "
            "assumed beforehand");
}

TEST(CalibrateDay, AParameterOnItsBoundIsFlaggedAndWarnedOf) {
  // Water stiffer than the bounds allow, seen with little noise. What such water leaves unexplained
  // repeats itself and counts as one observation: very stiff water would leave the bound to the
  // prior.
  SyntheticDay day = usual_day();
  day.truth.eddy_viscosity_m2_s = 3;
  day.noise_m_s = 2e-4;
  CalibrationInput input = synthetic_input(day);
  input.observation_sigma_m_s = 2e-4;
  const Calibration fitted = calibrate_day(input);
  EXPECT_TRUE(find_parameter(fitted, "eddy_viscosity")->at_bound);
  EXPECT_TRUE(warns_of(fitted, "eddy_viscosity ended at its upper bound of 1 m2 s-1"));
  for (const Parameter& p : fitted.parameters) {
    EXPECT_GE(p.value, p.lower * (1 - 1e-12));
    EXPECT_LE(p.value, p.upper * (1 + 1e-12));
    EXPECT_EQ(p.at_bound, warns_of(fitted, p.name + " ended at its")) << p.name;
  }
}

TEST(CalibrateDay, NothingToFitIsRefusedWithASentence) {
  SyntheticDay day = usual_day();
  day.missing_share = 2;
  try {
    (void)calibrate_day(synthetic_input(day));
    FAIL() << "a day without a value was fitted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find("none of the 275 currents of the day has a value"),
              std::string::npos);
  }
  CalibrationInput empty = synthetic_input(usual_day());
  empty.current = {};
  EXPECT_THROW((void)calibrate_day(empty), Error);
}

TEST(CalibrateDay, NotANumberIsAMissingValueAndNeverASpeed) {
  CalibrationInput input = synthetic_input(usual_day());
  const std::size_t all = input.current.value.size();
  for (std::size_t i = 0; i < all; i += 3) input.current.value[i] = {std::nan(""), 0.1};
  const Calibration fitted = calibrate_day(input);
  EXPECT_EQ(fitted.observations, all - (all + 2) / 3);
  EXPECT_TRUE(std::isfinite(fitted.rms_m_s));
}

TEST(CalibrateDay, AWaterDepthThatIsNotPositiveIsRefused) {
  CalibrationInput input = synthetic_input(usual_day());
  input.water_depth_m = 0;
  EXPECT_THROW((void)calibrate_day(input), Error);
  input.water_depth_m = std::nan("");
  EXPECT_THROW((void)calibrate_day(input), Error);
}

TEST(CalibrateDay, CurrentsBelowTheGivenBedDeepenTheWater) {
  CalibrationInput input = synthetic_input(usual_day());
  input.water_depth_m = 40;
  const Calibration fitted = calibrate_day(input);
  EXPECT_EQ(fitted.water_depth_m, 42.0);
  EXPECT_TRUE(warns_of(fitted, "below the given water depth"));
}

TEST(CalibrateDay, ASingleObservationIsFittedAndItsWeaknessSaid) {
  CalibrationInput input = synthetic_input(usual_day());
  std::fill(input.current.status.begin(), input.current.status.end(), SampleStatus::missing);
  input.current.status[40] = SampleStatus::not_checked;
  const Calibration fitted = calibrate_day(input);
  EXPECT_EQ(fitted.observations, 1u);
  EXPECT_TRUE(find_parameter(fitted, "bottom_friction")->weakly_determined);
}

TEST(CalibrateDay, TheFormFollowsTheDepthUnlessToldOtherwise) {
  CalibrationInput input = synthetic_input(usual_day());
  input.form.reset();
  EXPECT_EQ(calibrate_day(input).form, SteadyForm::finite_depth);
  input.water_depth_m = 3000;
  EXPECT_EQ(calibrate_day(input).form, SteadyForm::three_layer);
  input.form = SteadyForm::finite_depth;
  EXPECT_EQ(calibrate_day(input).form, SteadyForm::finite_depth);
}

TEST(CalibrateDay, TheSameDayGivesTheSameBits) {
  const CalibrationInput input = synthetic_input(usual_day());
  const Calibration a = calibrate_day(input);
  const Calibration b = calibrate_day(input);
  EXPECT_EQ(steady_parameters(a), steady_parameters(b));
  EXPECT_EQ(a.covariance, b.covariance);
}

TEST(ResidualMemory, AnAutoregressiveSeriesIsWorthItsKnownNumber) {
  // Correlation c in time only: n (1 - c)/(1 + c) independent values.
  Rng rng(21, "tests/memory");
  VectorColumn residual;
  residual.levels_m = {0, 1, 2};
  const double c = 0.8;
  std::vector<Horizontal> last(3);
  for (int t = 0; t < 4000; ++t) {
    residual.time.push_back(TimeCell::instant(add_hours(synthetic_midnight, t)));
    for (Horizontal& x : last) {
      x = c * x + std::sqrt(1 - c * c) * Horizontal{rng.normal(), rng.normal()};
      residual.value.push_back(x);
      residual.status.push_back(SampleStatus::ok);
    }
  }
  const ResidualMemory memory = residual_memory(residual);
  EXPECT_NEAR(memory.time_correlation, c, 0.02);
  EXPECT_EQ(memory.depth_correlation, 0.0);
  EXPECT_NEAR(memory.effective_pairs, 12000 * (1 - c) / (1 + c), 150);
}

}  // namespace
}  // namespace slackwater::calibration::calibrate_day_test

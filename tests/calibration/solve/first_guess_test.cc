#include "calibration/solve/first_guess.h"

#include <gtest/gtest.h>

#include "calibration/solve/parameter_set.h"
#include "tests/calibration/solve/synthetic_day.h"

namespace slackwater::calibration::first_guess_test {
namespace {

DayProblem problem_of(const CalibrationInput& input) {
  const Observations observations = pair_observations(input);
  DayProblem problem;
  problem.day.layout.form = *input.form;
  problem.day.latitude = input.latitude;
  problem.day.water_depth_m = input.water_depth_m;
  problem.day.depth_m = observations.depth_m;
  problem.day.time = input.current.time;
  problem.day.stress_pa = observations.stress_pa;
  problem.day.start = synthetic_midnight;
  problem.pairs = observations.pairs;
  problem.parameters = prior_parameters(problem.day.layout, input.water_depth_m, {});
  problem.sigma_m_s = input.observation_sigma_m_s;
  return problem;
}

TEST(FirstGuess, IsExactWhereTheShapeOfTheColumnLiesOnItsGrid) {
  // The centres of the priors do; all else, the factor included, is linear.
  for (const SteadyForm form :
       {SteadyForm::finite_depth, SteadyForm::three_layer, SteadyForm::mixed_layer}) {
    for (const double factor : {0.5, 1.0, 2.2}) {
      SyntheticDay day;
      day.form = form;
      day.water_depth_m = form == SteadyForm::three_layer ? 400 : 60;
      day.truth.interior_east_m_s = 0.2;
      day.truth.interior_north_m_s = -0.4;
      day.truth.stress_factor = factor;
      day.noise_m_s = 0;
      CalibrationInput input = synthetic_input(day);
      input.observation_sigma_m_s = 1e-6;  // the data outweigh the priors by ten digits
      const DayProblem problem = problem_of(input);
      const std::vector<double> guess = first_guess(problem);
      EXPECT_NEAR(guess[0], 0.2, 1e-7) << name_of(form);
      EXPECT_NEAR(guess[1], -0.4, 1e-7) << name_of(form);
      EXPECT_NEAR(guess[problem.day.layout.log_factor()], std::log(factor), 1e-7) << name_of(form);
    }
  }
}

TEST(FirstGuess, StaysWithinTheBounds) {
  SyntheticDay day;
  day.truth.interior_east_m_s = 9;
  day.truth.stress_factor = 40;
  const CalibrationInput input = synthetic_input(day);
  const DayProblem problem = problem_of(input);
  const std::vector<double> guess = first_guess(problem);
  for (std::size_t i = 0; i < guess.size(); ++i) {
    const Parameter& p = problem.parameters[i];
    EXPECT_GE(guess[i], estimated(p, p.lower)) << p.name;
    EXPECT_LE(guess[i], estimated(p, p.upper)) << p.name;
  }
}

}  // namespace
}  // namespace slackwater::calibration::first_guess_test

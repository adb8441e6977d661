#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/calibration/solve/unsteady_day.h"

namespace slackwater::calibration::form_weights_test {
namespace {

/// The same day under both forms that move.
std::vector<Calibration> both_fits(const UnsteadyDay& day) {
  std::vector<Calibration> fits;
  for (const SteadyForm form : {SteadyForm::finite_depth, SteadyForm::mixed_layer}) {
    CalibrationInput input = unsteady_input(day);
    input.form = form;
    fits.push_back(calibrate_day(input));
  }
  return fits;
}

UnsteadyDay shelf_day(SteadyForm form, std::uint64_t seed) {
  UnsteadyDay day = random_unsteady_day(form, seed);
  day.water_depth_m = 60;
  day.depth_m = {0.5, 2, 4, 7, 10, 14, 19, 25, 31, 37, 45, 58};
  return day;
}

TEST(FormWeights, SumToOneAndDoNotDependOnTheOrder) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    std::vector<Calibration> fits = both_fits(shelf_day(SteadyForm::mixed_layer, seed));
    const std::vector<double> weight = form_weights(fits);
    EXPECT_NEAR(std::accumulate(weight.begin(), weight.end(), 0.0), 1.0, 1e-14);
    for (const double w : weight) EXPECT_GE(w, 0.0);
    std::reverse(fits.begin(), fits.end());
    const std::vector<double> turned = form_weights(fits);
    EXPECT_NEAR(turned[0], weight[1], 1e-14);
    EXPECT_NEAR(turned[1], weight[0], 1e-14);
  }
}

TEST(FormWeights, AFormAloneIsCertainAndTwinsShare) {
  const Calibration fit = both_fits(shelf_day(SteadyForm::finite_depth, 1)).front();
  EXPECT_EQ(form_weights({fit}), std::vector<double>{1.0});
  EXPECT_EQ(form_weights({fit, fit}), (std::vector<double>{0.5, 0.5}));
}

TEST(FormWeights, AreTheEvidenceOfMisfitAndOccamsFactor) {
  Calibration a;
  a.misfit_sigma_m_s = 0.020;
  a.effective_observations = 12;
  Calibration b = a;
  b.log_occam = -2;  // pays more for its freedom
  std::vector<double> weight = form_weights({a, b});
  EXPECT_NEAR(weight[0] / weight[1], std::exp(2.0), 1e-12);
  b.log_occam = 0;
  b.misfit_sigma_m_s = 0.025;
  b.effective_observations = 3;  // leaves a slow error: the better form's count holds for both
  weight = form_weights({a, b});
  EXPECT_NEAR(weight[0] / weight[1], std::pow(1.25, 24), 1e-9);
  a.misfit_sigma_m_s = 0.001;
  b.misfit_sigma_m_s = 0.004;
  weight = form_weights({a, b});
  EXPECT_EQ(weight[0], weight[1]);  // both finer than any form is believed
}

TEST(FormWeights, TheTrueFormWinsInMostDays) {
  for (const SteadyForm truth : {SteadyForm::finite_depth, SteadyForm::mixed_layer}) {
    const std::size_t place = truth == SteadyForm::finite_depth ? 0 : 1;
    int won = 0;
    for (std::uint64_t seed = 1; seed <= 30; ++seed)
      won += form_weights(both_fits(shelf_day(truth, seed)))[place] > 0.5 ? 1 : 0;
    RecordProperty(std::string(name_of(truth)), won);
    EXPECT_GE(won, 24) << name_of(truth);
  }
}

}  // namespace
}  // namespace slackwater::calibration::form_weights_test

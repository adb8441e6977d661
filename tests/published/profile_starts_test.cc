#include "tests/published/profile_starts.h"

#include <gtest/gtest.h>

#include "calibration/solve/parameter_set.h"
#include "tests/published/synthetic_profile.h"

namespace slackwater::calibration::tests::profile_starts_test {
namespace {

/// The cost as the Ceres problem defines it, summed here term by term.
double cost_of(ProfileForm form, const std::vector<ProfileLevel>& levels, double sigma_m_s,
               const ProfileEstimate& estimate) {
  double squares = 0;
  for (const ProfileLevel& level : levels) {
    double r[2];
    EXPECT_TRUE(
        (ProfileLevelResidual{form, level, sigma_m_s, true}.operator()(estimate.data(), r)));
    squares += r[0] * r[0] + r[1] * r[1];
  }
  const auto parameters = profile_parameters(form, mid_latitude);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const double r = prior_of(parameters[i]).residual(estimate[i]);
    squares += r * r;
  }
  return 0.5 * squares;
}

TEST(ProfileStarts, ClosedFormCostIsThatOfTheFit) {
  for (const ProfileForm form : profile_forms) {
    const auto levels = plain_levels(form);
    for (const ProfileStart& start : profile_starts(form, mid_latitude, levels, 0.01, 5)) {
      EXPECT_NEAR(start.cost, cost_of(form, levels, 0.01, start.estimate), 1e-9 * (1 + start.cost));
    }
  }
}

TEST(ProfileStarts, VectorsAreTheBestForTheirLengths) {
  for (const ProfileForm form : profile_forms) {
    const auto levels = plain_levels(form);
    const ProfileStart start = profile_starts(form, mid_latitude, levels, 0.01, 1).front();
    for (const std::size_t i : {interior_at + 0UL, slab_at + 1UL, spiral_at + 0UL}) {
      for (const double nudge : {-1e-3, 1e-3}) {
        ProfileEstimate moved = start.estimate;
        moved[i] += nudge;
        EXPECT_GT(cost_of(form, levels, 0.01, moved), start.cost) << i;
      }
    }
  }
}

TEST(ProfileStarts, BestOneHasTheDepthOfTheBaseWithinAStepOfTheGrid) {
  for (const ProfileForm form : profile_forms) {
    const auto starts = profile_starts(form, mid_latitude, plain_levels(form), 1e-3, 5);
    ASSERT_FALSE(starts.empty());
    EXPECT_NEAR(std::exp(starts.front().estimate[log_base_depth_at]), 52.0, 0.12 * 52.0);
    for (std::size_t i = 1; i < starts.size(); ++i) EXPECT_LE(starts[i - 1].cost, starts[i].cost);
  }
}

}  // namespace
}  // namespace slackwater::calibration::tests::profile_starts_test

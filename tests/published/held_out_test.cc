#include "tests/published/held_out.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/published/synthetic_profile.h"

namespace slackwater::calibration::tests::held_out_test {
namespace {

std::vector<std::size_t> places(const std::vector<bool>& trains) {
  std::vector<std::size_t> at;
  for (std::size_t i = 0; i < trains.size(); ++i) {
    if (trains[i]) at.push_back(i);
  }
  return at;
}

TEST(HeldOut, EveryOtherLevelTrainsAndTheTopAndTheDeepestAlways) {
  EXPECT_EQ(places(training_levels(8, 0)), (std::vector<std::size_t>{0, 2, 4, 6, 7}));
  EXPECT_EQ(places(training_levels(8, 1)), (std::vector<std::size_t>{0, 1, 3, 5, 7}));
  EXPECT_EQ(places(training_levels(9, 0)), (std::vector<std::size_t>{0, 2, 4, 6, 8}));
  EXPECT_EQ(places(training_levels(9, 1)), (std::vector<std::size_t>{0, 1, 3, 5, 7, 8}));
}

TEST(HeldOut, EveryInnerLevelIsHeldOutOnceAndOnlyOnce) {
  for (const std::size_t n : {9U, 24U, 35U}) {
    const auto even = training_levels(n, 0);
    const auto odd = training_levels(n, 1);
    for (std::size_t i = 1; i + 1 < n; ++i) EXPECT_NE(even[i], odd[i]) << i;
  }
}

TEST(HeldOut, AProfileOfTheFamilyIsPredictedWhereItWasNotSeen) {
  for (const ProfileForm form : profile_forms) {
    const auto score = score_held_out_levels(plain_levels(form), mid_latitude,
                                             {.form = std::nullopt, .sigma_m_s = 1e-5});
    EXPECT_GT(score.gain(), 0.999);
  }
}

TEST(HeldOut, ConstantIsTheMeanOfTheTrainingLevels) {
  // A current of 1 m/s at the last of nine levels: of five and of six that train, so the constants
  // are 1/5 and 1/6, and every held-out level is 0.
  std::vector<ProfileLevel> levels;
  for (int i = 0; i < 9; ++i) levels.push_back({10.0 * i, {i == 8 ? 1.0 : 0.0, 0.0}});
  const double expected = std::sqrt((1.0 / 25 + 1.0 / 36) / 2);
  EXPECT_NEAR(score_held_out_levels(levels, mid_latitude).eps_constant_m_s, expected, 1e-12);
}

TEST(HeldOut, RefusesTooFewLevelsAndLevelsOutOfOrder) {
  auto levels = plain_levels(ProfileForm::free_scales);
  EXPECT_THROW(static_cast<void>(score_held_out_levels({levels.data(), 8}, mid_latitude)), Error);
  std::swap(levels[2], levels[3]);
  EXPECT_THROW(static_cast<void>(score_held_out_levels(levels, mid_latitude)), Error);
}

}  // namespace
}  // namespace slackwater::calibration::tests::held_out_test

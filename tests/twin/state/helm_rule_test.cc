#include "twin/state/helm_rule.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>

namespace slackwater::twin::helm_rule_test {
namespace {

constexpr HelmRule rule{1, 60};

HelmMode mode_at(HelmMode mode, HelmCause cause, double since_s, double renewed_s, double now_s) {
  return helm_due(rule, mode, cause, since_s, renewed_s, now_s).mode;
}

TEST(HelmRule, VelocityAndThrustersHoldOneSecondAfterTheirLastCommand) {
  for (const HelmMode mode : {HelmMode::velocity, HelmMode::thrusters}) {
    EXPECT_EQ(mode_at(mode, HelmCause::asked, 0, 7, 7.95), mode);
    const HelmDue due = helm_due(rule, mode, HelmCause::asked, 0, 7, 8);
    EXPECT_EQ(due.mode, HelmMode::hold);
    EXPECT_EQ(due.cause, HelmCause::not_renewed);
  }
}

TEST(HelmRule, IsDueAtTheSameStepHoweverTheStepsRound) {
  // Times of a run are a number of steps times their length.
  for (const int per_s : {10, 20, 100, 50}) {
    const double step_s = 1.0 / per_s;
    for (int renewed = 0; renewed < 5000; renewed += 7) {
      const auto at = [&](int steps) { return static_cast<double>(steps) * step_s; };
      ASSERT_EQ(
          mode_at(HelmMode::velocity, HelmCause::asked, 0, at(renewed), at(renewed + per_s - 1)),
          HelmMode::velocity);
      ASSERT_EQ(mode_at(HelmMode::velocity, HelmCause::asked, 0, at(renewed), at(renewed + per_s)),
                HelmMode::hold)
          << renewed << " of " << step_s;
    }
  }
}

TEST(HelmRule, AHoldForWantOfAHelmIsLeftForHome) {
  for (const HelmCause cause : {HelmCause::not_renewed, HelmCause::client_lost}) {
    EXPECT_EQ(mode_at(HelmMode::hold, cause, 10, 10, 69.9), HelmMode::hold);
    const HelmDue due = helm_due(rule, HelmMode::hold, cause, 10, 10, 70);
    EXPECT_EQ(due.mode, HelmMode::home);
    EXPECT_EQ(due.cause, HelmCause::held_too_long);
    const HelmRule never{1, 0};
    EXPECT_EQ(helm_due(never, HelmMode::hold, cause, 10, 10, 1e6).mode, HelmMode::hold);
  }
}

TEST(HelmRule, WhatWasAskedForLastsForEver) {
  for (const HelmCause cause : {HelmCause::asked, HelmCause::list_done})
    EXPECT_EQ(mode_at(HelmMode::hold, cause, 0, 0, 1e6), HelmMode::hold);
  for (const HelmMode mode : {HelmMode::own, HelmMode::waypoints, HelmMode::home})
    EXPECT_EQ(mode_at(mode, HelmCause::asked, 0, 0, 1e6), mode);
}

TEST(HelmRule, EachModeAndCauseHasAName) {
  for (int i = 0; i <= static_cast<int>(HelmMode::home); ++i)
    EXPECT_NE(std::string(name_of(static_cast<HelmMode>(i))), "unknown");
  for (int i = 0; i <= static_cast<int>(HelmCause::reserve); ++i)
    EXPECT_NE(std::string(name_of(static_cast<HelmCause>(i))), "unknown");
}

}  // namespace
}  // namespace slackwater::twin::helm_rule_test

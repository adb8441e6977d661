#include "twin/risk/workability/phase_plan.h"

#include <gtest/gtest.h>

namespace slackwater::tests::phase_plan_test {
namespace {

using twin::Phase;
using twin::PhasePlan;
using twin::PhaseSet;
using twin::StepRanges;

PhaseSet only(Phase phase) {
  PhaseSet set;
  set.bits = 0;
  set.add(phase);
  return set;
}

const PhasePlan plan{
    {{Phase::launch, 600}, {Phase::work, 3600}, {Phase::return_home, 900}, {Phase::recovery, 300}}};

TEST(PhasePlan, APhaseCountsAtTheStepsThatItTouches) {
  // Steps of ten minutes: the way home from 70 to 85 min touches the eighth and half of the ninth.
  EXPECT_EQ(steps_of(plan, only(Phase::launch), 0, 600), (StepRanges{{0, 1}}));
  EXPECT_EQ(steps_of(plan, only(Phase::work), 0, 600), (StepRanges{{1, 7}}));
  EXPECT_EQ(steps_of(plan, only(Phase::return_home), 0, 600), (StepRanges{{7, 9}}));
  EXPECT_EQ(steps_of(plan, only(Phase::recovery), 0, 600), (StepRanges{{8, 9}}));
  EXPECT_EQ(steps_of(plan, only(Phase::transit), 0, 600), StepRanges{});
}

TEST(PhasePlan, AllPhasesAreOneStretchFromTheStartToTheEnd) {
  EXPECT_EQ(steps_of(plan, PhaseSet(), 0, 600), (StepRanges{{0, 9}}));
  EXPECT_EQ(steps_of(plan, PhaseSet(), 1800, 600), (StepRanges{{0, 12}}));
}

TEST(PhasePlan, ADelayMovesTheEndOfAPhaseNotItsBeginning) {
  EXPECT_EQ(steps_of(plan, only(Phase::recovery), 1200, 600), (StepRanges{{8, 11}}));
  EXPECT_EQ(steps_of(plan, only(Phase::launch), 1200, 600), (StepRanges{{0, 3}}));
}

TEST(PhasePlan, APhaseThatComesAgainCountsEachTime) {
  const PhasePlan twice{{{Phase::transit, 600}, {Phase::work, 1200}, {Phase::transit, 600}}};
  EXPECT_EQ(steps_of(twice, only(Phase::transit), 0, 600), (StepRanges{{0, 1}, {3, 4}}));
  // A contingency that fills the gap leaves one stretch.
  EXPECT_EQ(steps_of(twice, only(Phase::transit), 1200, 600), (StepRanges{{0, 6}}));
}

TEST(PhasePlan, IsDrawnOutInItsWork) {
  const PhasePlan longer = stretched(plan, 2 * 3600);
  EXPECT_NEAR(longer.duration_s(), 2 * 3600, 1e-9);
  EXPECT_NEAR(longer.phases[1].duration_s, 2 * 3600 - 1800, 1e-9);
  EXPECT_EQ(longer.phases[0].duration_s, 600);
  EXPECT_EQ(stretched(plan, 60).duration_s(), plan.duration_s()) << "never shortened";
  const PhasePlan none{{{Phase::transit, 600}}};
  EXPECT_EQ(stretched(none, 900).phases.back().phase, Phase::work);
  EXPECT_NEAR(stretched(none, 900).duration_s(), 900, 1e-9);
}

}  // namespace
}  // namespace slackwater::tests::phase_plan_test

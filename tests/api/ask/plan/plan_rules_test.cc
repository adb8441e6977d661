// What a plan may not do, judged twice by code that shares no line.
#include "api/ask/plan/plan_rules.h"

#include <gtest/gtest.h>

#include "api/ask/plan/charging.h"
#include "api/ask/plan/make_plan.h"
#include "tests/api/ask/plan/plan_days.h"

namespace slackwater::tests::plan_rules_test {
namespace {

using namespace slackwater::api;

std::size_t any(Rng& random, std::size_t count) {
  return static_cast<std::size_t>(random.uniform() * static_cast<double>(count));
}

/// Anything at all, right or wrong.
std::vector<Assignment> any_assignments(const PlanProblem& day, Rng& random) {
  std::vector<Assignment> all;
  for (std::size_t n = 1 + any(random, 3); n > 0; --n) {
    Assignment one;
    one.job = any(random, day.jobs.size());
    if (day.jobs[one.job].starts.empty()) continue;
    one.start = any(random, day.jobs[one.job].starts.size());
    one.vessel = any(random, day.vessels.size());
    one.crew = any(random, day.crews.size());
    for (const auto& kinds : day.jobs[one.job].vehicles) {
      const auto fit = vehicles_of(day, one.vessel, kinds);
      one.vehicles.push_back(fit.empty() || random.uniform() < 0.05
                                 ? any(random, day.vehicles.size())
                                 : fit[any(random, fit.size())]);
    }
    all.push_back(std::move(one));
  }
  sort_by_time(day, all);
  return all;
}

TEST(PlanRules, TwoJudgesAgreeOnAnyPlan) {
  Rng random(2025, "plan/any plans");
  int right = 0;
  int wrong = 0;
  for (int i = 0; i < 4000; ++i) {
    const PlanProblem day = small_random_day(random);
    const std::vector<Assignment> all = any_assignments(day, random);
    std::vector<Charge> charges = earliest_charges(day, all);
    if (!charges.empty() && random.uniform() < 0.2) charges.front().slot -= 1;
    const std::string other = what_is_wrong(day, all, charges);
    const auto breach = breach_in(day, all, charges);
    ASSERT_EQ(breach.has_value(), !other.empty()) << "day " << i << ": " << other << "; rule "
                                                  << (breach ? static_cast<int>(breach->rule) : -1);
    (breach ? wrong : right) += 1;
  }
  EXPECT_GT(right, 200);
  EXPECT_GT(wrong, 200);
}

TEST(PlanRules, EveryPlanIsRightAndAnythingTakenTwiceIsSeen) {
  Rng random(2025, "plan/planted");
  int planted = 0;
  for (int i = 0; i < 6; ++i) {
    const PlanProblem day = farm_day(8, 4, random);
    const Plan plan = make_plan(day, 0.5);
    ASSERT_EQ(what_is_wrong(day, plan.assignments, plan.charges), "");
    for (std::size_t a = 0; a < plan.assignments.size(); ++a) {
      // Another job at the same hour by the same people.
      std::vector<Assignment> twice = plan.assignments;
      twice.push_back(plan.assignments[a]);
      EXPECT_NE(what_is_wrong(day, twice, plan.charges), "");
      EXPECT_TRUE(breach_in(day, twice, plan.charges));
      ++planted;
    }
  }
  EXPECT_GT(planted, 15);
}

}  // namespace
}  // namespace slackwater::tests::plan_rules_test

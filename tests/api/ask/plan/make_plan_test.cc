// Plans against all plans there are, on days small enough to try them all; and what stands of them
// on large ones.
#include "api/ask/plan/make_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "api/ask/plan/greedy_plan.h"
#include "api/ask/plan/plan_answer.h"
#include "api/ask/plan/plan_rules.h"
#include "tests/api/ask/plan/plan_days.h"
#include "tests/support/asked_number.h"

namespace slackwater::tests::make_plan_test {
namespace {

using namespace slackwater::api;

constexpr std::uint64_t seed = 2025;

TEST(MakePlan, IsTheBestOfAllPlansOnSmallDays) {
  const int days = slackwater::tests::asked_number("SLACKWATER_SMALL_DAYS", 80);
  Rng random(seed, "plan/small days");
  int of_chance = 0;
  int beyond_greedy = 0;
  int with_charges = 0;
  for (int i = 0; i < days; ++i) {
    SCOPED_TRACE("day " + std::to_string(i) + " of seed " + std::to_string(seed));
    const PlanProblem day = small_random_day(random);
    const Plan plan = make_plan(day, 60);
    ASSERT_EQ(what_is_wrong(day, plan.assignments, plan.charges), "");
    const double best = best_value_by_trying(day);
    ASSERT_NEAR(plan.value, best, 1e-9);
    ASSERT_TRUE(plan.is_proven);
    ASSERT_EQ(plan.bound, plan.value);
    ASSERT_EQ(plan.assignments.size() + plan.left.size(), day.jobs.size());
    for (const LeftJob& left : plan.left) ASSERT_NE(left.why, "");
    of_chance += day.least_probability > 0 ? 1 : 0;
    beyond_greedy += value_of(day, greedy_draft(day).assignments) < best - 1e-9 ? 1 : 0;
    with_charges += plan.charges.empty() ? 0 : 1;
  }
  // The days ask for something.
  EXPECT_GT(of_chance, days / 5);
  EXPECT_GT(beyond_greedy, days / 10);
  EXPECT_GT(with_charges, days / 10);
}

TEST(MakePlan, IsTheSameEachTime) {
  for (int i = 0; i < 10; ++i) {
    Rng random(seed + 7, "plan/again " + std::to_string(i));
    const PlanProblem day = small_random_day(random);
    const Plan first = make_plan(day, 60);
    const Plan again = make_plan(day, 60);
    EXPECT_EQ(first.assignments, again.assignments);
    EXPECT_EQ(first.charges, again.charges);
    EXPECT_EQ(first.left, again.left);
  }
}

TEST(MakePlan, TellsAtTheTimeLimitWhatNoPlanExceeds) {
  Rng random(seed, "plan/large day");
  const PlanProblem day = farm_day(24, 4, random);
  const Plan plan = make_plan(day, 1);
  EXPECT_EQ(what_is_wrong(day, plan.assignments, plan.charges), "");
  EXPECT_FALSE(plan.is_proven);
  EXPECT_GT(plan.gap(), 0);
  EXPECT_GE(plan.bound, plan.value);
  EXPECT_GE(plan.value, value_of(day, greedy_draft(day).assignments) - 1e-9);
  double all = 0;
  for (const PlanJob& job : day.jobs) all += job.priority;
  EXPECT_LE(plan.bound, all + 1e-6);
  EXPECT_EQ(plan.assignments.size() + plan.left.size(), day.jobs.size());
}

TEST(MakePlan, IsWorthTwiceAsMuchWhereAllPrioritiesAre) {
  Rng random(seed, "plan/twice");
  for (int i = 0; i < 20; ++i) {
    PlanProblem day = small_random_day(random);
    const double once = make_plan(day, 60).value;
    for (PlanJob& job : day.jobs) job.priority *= 2;
    EXPECT_NEAR(make_plan(day, 60).value, 2 * once, 1e-9);
  }
}

TEST(MakePlan, LosesNothingByAnotherCrewAndAnotherPack) {
  Rng random(seed, "plan/more");
  for (int i = 0; i < 20; ++i) {
    PlanProblem day = small_random_day(random);
    const double before = make_plan(day, 60).value;
    day.crews.push_back(day.crews.front());
    day.crews.back().id = "another";
    for (PlanBattery& battery : day.batteries) ++battery.count;
    const Plan plan = make_plan(day, 60);
    EXPECT_EQ(what_is_wrong(day, plan.assignments, plan.charges), "");
    EXPECT_GE(plan.value, before - 1e-9);
  }
}

/// One vessel that lies in the farm, one crew, no vehicles.
PlanProblem plain_day() {
  PlanProblem day;
  day.begin = parse_utc("2025-06-02T00:00:00Z");
  day.places = {"A01", "A02"};
  day.vessels.push_back({"ctv", 1, {0, 1440}, {}, ways_of(2, 20)});
  day.crews.push_back({"crew", {}, {0, 1440}, {}});
  return day;
}

PlanJob plain_job(const std::string& id, std::size_t place, std::vector<JobStart> starts) {
  PlanJob job;
  job.id = id;
  job.place = place;
  job.starts = std::move(starts);
  return job;
}

TEST(MakePlan, GivesUpAProbableStartForTwoJobs) {
  PlanProblem day = plain_day();
  // The first would best begin at 08:00, and the second can then only.
  day.jobs = {plain_job("first", 0, {{28, 0.7, 60, 0}, {32, 0.9, 60, 0}}),
              plain_job("second", 1, {{33, 0.8, 60, 0}, {34, 0.6, 60, 0}})};
  const Plan plan = make_plan(day, 60);
  // 07:00 to 08:00, twenty minutes of way, 08:20: the next slots are 08:15, too early, and 08:30.
  ASSERT_EQ(plan.assignments.size(), 2U);
  EXPECT_EQ(begin_of(day, plan.assignments[0]), 7 * 60);
  EXPECT_EQ(begin_of(day, plan.assignments[1]), 8 * 60 + 30);
  EXPECT_NEAR(plan.value, 0.7 + 0.6, 1e-9);
}

TEST(MakePlan, WorksSideBySideAtOnePlaceWithTwoCrewsAboard) {
  PlanProblem day = plain_day();
  day.jobs = {plain_job("below", 0, {{32, 0.9, 60, 0}}), plain_job("above", 0, {{33, 0.9, 60, 0}})};
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 1U);
  day.crews.push_back({"other", {}, {0, 1440}, {}});
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 1U) << "there is room for one crew";
  day.vessels[0].crews = 2;
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 2U);
  day.jobs[1].place = 1;
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 1U) << "the vessel is at one place";
}

TEST(MakePlan, PutsOneCrewOffAndGoesToAnotherTurbineMeanwhile) {
  PlanProblem day = plain_day();
  day.vessels[0].crews = 2;
  day.crews.push_back({"other", {}, {0, 1440}, {}});
  // Three hours at each of two turbines, 20 minutes apart, begun half an hour after each other.
  day.jobs = {plain_job("first", 0, {{32, 0.9, 180, 0}}),
              plain_job("second", 1, {{35, 0.9, 180, 0}})};
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 1U) << "she stays";
  day.jobs[0].drop_off_min = day.jobs[1].drop_off_min = 15;
  const Plan plan = make_plan(day, 60);
  EXPECT_EQ(plan.assignments.size(), 2U);
  EXPECT_EQ(what_is_wrong(day, plan.assignments, plan.charges), "");
  const auto ways = ways_of_vessel(day, plan.assignments, 0);
  // 08:00 off at A01, 08:45 off at A02, 10:45 back at A01, 11:30 back at A02.
  ASSERT_EQ(ways.size(), 3U);
  EXPECT_EQ(ways[0].leaves, 8 * 60 + 15);
  EXPECT_EQ(ways[0].to, 1U);
  EXPECT_EQ(ways[1].leaves, 9 * 60);
  EXPECT_EQ(ways[1].to, 0U);
  EXPECT_EQ(ways[2].leaves, 11 * 60);
  EXPECT_EQ(ways[2].arrives, 11 * 60 + 20);
  day.jobs[1].drop_off_min = 0;
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 1U) << "one of them keeps her until 11:45";
  day.jobs[0].starts.front().hold_min = 285;
  EXPECT_EQ(make_plan(day, 60).assignments.size(), 2U) << "she is back at A01 in time";
}

TEST(MakePlan, ChargesBetweenTwoDivesWhereThereIsTime) {
  PlanProblem day = plain_day();
  day.chargers = {{"deck", 1}};
  day.batteries = {{"pack", 1, 100, 120, {0}}};
  day.vehicles = {{"rov", "rov", {}, 0, 0}};
  day.jobs = {plain_job("first", 0, {{32, 0.9, 60, 90}}),
              plain_job("second", 0, {{40, 0.9, 60, 90}})};
  for (PlanJob& job : day.jobs) job.vehicles = {{"rov"}};
  // 08:00 to 09:00, charged from 09:00 to 11:00; the second may begin at 10:00 alone.
  Plan plan = make_plan(day, 60);
  ASSERT_EQ(plan.left.size(), 1U);
  EXPECT_NE(plan.left[0].why.find("no pack of pack is charged"), std::string::npos)
      << plan.left[0].why;
  day.jobs[1].starts.push_back({44, 0.9, 60, 90});
  plan = make_plan(day, 60);
  EXPECT_EQ(plan.assignments.size(), 2U);
  ASSERT_FALSE(plan.charges.empty());
  EXPECT_EQ(plan.charges[0], (Charge{0, 0, 36}));
}

TEST(MakePlan, TakesTheEarliestOfEquallyProbableStarts) {
  PlanProblem day = plain_day();
  day.jobs = {plain_job("one", 0, {{20, 0.5, 60, 0}, {24, 0.9, 60, 0}, {40, 0.9, 60, 0}})};
  EXPECT_EQ(begin_of(day, make_plan(day, 60).assignments.at(0)), 6 * 60);
}

TEST(MakePlan, SaysWhyAJobIsLeft) {
  PlanProblem day = plain_day();
  day.least_probability = 0.8;
  day.jobs = {plain_job("done", 0, {{32, 0.9, 60, 0}}),
              plain_job("unlikely", 0, {{32, 0.625, 60, 0}}),
              plain_job("night", 0, {{32, 0.85, 60, 0}}), plain_job("never", 1, {}),
              plain_job("late", 1, {{95, 0.9, 60, 0}})};
  day.jobs[3].without_starts = "it needs daylight (civil)";
  day.crews[0].shift = {360, 1080};
  const Plan plan = make_plan(day, 60);
  ASSERT_EQ(plan.left.size(), 4U);
  EXPECT_EQ(plan.left[0].why, "no start reaches 80 %: the best is 62 % at 08:00");
  EXPECT_EQ(plan.left[1].why, "at 08:00 (85 %) crew are at A01 from 08:00 to 09:00 (done)");
  EXPECT_EQ(plan.left[2].why, "it needs daylight (civil)");
  EXPECT_EQ(plan.left[3].why,
            "its only start, 23:45, with the way out and home do not fit the working hours of any "
            "team that can do it");
}

TEST(MakePlan, OfNothingIsNothing) {
  PlanProblem day = plain_day();
  Plan plan = make_plan(day, 60);
  EXPECT_TRUE(plan.assignments.empty());
  EXPECT_TRUE(plan.is_proven);
  EXPECT_EQ(plan.value, 0);
  EXPECT_EQ(plan.gap(), 0);
  day.jobs = {plain_job("hopeless", 0, {{32, 0.0, 60, 0}})};
  plan = make_plan(day, 60);
  EXPECT_TRUE(plan.assignments.empty());
  EXPECT_EQ(plan.left.at(0).why, "no start has a chance");
}

}  // namespace
}  // namespace slackwater::tests::make_plan_test

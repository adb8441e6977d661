// What changed since an earlier plan, and why.
#include "api/ask/plan/plan_change.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/ask/plan/make_plan.h"
#include "api/door/cli/decide/earlier_plan_file.h"
#include "api/show/plan/plan_json.h"
#include "fields/base/error.h"
#include "tests/api/ask/plan/plan_days.h"

namespace slackwater::tests::plan_change_test {
namespace {

using namespace slackwater::api;

PlanProblem two_jobs() {
  PlanProblem day;
  day.begin = parse_utc("2025-06-02T00:00:00Z");
  day.places = {"A01", "A02"};
  day.vessels.push_back({"ctv", 1, {0, 1440}, {}, ways_of(2, 20)});
  day.crews.push_back({"crew", {}, {0, 1440}, {}});
  for (const std::string place : {"A01", "A02"}) {
    PlanJob job;
    job.id = "cp_anode@" + place;
    job.task = "cp_anode";
    job.place = place == "A01" ? 0 : 1;
    day.jobs.push_back(std::move(job));
  }
  day.jobs[0].starts = {{32, 0.93, 60, 0}, {48, 0.8, 60, 0}};
  day.jobs[1].starts = {{38, 0.9, 60, 0}, {60, 0.5, 60, 0}};
  return day;
}

EarlierPlan printed(const PlanProblem& day) {
  PlanAnswer answer;
  answer.name = "plan";
  answer.site = "farm";
  answer.plan = make_plan(day, 60);
  return parse_earlier_plan(plan_json(day, answer).dump(), "old.json");
}

std::vector<PlanChange> changes(const EarlierPlan& before, const PlanProblem& now) {
  return changes_since(before, now, make_plan(now, 60), "farm");
}

TEST(PlanChanges, AreNoneOfTheSamePlan) {
  const PlanProblem day = two_jobs();
  for (const PlanChange& change : changes(printed(day), day)) {
    EXPECT_EQ(change.kind, PlanChange::Kind::kept);
    EXPECT_EQ(change.why, "");
  }
}

TEST(PlanChanges, SayThatAChanceFellAndWhatItCost) {
  const EarlierPlan before = printed(two_jobs());
  PlanProblem now = two_jobs();
  now.jobs[0].starts[0].probability = 0.41;
  const auto found = changes(before, now);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0], (PlanChange{"cp_anode@A01", PlanChange::Kind::moved,
                                  "from 08:00 to 12:00 (80 %): the chance of 08:00 fell from 93 % "
                                  "to 41 %"}));
  EXPECT_EQ(found[1].kind, PlanChange::Kind::kept);
}

TEST(PlanChanges, SayWhatWasDroppedAddedAndNoLongerAskedFor) {
  PlanProblem day = two_jobs();
  day.least_probability = 0.85;
  day.jobs[1].starts[0].probability = 0.6;
  const EarlierPlan before = printed(day);  // the second is left
  PlanProblem now = two_jobs();
  now.least_probability = 0.85;
  now.jobs[0].starts[0].probability = 0.3;
  now.jobs[0].starts[1].probability = 0.2;
  auto found = changes(before, now);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(
      found[0],
      (PlanChange{"cp_anode@A01", PlanChange::Kind::dropped,
                  "the chance of 08:00 fell from 93 % to 30 %; no start reaches 85 %: the best "
                  "is 30 % at 08:00"}));
  EXPECT_EQ(found[1],
            (PlanChange{
                "cp_anode@A02", PlanChange::Kind::added,
                "at 09:30 (90 %): it was left out before, because no start reaches 85 %: the best "
                "is 60 % at 09:30"}));
  now = two_jobs();
  now.jobs.erase(now.jobs.begin());
  found = changes(printed(two_jobs()), now);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1], (PlanChange{"cp_anode@A01", PlanChange::Kind::no_longer_asked,
                                  "it is no longer in the plan's file"}));
}

TEST(PlanChanges, SayWhoTookOverAndWhatMakesRoomForWhat) {
  const EarlierPlan before = printed(two_jobs());
  PlanProblem now = two_jobs();
  now.crews[0].id = "night watch";
  auto found = changes(before, now);
  EXPECT_EQ(found[0], (PlanChange{"cp_anode@A01", PlanChange::Kind::handed_over,
                                  "from ctv, crew to ctv, night watch: crew is no longer there"}));
  now = two_jobs();
  PlanJob urgent;
  urgent.id = "repair@A02";
  urgent.place = 1;
  urgent.priority = 9;
  urgent.starts = {{32, 0.9, 60, 0}};
  now.jobs.push_back(urgent);
  found = changes(before, now);
  EXPECT_EQ(found[0].kind, PlanChange::Kind::moved);
  EXPECT_NE(found[0].why.find("makes room: crew are at A02 from 08:00 to 09:00 (repair@A02)"),
            std::string::npos)
      << found[0].why;
  EXPECT_EQ(found[2].why, "at 08:00 (90 %): it was not asked for before");
}

TEST(PlanChanges, OfTwoThatChangePlacesAreNotEachOthersReason) {
  const auto swapped = [](double first_now, double second_now) {
    PlanProblem day = two_jobs();
    day.jobs[0].starts = {{32, 0.9, 60, 0}, {48, 0.89, 60, 0}};
    day.jobs[1].starts = {{32, 0.8, 60, 0}, {48, 0.8, 60, 0}};
    const EarlierPlan before = printed(day);
    day.jobs[0].starts[1].probability = first_now;
    day.jobs[1].starts[0].probability = second_now;
    return changes(before, day);
  };
  // The second is better where the first was: that is a reason, and the first makes way.
  auto found = swapped(0.89, 0.99);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].why,
            "from 08:00 to 12:00 (89 %): changes places with cp_anode@A02: the day as a whole is "
            "worth as much or more");
  EXPECT_EQ(found[1].why,
            "from 12:00 to 08:00 (99 %): changes places with cp_anode@A01: its chance is better "
            "now: 99 % against 80 %");
  for (const PlanChange& change : swapped(0.97, 0.8)) {
    EXPECT_EQ(change.why.find("makes room"), std::string::npos) << change.why;
    EXPECT_NE(change.why.find("changes places with cp_anode@A0"), std::string::npos) << change.why;
  }
}

TEST(PlanChanges, AreOfOneSiteAndDay) {
  const auto refused = [](EarlierPlan before) {
    const PlanProblem day = two_jobs();
    try {
      static_cast<void>(changes_since(before, day, {}, "farm"));
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EarlierPlan before = printed(two_jobs());
  before.site = "elsewhere";
  EXPECT_EQ(refused(before), "old.json: found the plan of elsewhere, expected one of farm");
  before = printed(two_jobs());
  before.day += std::chrono::days(1);
  EXPECT_NE(refused(before).find("found the plan of 2025-06-03, expected one of 2025-06-02"),
            std::string::npos);
  EXPECT_THROW(static_cast<void>(parse_earlier_plan(R"({"site": "a"})", "x")), Error);
}

}  // namespace
}  // namespace slackwater::tests::plan_change_test

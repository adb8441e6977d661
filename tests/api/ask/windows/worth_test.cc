// What a start is worth: the chance of its limits, and what flights leave of it.
#include "api/ask/windows/worth.h"

#include <gtest/gtest.h>

namespace slackwater::tests::worth_test {
namespace {

const UtcTime midnight = parse_utc("2025-06-02T00:00:00Z");

api::TaskStart start_of(int minute, double probability, std::size_t flights = 0,
                        std::size_t done = 0) {
  api::TaskStart start;
  start.start = midnight + std::chrono::minutes(minute);
  start.probability = start.worth = probability;
  if (flights == 0) return start;
  api::TwinChance twin;
  twin.flights = flights;
  twin.probability = static_cast<double>(done) / static_cast<double>(flights);
  twin.stopped_by = done < flights ? "the current" : "";
  start.twin = twin;
  return start;
}

TEST(Worth, FlightsThatFailTakeFromAStartThatTheLimitsAllow) {
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 0, 17), 0.5 / 18);
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 12, 25), 12.5 / 26);
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 0, 8), 0.5 / 9) << "eight are enough to see that";
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 0, 1), 0.96) << "one says nothing: up to 0.98";
}

TEST(Worth, WhatFlightsDoNotShutOutStays) {
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.4, 25, 25), 0.4);
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 9, 9), 0.96) << "next_success alone would say 0.95";
  EXPECT_DOUBLE_EQ(api::worth_as_flown(0.96, 16, 17), 0.96) << "no cliff at the first failure";
}

TEST(Worth, AStartThatWasNotFlownIsWorthNoMoreThanItsNeighbours) {
  api::TaskWindows task;
  task.starts = {start_of(0, 0.9, 25, 10), start_of(30, 0.9), start_of(60, 0.8, 17, 17),
                 start_of(90, 0.9), start_of(240, 0.9)};
  api::weigh_by_flights(task, std::chrono::hours(1));
  EXPECT_DOUBLE_EQ(task.starts[0].worth, 10.5 / 26);
  EXPECT_DOUBLE_EQ(task.starts[1].worth, 10.5 / 26) << "half an hour beside failed flights";
  EXPECT_EQ(task.starts[1].flights_stopped_by, "the current");
  EXPECT_DOUBLE_EQ(task.starts[2].worth, 0.8);
  EXPECT_DOUBLE_EQ(task.starts[3].worth, 0.9) << "beside flights that were all done";
  EXPECT_DOUBLE_EQ(task.starts[4].worth, 0.9) << "too far from any";
  EXPECT_EQ(api::best_of(task), &task.starts[3]) << "the first of equals";
}

// Of equal verdicts a start by day is better than one at midnight; a go at night is better than a
// day that is none.
TEST(Worth, TheBestStartIsByDayWhereTheVerdictIsTheSame) {
  api::TaskWindows task;
  task.starts = {start_of(0, 0.97), start_of(30, 0.93), start_of(60, 0.91), start_of(90, 0.6)};
  for (const std::size_t night : {0U, 3U}) task.starts[night].is_by_day = false;
  EXPECT_EQ(api::best_of(task), &task.starts[1]);
  task.starts[1].worth = task.starts[2].worth = 0.89;
  EXPECT_EQ(api::best_of(task), &task.starts[0]);
  task.starts[0].worth = 0.4;
  EXPECT_EQ(api::best_of(task), &task.starts[1]);
  task.starts[3].worth = 0.85;
  task.starts[1].worth = task.starts[2].worth = 0.7;
  EXPECT_EQ(api::best_of(task), &task.starts[3]) << "too much is given up";
}

TEST(Worth, RunsAreMaximalAndKnowTheirRange) {
  api::TaskWindows task;
  task.starts = {start_of(0, 0.95), start_of(30, 0.6), start_of(60, 0.7), start_of(90, 0.2),
                 start_of(120, 0.55)};
  task.starts[2].forbidden = "terns";
  const auto marginal = api::runs_of_worth(task, 0.5, 0.9);
  ASSERT_EQ(marginal.size(), 2U);
  EXPECT_EQ(marginal[0].first, 1U);
  EXPECT_EQ(marginal[0].last, 1U) << "what is forbidden ends a run";
  EXPECT_DOUBLE_EQ(marginal[1].least, 0.55);
  const auto all = api::runs_of_worth(task, 0.5, 2);
  EXPECT_EQ(all[0].last, 1U);
  EXPECT_DOUBLE_EQ(all[0].most, 0.95);
}

TEST(Worth, BetweenStartsTheWorseOfTheTwoCounts) {
  api::TaskWindows task;
  task.starts = {start_of(0, 0.9), start_of(30, 0.9), start_of(60, 0.9)};
  EXPECT_FALSE(api::flights_leave(task, midnight));
  task.starts[1].worth = 0.3;
  EXPECT_FALSE(api::flights_leave(task, midnight));
  EXPECT_DOUBLE_EQ(api::flights_leave(task, midnight + std::chrono::minutes(15)).value(), 0.3);
  EXPECT_DOUBLE_EQ(api::flights_leave(task, midnight + std::chrono::minutes(45)).value(), 0.3);
  EXPECT_FALSE(api::flights_leave(task, midnight + std::chrono::minutes(60)));
}

}  // namespace
}  // namespace slackwater::tests::worth_test

// What a plan promises, held against days whose truth is drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "api/ask/plan/make_plan.h"
#include "tests/api/ask/plan/plan_days.h"
#include "tests/support/asked_number.h"

namespace slackwater::tests::plan_chances_test {
namespace {

using namespace slackwater::api;

/// A day that is calm from one time to another, both uncertain: work is done if it begins and ends
/// in between. All jobs share that weather, so they fail together.
struct Weather {
  double calm_from_min = 0, calm_from_sd = 0;
  double calm_to_min = 0, calm_to_sd = 0;
};

double below(double value, double mean, double sd) {
  return 0.5 * std::erfc(-(value - mean) / sd / std::sqrt(2.0));
}

/// The exact probability: the two are independent.
double chance_of(const Weather& weather, Minute begin, Minute end) {
  return below(begin, weather.calm_from_min, weather.calm_from_sd) *
         (1 - below(end, weather.calm_to_min, weather.calm_to_sd));
}

struct Truth {
  double from = 0, to = 0;
};

Truth drawn(const Weather& weather, Rng& random) {
  return {weather.calm_from_min + weather.calm_from_sd * random.normal(),
          weather.calm_to_min + weather.calm_to_sd * random.normal()};
}

PlanProblem day_in(const Weather& weather, Rng& random) {
  PlanProblem day;
  day.begin = parse_utc("2025-06-02T00:00:00Z");
  day.slot_min = 60;
  day.slots = 24;
  day.places = {"A01", "A02", "A03"};
  day.vessels.push_back({"ctv", 1, {240, 1260}, {}, ways_of(3, 20)});
  day.crews.push_back({"crew", {}, {240, 1260}, {}});
  for (std::size_t j = 0; j < 3; ++j) {
    PlanJob job;
    job.id = "job" + std::to_string(j);
    job.place = j;
    job.priority = 1 + std::floor(random.uniform(0, 3));
    const auto hold = static_cast<Minute>(random.uniform(60, 240));
    for (std::size_t slot = 0; slot < day.slots; ++slot) {
      const Minute begin = day.minute_of(slot);
      job.starts.push_back({slot, chance_of(weather, begin, begin + hold), hold, 0});
    }
    day.jobs.push_back(std::move(job));
  }
  return day;
}

struct Tally {
  int planned = 0;
  int done = 0;
  double promised = 0;
  double worth = 0;     ///< of what was done
  double worth_2 = 0;   ///< squares of its difference from what was promised, by day
  double expected = 0;  ///< the plans' values
};

/// @param overstated  added to each probability, up to 1: planted dishonesty
Tally tally_of(int days, double least, double overstated) {
  Rng random(2025, "plan/truths");
  Tally tally;
  for (int i = 0; i < days; ++i) {
    const Weather weather{random.uniform(300, 500), random.uniform(20, 90),
                          random.uniform(700, 1100), random.uniform(20, 120)};
    PlanProblem day = day_in(weather, random);
    day.least_probability = least;
    for (PlanJob& job : day.jobs)
      for (JobStart& start : job.starts)
        start.probability = std::min(1.0, start.probability + overstated);
    const Plan plan = make_plan(day, 30);
    const Truth truth = drawn(weather, random);
    double worth = 0;
    for (const Assignment& one : plan.assignments) {
      const bool is_done = begin_of(day, one) >= truth.from && end_of(day, one) <= truth.to;
      ++tally.planned;
      tally.promised += start_of(day, one).probability;
      tally.done += is_done ? 1 : 0;
      worth += is_done ? day.jobs[one.job].priority : 0;
      EXPECT_GE(start_of(day, one).probability, least);
    }
    tally.worth += worth;
    tally.worth_2 += (worth - plan.value) * (worth - plan.value);
    tally.expected += plan.value;
  }
  return tally;
}

void expect_to_hold(int days, double least) {
  const Tally tally = tally_of(days, least, 0);
  const double rate = static_cast<double>(tally.done) / tally.planned;
  const double promised = tally.promised / tally.planned;
  // The jobs of a day fail together at worst: as few independent cases as days.
  const double sd = std::sqrt(rate * (1 - rate) / days);
  std::cout << "least " << least << ", " << days << " days: " << tally.planned
            << " planned starts, promised " << promised << ", held " << rate << "\n";
  EXPECT_GT(tally.planned, days / 2);
  EXPECT_GE(rate, least);
  EXPECT_NEAR(rate, promised, 3.3 * sd);
  // What the plans were worth is what came of them.
  const double worth_sd = std::sqrt(tally.worth_2) / days;  // of the mean of a day
  std::cout << "expected " << tally.expected / days << " a day, came " << tally.worth / days
            << "\n";
  EXPECT_NEAR(tally.worth / days, tally.expected / days, 3.3 * worth_sd);
}

/// 500 days; `make soak` looks at 4 000.
TEST(PlanChances, PlannedStartsHoldAsOftenAsIsAskedFor) {
  expect_to_hold(slackwater::tests::asked_number("SLACKWATER_TASK_DAYS", 500), 0.8);
}

TEST(PlanChances, ByExpectedValueAloneWhatComesOfItIsWhatWasExpected) { expect_to_hold(300, 0); }

TEST(PlanChances, PlannedStartsHoldAsOftenAsIsAskedForWhereMuchIs) { expect_to_hold(300, 0.95); }

TEST(PlanChances, ProbabilitiesThatAreTooHighAreSeen) {
  const Tally tally = tally_of(200, 0.8, 0.15);
  const double rate = static_cast<double>(tally.done) / tally.planned;
  EXPECT_LT(rate, tally.promised / tally.planned - 0.02);
}

}  // namespace
}  // namespace slackwater::tests::plan_chances_test

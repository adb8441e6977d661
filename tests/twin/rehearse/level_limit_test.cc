// A limit on the level of the sea: for starts, ahead, and in flight.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/limit_ahead.h"
#include "twin/risk/start_chances.h"

namespace slackwater::tests::level_limit_test {
namespace {

using std::chrono::hours;

const UtcTime start = parse_utc("2025-06-02T06:00:00Z");
constexpr std::size_t members = 5;
constexpr double period_h = 12.42;

/// An ROV that works in still water for a minute and goes home.
std::string rov(const std::string& conduct) {
  return "  - name: rov\n    model: bluerov2_heavy\n"
         "    start: {north_m: 0, east_m: 0, depth_m: 10}\n    speed_m_s: 0.5\n    conduct: " +
         conduct +
         "\n    tasks:\n"
         "      - {do: route, phase: work, waypoints: [{north_m: 30, east_m: 0, depth_m: 10}]}\n"
         "      - {do: route, phase: return, waypoints: [{north_m: 0, east_m: 0, depth_m: 10}]}\n";
}

/// A day of hours in which the level is `level_m` of the hour, known to 0.1 m; nothing: no level.
twin::ReadyRun ready_in(const std::function<double(double)>& level_m, const std::string& conduct,
                        std::size_t member = 0) {
  twin::Scenario scenario = twin::parse_scenario(calm_head(0.05) + rov(conduct), "level.yaml");
  scenario.start = start;
  scenario.member = member;
  twin::Surround surround = surround_of(scenario);
  std::vector<UtcTime> times;
  for (int h = 0; h <= 24; ++h) times.push_back(start + hours(h));
  auto snapshot = std::make_shared<Snapshot>(
      twin::made_up_field(times, {0}, std::vector<Horizontal>(times.size()), {}, surround.site, 60)
          ->snapshot());
  snapshot->members = members;
  for (ForecastColumn& column : snapshot->columns) {
    column.member_m_s.assign((members - 1) * column.current_m_s.size(), {});
    if (!level_m) continue;
    for (int h = 0; h <= 24; ++h) {
      column.sea_level.level_m.push_back(level_m(h));
      column.sea_level.sigma_m.push_back(0.1);
      column.sea_level.source.push_back(DataStatus::modelled);
    }
  }
  surround.field = std::make_shared<Field>(std::move(snapshot));
  return twin::set_up(scenario, surround);
}

double tide_m(double hour) { return 2 * std::cos(2 * constants::pi * hour / period_h); }

const StepClock steps_of_ten_minutes{start, std::chrono::minutes(10), 138};

std::vector<twin::LimitAhead> ahead_of(const std::string& limit) {
  const twin::ReadyRun ready = ready_in(tide_m, "{limits: [{" + limit + ", phases: [work]}]}");
  return twin::limits_ahead(ready, 0, steps_of_ten_minutes, members, nullptr);
}

/// Starts, every ten minutes, from which an hour keeps the limit in the central forecast.
std::vector<std::size_t> open_starts(const twin::LimitAhead& ahead, twin::Bound bound) {
  twin::WatchedLimit watched;
  watched.bound = bound;
  watched.when = {{0, 6}};
  for (const std::vector<double>& values : ahead.members) watched.members.emplace_back(values);
  twin::StartQuestion question;
  question.steps = steps_of_ten_minutes.steps;
  question.members = ahead.members.size();
  question.limits = 1;
  question.starts = {0, 1, question.steps - 6};
  question.watched = {watched};
  std::vector<std::size_t> open;
  const auto chances = twin::start_chances(question);
  for (std::size_t s = 0; s < chances.size(); ++s)
    if (chances[s].by_threshold) open.push_back(s);
  return open;
}

TEST(LevelLimit, ALandingThatNeedsHalfAMetreIsOpenAroundHighWaterAsOneCountsByHand) {
  // 2 m cos(2 pi t / 12.42 h) >= 0.5 m as long as t is within 2.606 h = 156 min of high water: up
  // to 02:36, and from 09:49 to 15:02. An hour of work begins in the first at 00:00 to 01:30, in
  // the second at 09:50 to 14:00.
  const auto ahead = ahead_of("least_sea_surface_height_m: 0.5");
  ASSERT_EQ(ahead.size(), 1U);
  ASSERT_EQ(ahead[0].members.size(), members) << "each has a level of its own";
  std::vector<std::size_t> expected;
  for (std::size_t s = 0; s <= 9; ++s) expected.push_back(s);
  for (std::size_t s = 59; s <= 84; ++s) expected.push_back(s);
  EXPECT_EQ(open_starts(ahead[0], {twin::BoundSide::at_least, 0.5}), expected);
}

TEST(LevelLimit, UnderABridgeItIsOpenAroundLowWater) {
  // 2 m cos(..) <= -1 m from a third of the period, 4.14 h = 248.4 min, to 496.8 min, and again
  // 745.2 min later.
  const auto ahead = ahead_of("sea_surface_height_m: -1");
  ASSERT_EQ(ahead.size(), 1U);
  std::vector<std::size_t> expected;
  for (std::size_t s = 25; s <= 43; ++s) expected.push_back(s);
  for (std::size_t s = 100; s <= 118; ++s) expected.push_back(s);
  EXPECT_EQ(open_starts(ahead[0], {twin::BoundSide::at_most, -1}), expected);
}

TEST(LevelLimit, AheadIsWhatARunOfThatMemberLooksAt) {
  const auto ahead = ahead_of("least_sea_surface_height_m: 0.5");
  std::set<double> different;
  for (std::size_t m = 0; m < members; ++m) {
    const twin::ReadyRun run = ready_in(tide_m, "{limits: [{least_sea_surface_height_m: 0.5}]}", m);
    const twin::Limit& limit = run.agents[0].conduct->plan.limits[0];
    const double from_m = twin::value_of(limit, run.agents[0], 6000, run.states[0]);
    const double to_m = twin::value_of(limit, run.agents[0], 6600, run.states[0]);
    EXPECT_EQ(ahead[0].members[m][10], std::min(from_m, to_m)) << m;
    different.insert(from_m);
    if (m == 0) {
      EXPECT_NEAR(from_m, tide_m(6000 / 3600.0), 0.001);
    }
  }
  EXPECT_EQ(different.size(), members);
}

TEST(LevelLimit, InFlightTheWorkWaitsUntilTheWaterIsThere) {
  // It rises by 6 m/h from 0.2 m: half a metre is there after three minutes.
  twin::ReadyRun ready = ready_in([](double hour) { return 0.2 + 6 * hour; },
                                  "{limits: [{least_sea_surface_height_m: 0.5, phases: [work]}]}");
  twin::Run run(std::move(ready.agents), std::move(ready.states), settings_of(0.05));
  double left_s = -1;
  while (run.time_s() < 1500 && !run.all_ended()) {
    run.step();
    const double north_m = run.states()[0].vehicle.body.position_m.x;
    if (left_s < 0 && north_m > 1) left_s = run.time_s();
  }
  EXPECT_GT(left_s, 180);
  std::size_t holds = 0;
  for (const twin::ConductEvent& event : run.states()[0].conduct.events)
    if (event.kind == twin::ConductEventKind::hold_began) {
      ++holds;
      EXPECT_EQ(event.cause, twin::Cause::limit);
      EXPECT_NEAR(event.value, 0.2, 0.05);
    }
  EXPECT_EQ(holds, 1U);
}

TEST(LevelLimit, WhereTheForecastHasNoneItIsRefusedUnlessSomethingIsSaid) {
  const auto message = [](const std::string& conduct) {
    try {
      (void)ready_in({}, conduct);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string refused = message("{limits: [{least_sea_surface_height_m: 0.5}]}");
  EXPECT_NE(refused.find("level of the sea at least 0.5 m, and the forecast does not serve it "
                         "there; say if_missing: not_checked in the limit, or assume a value, as "
                         "in --assume sea_surface_height_m=..."),
            std::string::npos)
      << refused;
  EXPECT_EQ(message("{limits: [{least_sea_surface_height_m: 0.5, if_missing: not_checked}]}"),
            "no error");
  EXPECT_EQ(message("{limits: [{least_sea_surface_height_m: 0.5}], assume: "
                    "{sea_surface_height_m: 0.8}}"),
            "no error");
  EXPECT_NE(message("{limits: [{sea_surface_height_m: 40}]}").find("40"), std::string::npos);
  EXPECT_EQ(twin::parse_assumption("sea_surface_height_m=-1.5").value, -1.5);
}

TEST(LevelLimit, WhatIsAssumedStandsInForAForecastWithoutAndNotForOneWith) {
  const std::string conduct =
      "{limits: [{least_sea_surface_height_m: 0.5}], assume: {sea_surface_height_m: 0.8}}";
  const twin::ReadyRun without = ready_in({}, conduct), with = ready_in(tide_m, conduct);
  const twin::Limit& limit = without.agents[0].conduct->plan.limits[0];
  EXPECT_EQ(twin::value_of(limit, without.agents[0], 0, without.states[0]), 0.8);
  EXPECT_NEAR(twin::value_of(limit, with.agents[0], 0, with.states[0]), 2, 1e-12);
}

TEST(LevelLimit, ItsShareIsOneAtTheBoundWhateverTheDatum) {
  for (const double bound : {-1.0, 0.0, 0.5}) {
    twin::Limit limit;
    limit.variable = twin::LimitVariable::sea_surface_height;
    limit.bound = bound;
    EXPECT_DOUBLE_EQ(limit.share(bound), 1);
    EXPECT_GT(limit.share(bound + 0.1), 1);
    limit.is_least = true;
    EXPECT_DOUBLE_EQ(limit.share(bound), 1);
    EXPECT_GT(limit.share(bound - 0.1), 1);
  }
}

}  // namespace
}  // namespace slackwater::tests::level_limit_test

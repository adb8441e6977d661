#include "twin/rehearse/planned_work.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "twin/rehearse/limit_ahead.h"

namespace slackwater::tests::planned_work_test {
namespace {

twin::ScenarioTask task_of(twin::Phase phase, const std::vector<twin::Triple<double>>& way_m) {
  twin::ScenarioTask task;
  task.phase = phase;
  for (const auto& position_m : way_m) {
    twin::Waypoint at;
    at.position_m = position_m;
    task.waypoints.push_back(at);
  }
  return task;
}

/// Launched where it stands, down to the bed, round at two depths, up again. Down is positive.
twin::Mission dive() {
  twin::Mission mission;
  mission.tasks = {task_of(twin::Phase::launch, {}), task_of(twin::Phase::transit, {{10, 0, 30}}),
                   task_of(twin::Phase::work, {{12, 2, 30}, {12, -2, 26}}),
                   task_of(twin::Phase::recovery, {})};
  return mission;
}

TEST(ReachIn, AWayIsAsHighAsItComesAndAsLowWhereItDoes) {
  const auto reach = twin::reach_in({0, 5, 1}, dive(), twin::Phase::transit);
  ASSERT_TRUE(reach);
  EXPECT_EQ(reach->highest_m.z, 1) << "from where it stands";
  EXPECT_EQ(reach->highest_m.y, 5);
  EXPECT_EQ(reach->lowest_m.z, 30);
  EXPECT_EQ(reach->lowest_m.x, 10);
  EXPECT_EQ(reach->middle_m.x, 10);
}

TEST(ReachIn, TheMiddleIsThatOfAllPlacesOfThePhase) {
  const auto reach = twin::reach_in({0, 0, 1}, dive(), twin::Phase::work);
  ASSERT_TRUE(reach);
  EXPECT_EQ(reach->middle_m.x, 12);
  EXPECT_EQ(reach->middle_m.y, 0);
  EXPECT_EQ(reach->middle_m.z, 28);
  EXPECT_EQ(reach->highest_m.z, 26);
  EXPECT_EQ(reach->lowest_m.z, 30);
}

TEST(ReachIn, APhaseWithoutAWayIsWhereItStands) {
  const auto launch = twin::reach_in({0, 0, 1}, dive(), twin::Phase::launch);
  ASSERT_TRUE(launch);
  EXPECT_EQ(launch->middle_m.z, 1);
  const auto recovery = twin::reach_in({0, 0, 1}, dive(), twin::Phase::recovery);
  ASSERT_TRUE(recovery);
  EXPECT_EQ(recovery->middle_m.z, 26) << "where its work ended";
  EXPECT_FALSE(twin::reach_in({0, 0, 1}, dive(), twin::Phase::return_home));
}

std::vector<double> degrees_of(const std::vector<twin::Course>& bows) {
  std::vector<double> degrees;
  for (const twin::Course& bow : bows)
    degrees.push_back(std::round(twin::bearing_rad(bow) * 180 / constants::pi));
  return degrees;
}

TEST(ReachIn, ItsBowsAreThoseOfItsLegsOrWhereItStaysOfTheLast) {
  // East to the work, north beside it, and west of there with a stay, as a craft at a landing.
  twin::Mission mission;
  mission.tasks = {task_of(twin::Phase::transit, {{0, 50, 0}}),
                   task_of(twin::Phase::work, {{30, 50, 0}, {30, 10, 0}})};
  EXPECT_EQ(degrees_of(twin::reach_in({0, 0, 0}, mission, twin::Phase::work)->bows),
            (std::vector<double>{0, -90}));
  mission.tasks.push_back(task_of(twin::Phase::work, {}));
  EXPECT_EQ(degrees_of(twin::reach_in({0, 0, 0}, mission, twin::Phase::work)->bows),
            (std::vector<double>{-90}));
  EXPECT_EQ(degrees_of(twin::reach_in({0, 0, 0}, mission, twin::Phase::transit)->bows),
            (std::vector<double>{90}));
  // Straight down there is no course.
  mission.tasks = {task_of(twin::Phase::work, {{0, 0, 20}})};
  EXPECT_TRUE(twin::reach_in({0, 0, 0}, mission, twin::Phase::work)->bows.empty());
}

TEST(ReachIn, UpIsNegativeAndAStayCountsBesideAWay) {
  twin::Mission climb;
  climb.tasks = {task_of(twin::Phase::work, {}), task_of(twin::Phase::transit, {{0, 0, -80}}),
                 task_of(twin::Phase::work, {{5, 0, -60}})};
  const auto reach = twin::reach_in({0, 0, -2}, climb, twin::Phase::work);
  ASSERT_TRUE(reach);
  EXPECT_EQ(reach->highest_m.z, -80) << "where the second stretch of work begins";
  EXPECT_EQ(reach->lowest_m.z, -2) << "where the first one stays";
  EXPECT_EQ(reach->middle_m.z, -60);
}

TEST(PlacesOf, TheCurrentIsLookedAtBetweenTooAndWavesOnce) {
  const twin::PhaseReach reach{{5, 0, 10}, {0, 0, 2}, {10, 0, 32}, {}};
  const std::vector<double> levels{0, 2, 12, 22, 32, 50};
  twin::Limit limit;
  limit.variable = twin::LimitVariable::current_speed;
  const auto places = twin::places_of(limit, reach, levels);
  ASSERT_EQ(places.size(), 4U);
  EXPECT_EQ(places[1].z, 12);
  EXPECT_NEAR(places[1].x, 10.0 / 3, 1e-12) << "on the way from the highest to the lowest";
  limit.down_m = 20;
  EXPECT_EQ(twin::places_of(limit, reach, levels).size(), 1U) << "the limit says where";
  limit.down_m.reset();
  limit.variable = twin::LimitVariable::wind_speed;
  EXPECT_EQ(twin::places_of(limit, reach, levels).size(), 2U);
  limit.variable = twin::LimitVariable::significant_wave_height;
  EXPECT_EQ(twin::places_of(limit, reach, levels).size(), 1U);
}

}  // namespace
}  // namespace slackwater::tests::planned_work_test

#include "twin/rehearse/planned_work.h"

#include <gtest/gtest.h>

namespace slackwater::tests {
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

TEST(PlacesIn, AWayIsLookedAtAsHighAsItComesAndAsLow) {
  const auto places = twin::places_in({0, 0, 1}, dive(), twin::Phase::transit);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].z, 1) << "from where it stands";
  EXPECT_EQ(places[1].z, 30);
  EXPECT_EQ(places[0].x, 10) << "in the middle of the places that it goes to";
}

TEST(PlacesIn, WorkIsWhereItsPlacesAreWithTheWayToThem) {
  const auto places = twin::places_in({0, 0, 1}, dive(), twin::Phase::work);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].z, 26);
  EXPECT_EQ(places[1].z, 30);
  EXPECT_EQ(places[0].y, 0);
}

TEST(PlacesIn, APhaseWithoutAWayIsWhereItStands) {
  const auto launch = twin::places_in({0, 0, 1}, dive(), twin::Phase::launch);
  ASSERT_EQ(launch.size(), 1U);
  EXPECT_EQ(launch[0].z, 1);
  const auto recovery = twin::places_in({0, 0, 1}, dive(), twin::Phase::recovery);
  ASSERT_EQ(recovery.size(), 1U);
  EXPECT_EQ(recovery[0].z, 26) << "where its work ended";
  EXPECT_TRUE(twin::places_in({0, 0, 1}, dive(), twin::Phase::return_home).empty());
}

}  // namespace
}  // namespace slackwater::tests

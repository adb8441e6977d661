#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "fields/base/turn.h"
#include "twin/control/patterns.h"
#include "twin/control/waypoint_follower.h"

namespace slackwater::twin::guidance_test {
namespace {

using constants::pi;

TEST(RouteOfWaypoints, TakesThoseThatAreReachedAndThoseThatArePassedAbeam) {
  const std::vector<Waypoint> points{{{100, 0, 5}}, {{200, 0, 5}}, {{200, 100, 5}}};
  Route route({0, 0, 5}, points);
  EXPECT_EQ(route.advance({50, 0, 5}, 1, 1, 5), 0U);
  EXPECT_EQ(route.advance({100, 0.5, 8}, 1, 1, 0), 0U);  // three metres too deep
  EXPECT_EQ(route.advance({100.1, 4, 5}, 1, 1, 5), 1U);
  EXPECT_EQ(route.from().x, 100);
  EXPECT_NEAR(route.remaining_m({150, 0, 5}), 150, 1e-12);
  EXPECT_EQ(route.advance({200, 0, 5}, 1, 1, 5), 1U);
  EXPECT_EQ(route.advance({200, 100, 5}, 1, 1, 5), 1U);
  EXPECT_TRUE(route.is_done());
  EXPECT_EQ(route.remaining_m({0, 0, 0}), 0);
  EXPECT_TRUE(Route().is_done());
}

TEST(PlaceOnLeg, IsAlongAndToTheRightOfIt) {
  const LegPlace place = place_on_leg({0, 0, 0}, {30, 40, 0}, {30 - 4, 40 + 3, 0});
  EXPECT_NEAR(place.length_m, 50, 1e-12);
  EXPECT_NEAR(place.along_m, 50, 1e-12);
  EXPECT_NEAR(place.across_m, 5, 1e-12);  // right of north-east is south-east
}

TEST(Patterns, ALawnMowerCoversItsRectangleLineByLine) {
  const std::vector<Waypoint> points = lawn_mower({10, 20, 30}, pi / 2, 100, 8, 4, 1.5);
  ASSERT_EQ(points.size(), 8U);
  // Eastward lines, the next to the right, that is south.
  EXPECT_NEAR(points[1].position_m.y, 120, 1e-9);
  EXPECT_NEAR(points[2].position_m.x, 10 - 8, 1e-9);
  EXPECT_NEAR(points[7].position_m.y, 20, 1e-9);
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Triple<double> d = points[i].position_m - points[i - 1].position_m;
    length += std::sqrt(dot(d, d));
  }
  EXPECT_NEAR(length, 4 * 100 + 3 * 8, 1e-9);
}

TEST(Patterns, AnOrbitStaysOnItsCircleWithShortChordsAndSinksEvenly) {
  const std::vector<Waypoint> points = orbit({5, -3, 10}, 4, 0.3, 2, 20, 1, 0.3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Triple<double>& p = points[i].position_m;
    EXPECT_NEAR(std::hypot(p.x - 5, p.y + 3), 4, 1e-12);
    if (i == 0) continue;
    const Triple<double>& q = points[i - 1].position_m;
    EXPECT_LE(std::hypot(p.x - q.x, p.y - q.y), 1 + 1e-12);
    EXPECT_GT(p.z, q.z);
  }
  EXPECT_NEAR(points.back().position_m.z, 20, 1e-12);
  EXPECT_NEAR(points.back().position_m.x, points.front().position_m.x, 1e-9);
  EXPECT_GE(orbit({0, 0, 0}, 1, 0, 1, 0, 100, 1).size(), 4U);  // never less than a triangle
}

TEST(Patterns, ADepthSweepSwingsBetweenItsDepths) {
  const std::vector<Waypoint> points = depth_sweep({0, 0, 25}, pi / 2, 150, 10, 40, 75, 0.5, 0.5);
  double shallow = 99, deep = 0;
  for (const Waypoint& p : points) {
    shallow = std::min(shallow, p.position_m.z);
    deep = std::max(deep, p.position_m.z);
  }
  EXPECT_NEAR(shallow, 10, 0.01);
  EXPECT_NEAR(deep, 40, 0.01);
  EXPECT_NEAR(points.back().position_m.y, 150, 1e-9);
  EXPECT_NEAR(points.back().position_m.z, 25, 1e-9);
}

/// What a follower does to a vehicle that obeys at once.
struct Followed {
  Triple<double> position_m;
  double yaw_rad = 0;
  FollowerState state;
  double travelled_m = 0;

  void run(const WaypointFollower& f, Route& route, double seconds, double dt_s = 0.05) {
    for (int i = 0; i < static_cast<int>(seconds / dt_s); ++i) {
      follow(f, state, route, position_m, yaw_rad, dt_s);
      yaw_rad = wrapped_rad(yaw_rad + state.yaw_rate_rad_s * dt_s);
      position_m.x += state.speed_m_s * std::cos(yaw_rad) * dt_s;
      position_m.y += state.speed_m_s * std::sin(yaw_rad) * dt_s;
      travelled_m += state.speed_m_s * dt_s;
    }
  }
};

/// The figures of twin/docs/operations.md: it stops from 10 m/s in 100 m and turns in 200 m.
TEST(WaypointFollowing, ThePapersLimitsGiveItsStoppingDistanceAndItsTurn) {
  const WaypointFollower paper = paper_follower();
  const double v = paper.most_speed_m_s;
  EXPECT_NEAR(v * v / (2 * paper.acceleration_m_s2), 100, 1e-12);
  EXPECT_NEAR(v / paper.most_yaw_rate_rad_s, 200, 1e-12);
  // Straight ahead: up to 10 m/s, then down over the last 100 m, and there at its least speed.
  const std::vector<Waypoint> ahead{{{1000, 0, 0}}};
  Route route({}, ahead);
  Followed vehicle;
  vehicle.run(paper, route, 200);
  EXPECT_TRUE(route.is_done());
  EXPECT_NEAR(vehicle.position_m.x, 1000, 2);
  EXPECT_EQ(vehicle.state.speed_m_s, 0);
}

TEST(WaypointFollowing, ThePapersSettingsCircleAWaypointThatIsNearAndAbeamOursReachIt) {
  const std::vector<Waypoint> abeam{{{400, 0, 0}, 10}, {{400, 60, 0}, 10}};
  Route for_paper({}, abeam);
  Followed circling;
  circling.run(paper_follower(), for_paper, 1200);
  EXPECT_FALSE(for_paper.is_done());
  WaypointFollower ours = paper_follower();
  ours.slows_to_turn = true;
  ours.least_speed_m_s = 0;
  Route for_ours({}, abeam);
  Followed arriving;
  arriving.run(ours, for_ours, 1200);
  EXPECT_TRUE(for_ours.is_done());
}

TEST(WaypointFollowing, OursReachesEveryWaypointOfManyRandomRoutes) {
  Rng random(3, "tests/routes");
  for (int n = 0; n < 30; ++n) {
    std::vector<Waypoint> points;
    for (int i = 0; i < 5; ++i)
      points.push_back({{random.uniform(-60, 60), random.uniform(-60, 60), 0}, 2});
    Route route({}, points);
    Followed vehicle;
    vehicle.yaw_rad = random.uniform(-pi, pi);
    vehicle.run({}, route, 1500);
    EXPECT_TRUE(route.is_done()) << "route " << n << ", next " << route.next();
  }
}

TEST(BoundedPid, DoesNotWindUpAtItsBound) {
  const Pid pid{1, 1, 0, 2};
  PidState state;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(output_of(pid, state, 10, 0, 0.1), 2);
  EXPECT_LT(output_of(pid, state, -0.5, 0, 0.1), 0);
}

}  // namespace
}  // namespace slackwater::twin::guidance_test

#include <gtest/gtest.h>

#include <chrono>

#include "fields/base/numbers/random.h"
#include "tests/twin/control/closed_loop.h"
#include "twin/control/guidance.h"
#include "twin/control/patterns.h"

namespace slackwater::twin::route_following_test {
namespace {

using constants::pi;

/// Follows a route to its end. @return whether it came there in time
bool follow(tests::ClosedLoop& loop, const Guidance& guidance, Route& route, double most_s) {
  const double end_s = loop.t_s + most_s;
  while (loop.t_s < end_s) {
    loop.step(reference_along(guidance, route, loop.measured()));
    if (route.is_done()) return true;
  }
  return false;
}

struct Traveller {
  const char* name;
  tests::ClosedLoop (*make)();
  double speed_m_s;
  double leg_m;  ///< of random routes
};
const Traveller travellers[] = {{"rov", tests::bluerov2, 0.8, 15},
                                {"auv", tests::lrauv, 1.0, 150},
                                {"uav", tests::x500, 8, 60},
                                {"usv", tests::usv, 1.8, 60},
                                {"vessel", tests::vessel, 7, 500}};

double length_m(const Triple<double>& start, const std::vector<Waypoint>& points) {
  return Route(start, points).remaining_m(start);
}

TEST(RouteFollowing, ComesToTheEndOfEveryRandomRouteInACurrentOfSixTenthsOfItsSpeed) {
  for (const Traveller& who : travellers) {
    for (int k = 0; k < 8; ++k) {
      Rng random(static_cast<std::uint64_t>(k), std::string("tests/routes/") + who.name);
      tests::ClosedLoop loop = who.make();
      const double share = k % 2 == 0 ? 0.6 : random.uniform(0, 0.6);
      const double towards = random.uniform(-pi, pi);
      loop.fluid_m_s = {share * who.speed_m_s * std::cos(towards),
                        share * who.speed_m_s * std::sin(towards), 0};
      if (k % 3 == 0) loop.known_m_s = loop.fluid_m_s;
      std::vector<Waypoint> points;
      Triple<double> at = loop.state.position_m;
      for (int i = 0; i < 5; ++i) {
        // Sharp corners, near waypoints and all.
        const double leg = who.leg_m * (i == 2 ? 0.15 : random.uniform(0.5, 1));
        const double bearing = random.uniform(-pi, pi);
        at = at + Triple<double>{leg * std::cos(bearing), leg * std::sin(bearing), 0};
        if (std::string(who.name) != "usv" && std::string(who.name) != "vessel")
          at.z += random.uniform(-0.05, 0.05) * leg;
        points.push_back({at, 0});
      }
      Route route(loop.state.position_m, points);
      const Guidance guidance = guidance_for(loop.autopilot, who.speed_m_s);
      // Against the current 0.4 of the speed is left; twice that for corners.
      const double most_s =
          2 * (length_m(loop.state.position_m, points) + 5 * guidance.passing_m + 20) /
          (0.4 * who.speed_m_s);
      EXPECT_TRUE(follow(loop, guidance, route, most_s))
          << who.name << " " << k << " at waypoint " << route.next();
    }
  }
}

TEST(RouteFollowing, HoldsTheLegInACrossCurrent) {
  for (const Traveller& who : travellers) {
    for (const bool knows : {false, true}) {
      tests::ClosedLoop loop = who.make();
      const double current = 0.4 * who.speed_m_s;
      loop.fluid_m_s = {0, current, 0};
      if (knows) loop.known_m_s = loop.fluid_m_s;
      Triple<double> end = loop.state.position_m;
      end.x += 400 * who.speed_m_s;
      const std::vector<Waypoint> points{{end, 0}};
      Route route(loop.state.position_m, points);
      const Guidance guidance = guidance_for(loop.autopilot, who.speed_m_s);
      double worst = 0;
      for (double t = 0; t < 300; t += loop.dt_s) {
        loop.step(reference_along(guidance, route, loop.measured()));
        if (t > 250) worst = std::max(worst, std::abs(loop.state.position_m.y));
      }
      // Half a percent of what the current alone would have made of it.
      EXPECT_LT(worst, 0.005 * 300 * current) << who.name << knows;
    }
  }
}

TEST(RouteFollowing, MowsALawnWithinHalfAMetreOfItsLines) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.fluid_m_s = {0.15, 0.1, 0};
  const std::vector<Waypoint> points = lawn_mower({0, 0, 20}, 0.5, 20, 2, 4, 0.4);
  Route route(loop.state.position_m, points);
  const Guidance guidance = guidance_for(loop.autopilot, 0.4);
  double worst = 0;
  while (!route.is_done() && loop.t_s < 1000) {
    loop.step(reference_along(guidance, route, loop.measured()));
    if (loop.t_s > 60)
      worst = std::max(
          worst,
          std::abs(
              place_on_leg(route.from(), route.to().position_m, loop.state.position_m).across_m));
  }
  EXPECT_TRUE(route.is_done());
  EXPECT_LT(worst, 0.5);
}

TEST(RouteFollowing, OrbitsAFoundationOnItsCircle) {
  tests::ClosedLoop loop = tests::bluerov2();
  const std::vector<Waypoint> points = orbit({8, 0, 15}, 8, pi, 2, 25, 0.8, 0.4);
  Route route(loop.state.position_m, points);
  double worst = 0;
  while (!route.is_done() && loop.t_s < 1000) {
    loop.step(reference_along(guidance_for(loop.autopilot, 0.4), route, loop.measured()));
    if (loop.t_s > 60) {
      const double away = std::hypot(loop.state.position_m.x - 8, loop.state.position_m.y);
      worst = std::max(worst, std::abs(away - 8));
    }
  }
  EXPECT_TRUE(route.is_done());
  EXPECT_LT(worst, 0.6);
}

TEST(RouteFollowing, StaysAtTheEndOfItsRoute) {
  for (const Traveller& who : travellers) {
    tests::ClosedLoop loop = who.make();
    loop.fluid_m_s = {0.1 * who.speed_m_s, 0.15 * who.speed_m_s, 0};
    Triple<double> end = loop.state.position_m;
    end.x += who.leg_m;
    const std::vector<Waypoint> points{{end, 0}};
    Route route(loop.state.position_m, points);
    const Guidance guidance = guidance_for(loop.autopilot, who.speed_m_s);
    ASSERT_TRUE(follow(loop, guidance, route, 1000)) << who.name;
    for (int i = 0; i < 12000; ++i) loop.step(reference_along(guidance, route, loop.measured()));
    const double away = std::hypot(loop.state.position_m.x - end.x, loop.state.position_m.y);
    // An AUV circles it.
    EXPECT_LT(away, loop.autopilot.kind == VehicleKind::auv ? 45 : 0.02 * who.leg_m + 0.5)
        << who.name;
  }
}

TEST(RouteFollowing, TakesANewRouteAtAnyStep) {
  for (const Traveller& who : travellers) {
    tests::ClosedLoop loop = who.make();
    const Triple<double> start = loop.state.position_m;
    const std::vector<Waypoint> first{{start + Triple<double>{10 * who.leg_m, 0, 0}, 0}};
    Route route(start, first);
    const Guidance guidance = guidance_for(loop.autopilot, who.speed_m_s);
    EXPECT_FALSE(follow(loop, guidance, route, 40));
    const std::vector<Waypoint> second{{start + Triple<double>{0, -who.leg_m, 0}, 0}};
    route = Route(loop.state.position_m, second);
    EXPECT_TRUE(follow(loop, guidance, route, 40 * who.leg_m / who.speed_m_s)) << who.name;
    EXPECT_LT(std::hypot(loop.state.position_m.x - start.x,
                         loop.state.position_m.y - start.y + who.leg_m),
              guidance.passing_m + guidance.tolerance_m);
  }
}

}  // namespace
}  // namespace slackwater::twin::route_following_test

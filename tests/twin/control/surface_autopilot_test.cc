#include <gtest/gtest.h>

#include <limits>

#include "fields/base/turn.h"
#include "tests/twin/control/closed_loop.h"

namespace slackwater::twin::surface_autopilot_test {
namespace {

using constants::pi;

Reference cruise(double speed_m_s, double yaw_rad) {
  Reference reference;
  reference.target = Target::cruise;
  reference.velocity_m_s.x = speed_m_s;
  reference.heading = course_of(yaw_rad);
  return reference;
}

double away_m(const tests::ClosedLoop& loop) {
  return std::hypot(loop.state.position_m.x, loop.state.position_m.y);
}

TEST(SurfaceAutopilot, MakesItsSpeedThroughTheWaterWithTheThrustOfItsDrag) {
  tests::ClosedLoop loop = tests::usv();
  loop.run(cruise(2, 0), 120);
  EXPECT_NEAR(loop.velocity_m_s().x, 2, 0.01);
  EXPECT_NEAR(loop.effort.thrust_n[0] + loop.effort.thrust_n[1], 51.3 * 2 + 72.4 * 4, 3);
  tests::ClosedLoop vessel = tests::vessel();
  vessel.run(cruise(10, 0), 300);
  EXPECT_NEAR(vessel.velocity_m_s().x, 10, 0.05);
}

TEST(SurfaceAutopilot, KnowsWhatHoldsItStraightByEitherWordForIt) {
  const auto planned = [](const Body& body) {
    const auto mounts = tests::wamv_mounts();
    const auto ranges = tests::outboard_ranges();
    return plan_autopilot(default_autopilot(VehicleKind::usv), VehicleKind::usv, body,
                          {mounts, ranges, {}, {}, {}, 0.3});
  };
  const Body by_edge = tests::body_from_data("wamv16");
  Body by_lift = by_edge;
  by_lift.trailing_edge_kg_m = by_lift.trailing_edge_x_m = 0;
  by_lift.speed_lift.is_there = true;
  by_lift.speed_lift.n_ur = -34 * 2.45 * 2.45;
  EXPECT_NEAR(planned(by_edge).straightening_kg_m, 34 * 2.45 * 2.45, 1e-9);
  EXPECT_NEAR(planned(by_lift).straightening_kg_m, 34 * 2.45 * 2.45, 1e-9);
  EXPECT_NEAR(tightest_turn_m(planned(by_lift), 2), tightest_turn_m(planned(by_edge), 2), 1e-9);
  // Besides acts -M_A26 u r of the added mass (C_A), unless the source leaves it out.
  by_lift.added_mass.entry[1][5] = by_lift.added_mass.entry[5][1] = 20;
  EXPECT_NEAR(planned(by_lift).straightening_kg_m, 34 * 2.45 * 2.45 + 20, 1e-9);
  by_lift.speed_lift.without_munk = true;
  EXPECT_NEAR(planned(by_lift).straightening_kg_m, 34 * 2.45 * 2.45, 1e-9);
}

TEST(SurfaceAutopilot, TurnsToAHeadingWithLittleOvershoot) {
  for (const double step : {0.3, 1.5, 3.0, -2.0}) {
    for (const bool is_large : {false, true}) {
      tests::ClosedLoop loop = is_large ? tests::vessel() : tests::usv();
      const double speed = is_large ? 6 : 1.2;
      loop.run(cruise(speed, 0), 120);
      double most = 0;
      for (int i = 0; i < 6000; ++i) {
        loop.step(cruise(speed, step));
        const double turned = loop.yaw_rad() * (step < 0 ? -1 : 1);
        if (turned > -1) most = std::max(most, turned);
      }
      EXPECT_LT(most, 1.2 * std::abs(step)) << step << is_large;
      EXPECT_NEAR(wrapped_rad(loop.yaw_rad() - step), 0, 0.02) << step << is_large;
      EXPECT_NEAR(std::hypot(loop.velocity_m_s().x, loop.velocity_m_s().y), speed, 0.05 * speed);
    }
  }
}

TEST(SurfaceAutopilot, KeepsItsStationPointingIntoACurrentItDoesNotKnow) {
  for (const double bearing : {0.0, 2.0, -2.6}) {
    tests::ClosedLoop loop = tests::usv();
    loop.fluid_m_s = {0.5 * std::cos(bearing), 0.5 * std::sin(bearing), 0};
    Reference reference;
    double worst = 0;
    for (int i = 0; i < 12000; ++i) {
      loop.step(reference);
      if (i > 8000) worst = std::max(worst, away_m(loop));
    }
    EXPECT_LT(worst, 0.5) << bearing;
    EXPECT_NEAR(wrapped_rad(loop.yaw_rad() - bearing - pi), 0, 0.1) << bearing;
  }
}

TEST(SurfaceAutopilot, KeepsItsStationInWindFromTheSideByTurningIntoIt) {
  tests::ClosedLoop loop = tests::usv();
  loop.push_n = {0, -40, 0};  // wind from the east
  Reference reference;
  double worst = 0;
  for (int i = 0; i < 12000; ++i) {
    loop.step(reference);
    if (i > 8000) worst = std::max(worst, away_m(loop));
  }
  EXPECT_LT(worst, 0.5);
  EXPECT_NEAR(loop.yaw_rad(), pi / 2, 0.1);
  tests::ClosedLoop vessel = tests::vessel();
  vessel.push_n = {-4000, -4000, 0};
  worst = 0;
  for (int i = 0; i < 24000; ++i) {
    vessel.step(reference);
    if (i > 18000) worst = std::max(worst, away_m(vessel));
  }
  EXPECT_LT(worst, 3);
  EXPECT_NEAR(vessel.yaw_rad(), pi / 4, 0.1);
}

TEST(SurfaceAutopilot, ComesToItsStationFromAfarAndStaysInCalmWater) {
  tests::ClosedLoop loop = tests::usv();
  Reference reference;
  reference.position_m = {-80, 60, 0};
  loop.run(reference, 400);
  EXPECT_LT(std::hypot(loop.state.position_m.x + 80, loop.state.position_m.y - 60), 0.8);
  EXPECT_LT(std::hypot(loop.velocity_m_s().x, loop.velocity_m_s().y), 0.1);
}

TEST(SurfaceAutopilot, GivesFiniteAndBoundedThrustWhateverIsMeasured) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300, 9e3, -9e3}) {
    for (int where = 0; where < 4; ++where) {
      tests::ClosedLoop loop = tests::usv();
      loop.run({}, 5);
      Measured measured = loop.measured();
      if (where == 0) measured.position_m.x = bad;
      if (where == 1) measured.nu.linear.x = bad;
      if (where == 2) measured.nu.angular.z = bad;
      if (where == 3) measured.water_m_s.y = bad;
      for (int i = 0; i < 200; ++i) {
        const Effort e = effort_of(loop.autopilot, measured, {}, 0.05, loop.control);
        for (std::size_t k = 0; k < 2; ++k) {
          ASSERT_GE(e.thrust_n[k], -100);
          ASSERT_LE(e.thrust_n[k], 250);
        }
      }
      loop.run({}, 400);
      EXPECT_LT(away_m(loop), 1) << bad << " " << where;
    }
  }
}

}  // namespace
}  // namespace slackwater::twin::surface_autopilot_test

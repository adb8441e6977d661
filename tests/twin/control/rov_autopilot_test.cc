#include <gtest/gtest.h>

#include <limits>

#include "fields/base/turn.h"
#include "tests/twin/control/closed_loop.h"

namespace slackwater::twin::rov_autopilot_test {
namespace {

using constants::pi;

Reference station(const Triple<double>& at, double yaw_rad = 0) {
  Reference reference;
  reference.position_m = at;
  reference.heading = course_of(yaw_rad);
  return reference;
}

double distance_m(const Triple<double>& a, const Triple<double>& b) {
  return std::sqrt(dot(a - b, a - b));
}

TEST(RovAutopilot, HoldsItsDepthAgainstItsBuoyancyWithoutASteadyError) {
  tests::ClosedLoop loop = tests::bluerov2();
  // 0.235 kg light: 2.3 N upwards (twin/docs/vehicles.md).
  double highest_m = 20;
  for (int i = 0; i < 2400; ++i) {
    loop.step(station({0, 0, 20}));
    highest_m = std::min(highest_m, loop.state.position_m.z);
  }
  EXPECT_NEAR(loop.state.position_m.z, 20, 0.002);
  EXPECT_LT(highest_m, 19.98);  // it does rise before the integral knows
  double down_n = 0;
  for (std::size_t i = 4; i < 8; ++i) down_n += loop.effort.thrust_n[i];
  EXPECT_NEAR(down_n, (0.0134 * 1025 - 13.5) * 9.80665, 0.02);
}

TEST(RovAutopilot, ChangesDepthWithoutOvershootOfATenth) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.run(station({0, 0, 20}), 60);
  double deepest_m = 0;
  for (int i = 0; i < 1200; ++i) {
    loop.step(station({0, 0, 25}));
    deepest_m = std::max(deepest_m, loop.state.position_m.z);
    EXPECT_LE(loop.velocity_m_s().z, 0.5 * 1.1);  // most_descent
  }
  EXPECT_LT(deepest_m, 25.5);
  EXPECT_NEAR(loop.state.position_m.z, 25, 0.02);
}

TEST(RovAutopilot, TurnsToAHeadingAcrossNorthTheShortWayWithLittleOvershoot) {
  for (const double step_rad : {0.2, 1.0, 2.0, 3.1, -1.5}) {
    tests::ClosedLoop loop = tests::bluerov2();
    const double from = pi - 0.4;
    loop.state.attitude = attitude_of({0, 0, from});
    double most = 0;
    for (int i = 0; i < 800; ++i) {
      loop.step(station({0, 0, 20}, from + step_rad));
      const double turned = wrapped_rad(loop.yaw_rad() - from) * (step_rad < 0 ? -1 : 1);
      if (turned > -1) most = std::max(most, turned);
      if (std::abs(step_rad) < 3) {
        EXPECT_GT(turned, -0.1) << "the long way round";
      }
    }
    EXPECT_LT(most, 1.2 * std::abs(step_rad)) << step_rad;
    EXPECT_NEAR(wrapped_rad(loop.yaw_rad() - from - step_rad), 0, 0.01) << step_rad;
  }
}

TEST(RovAutopilot, KeepsItsStationInACurrentItDoesNotKnow) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.fluid_m_s = {-0.3, 0.4, 0};
  double furthest = 0;
  for (int i = 0; i < 3600; ++i) {
    loop.step(station({0, 0, 20}, 0.7));
    furthest = std::max(furthest, distance_m(loop.state.position_m, {0, 0, 20}));
  }
  EXPECT_LT(furthest, 1.0);
  EXPECT_LT(distance_m(loop.state.position_m, {0, 0, 20}), 0.01);
  // With the current known beforehand it is hardly moved.
  tests::ClosedLoop knows = tests::bluerov2();
  knows.autopilot.settings.current_feed_forward = true;
  knows.fluid_m_s = knows.known_m_s = {-0.3, 0.4, 0};
  double moved = 0;
  for (int i = 0; i < 1200; ++i) {
    knows.step(station({0, 0, 20}, 0.7));
    moved = std::max(moved, distance_m(knows.state.position_m, {0, 0, 20}));
  }
  EXPECT_LT(moved, 0.5 * furthest);
}

TEST(RovAutopilot, CruisesOverGroundAsAskedWhicheverWayTheWaterGoes) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.fluid_m_s = {0.1, -0.2, 0};
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m.z = 22;
  reference.velocity_m_s = {0.5, 0.1, 0};
  reference.heading = course_of(pi / 2);
  loop.run(reference, 120);
  EXPECT_NEAR(loop.velocity_m_s().y, 0.5, 0.003);
  EXPECT_NEAR(loop.velocity_m_s().x, -0.1, 0.003);
  EXPECT_NEAR(loop.state.position_m.z, 22, 0.01);
  EXPECT_NEAR(euler_angles(loop.state.attitude).pitch_rad, 0, 0.05);
}

TEST(RovAutopilot, StaysLevelAtItsBestSpeedThoughItsAddedMassWouldTurnItOver) {
  // Munk's moment (Z_w_dot - X_u_dot) U^2 sin cos is 26 times the righting moment of 1.3 N m at 1.5
  // m/s.
  tests::ClosedLoop loop = tests::bluerov2();
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m.z = 20;
  for (const double speed : {0.3, 0.6, 0.9, 1.2, 1.4}) {
    reference.velocity_m_s.x = speed;
    loop.run(reference, 40);
    EXPECT_NEAR(loop.velocity_m_s().x, speed, 0.02);
    EXPECT_NEAR(loop.state.position_m.z, 20, 0.05) << speed;
    EXPECT_NEAR(euler_angles(loop.state.attitude).pitch_rad, 0, 0.02) << speed;
  }
}

TEST(RovAutopilot, FliesAtAnAltitudeOverTheBed) {
  tests::ClosedLoop loop = tests::bluerov2();  // the bed lies at 100 m
  Reference reference = station({0, 0, 0});
  reference.vertical = Vertical::altitude;
  reference.altitude_m = 75;
  loop.run(reference, 90);
  EXPECT_NEAR(loop.state.position_m.z, 25, 0.02);
}

TEST(RovAutopilot, RightsItselfWithWhatItHas) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.state.attitude = attitude_of({1.0, -0.8, 0.4});
  loop.run(station({0, 0, 20}, 0.4), 20);
  const EulerAngles angles = euler_angles(loop.state.attitude);
  EXPECT_NEAR(angles.roll_rad, 0, 0.01);
  EXPECT_NEAR(angles.pitch_rad, 0, 0.01);
}

TEST(RovAutopilot, ReplacedReferencesMakeNoBumpWhereTheyAskForTheSame) {
  tests::ClosedLoop loop = tests::bluerov2();
  loop.fluid_m_s = {0.2, 0.1, 0};
  Reference cruise;
  cruise.target = Target::cruise;
  cruise.position_m.z = 20;
  cruise.velocity_m_s = {0.4, 0, 0};
  loop.run(cruise, 90);
  const Effort before = loop.effort;
  // The same motion as a place that moves along a path through where the vehicle is.
  Reference path = cruise;
  path.target = Target::path;
  path.position_m = loop.state.position_m;
  path.position_m.z = 20;
  loop.step(path);
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(loop.effort.thrust_n[i], before.thrust_n[i], 0.05) << i;
  // A place far away: more thrust, within the ranges, and there it comes to rest.
  loop.run(station({-20, 15, 24}, 3), 150);
  EXPECT_LT(distance_m(loop.state.position_m, {-20, 15, 24}), 0.02);
}

TEST(RovAutopilot, GivesFiniteAndBoundedThrustWhateverIsMeasured) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, -infinity, 1e300, -1e200, 1e9}) {
    for (int where = 0; where < 6; ++where) {
      tests::ClosedLoop loop = tests::bluerov2();
      loop.run(station({0, 0, 20}), 5);
      Measured measured = loop.measured();
      Reference reference = station({0, 0, 20});
      if (where == 0) measured.position_m.x = bad;
      if (where == 1) measured.nu.angular.y = bad;
      if (where == 2) measured.attitude.w = bad;
      if (where == 3) measured.water_m_s.z = bad;
      if (where == 4) reference.position_m.y = bad;
      if (where == 5) reference.velocity_m_s.z = bad;
      const ControlState before = loop.control;
      for (int i = 0; i < 50; ++i)
        loop.effort = effort_of(loop.autopilot, measured, reference, 0.05, loop.control);
      for (const double thrust : loop.effort.thrust_n) {
        EXPECT_GE(thrust, -39.91);
        EXPECT_LE(thrust, 51.44);
      }
      // The integrals remember the good times.
      EXPECT_EQ(loop.control.down_m_s2, before.down_m_s2);
      loop.run(station({0, 0, 20}), 60);
      EXPECT_LT(distance_m(loop.state.position_m, {0, 0, 20}), 0.02);
    }
  }
}

TEST(RovAutopilot, MeasurementsThatGrowWithoutBoundDoNotWindItUp) {
  tests::ClosedLoop loop = tests::bluerov2();
  Measured measured = loop.measured();
  for (int i = 0; i < 4000; ++i) {
    measured.position_m = {1e3 * i, -1e3 * i, 10.0 * i};
    measured.nu.linear = {0.01 * i, 0, 0};
    loop.effort = effort_of(loop.autopilot, measured, station({0, 0, 20}), 0.05, loop.control);
    for (const double thrust : loop.effort.thrust_n) {
      ASSERT_GE(thrust, -39.91);
      ASSERT_LE(thrust, 51.44);
    }
  }
  loop.run(station({0, 0, 20}), 90);
  EXPECT_LT(distance_m(loop.state.position_m, {0, 0, 20}), 0.1);
}

}  // namespace
}  // namespace slackwater::twin::rov_autopilot_test

#include <gtest/gtest.h>

#include <limits>

#include "fields/base/error.h"
#include "fields/base/turn.h"
#include "tests/twin/control/closed_loop.h"

namespace slackwater::twin::auv_autopilot_test {
namespace {

using constants::pi;

Reference cruise(double speed_m_s, double yaw_rad, double depth_m) {
  Reference reference;
  reference.target = Target::cruise;
  reference.velocity_m_s.x = speed_m_s;
  reference.heading = course_of(yaw_rad);
  reference.position_m.z = depth_m;
  return reference;
}

TEST(AuvAutopilot, MakesItsSpeedThroughTheWaterWithTheThrustOfItsDrag) {
  tests::ClosedLoop loop = tests::lrauv();
  loop.run(cruise(1.0, 0, 20), 300);
  EXPECT_NEAR(loop.velocity_m_s().x, 1.0, 0.003);
  EXPECT_NEAR(loop.effort.thrust_n[0], 6.2282, 0.05);  // drag at 1 m/s, twin/docs/vehicles.md
  EXPECT_NEAR(loop.state.position_m.z, 20, 0.05);
  // Half of it: 1.56 N.
  loop.run(cruise(0.5, 0, 20), 400);
  EXPECT_NEAR(loop.velocity_m_s().x, 0.5, 0.003);
  EXPECT_NEAR(loop.effort.thrust_n[0], 1.56, 0.03);
}

TEST(AuvAutopilot, TurnsToAHeadingWithLittleOvershootAndGoesStraightAfterwards) {
  for (const double speed : {0.5, 1.0}) {
    for (const double step : {0.3, 1.5, 3.0, -2.0}) {
      tests::ClosedLoop loop = tests::lrauv();
      loop.run(cruise(speed, 0, 20), 120);
      double most = 0, unrest = 0;
      for (int i = 0; i < 4000; ++i) {
        loop.step(cruise(speed, step, 20));
        const double turned = loop.yaw_rad() * (step < 0 ? -1 : 1);
        if (turned > -1) most = std::max(most, turned);
        if (i > 3000) unrest = std::max(unrest, std::abs(loop.state.nu.angular.z));
      }
      EXPECT_LT(most, 1.2 * std::abs(step)) << speed << " " << step;
      EXPECT_NEAR(wrapped_rad(loop.yaw_rad() - step), 0, 0.01) << speed << " " << step;
      EXPECT_LT(unrest, 0.002) << speed << " " << step;
      EXPECT_NEAR(loop.state.position_m.z, 20, 0.3) << speed << " " << step;
    }
  }
}

TEST(AuvAutopilot, DivesByPitchWithinItsLimitAndTrimsTheElevatorAwayInTheLongRun) {
  tests::ClosedLoop loop = tests::lrauv();
  loop.body.displaced_volume_m3 += 0.0001;  // 1 N light
  loop.run(cruise(1.0, 0, 20), 120);
  double steepest = 0, deepest = 0;
  for (int i = 0; i < 6000; ++i) {
    loop.step(cruise(1.0, 0, 40));
    steepest = std::min(steepest, euler_angles(loop.state.attitude).pitch_rad);
    deepest = std::max(deepest, loop.state.position_m.z);
  }
  EXPECT_GT(steepest, -0.45);
  EXPECT_LT(steepest, -0.15);
  EXPECT_LT(deepest, 42);
  EXPECT_NEAR(loop.state.position_m.z, 40, 0.05);
  EXPECT_NEAR(loop.elevator_rad, 0, 0.01);
  EXPECT_GT(std::abs(loop.moving_mass_m), 1e-4);
}

TEST(AuvAutopilot, HoldsItsDepthByBuoyancyWhereItHasNoWayOn) {
  tests::ClosedLoop loop = tests::lrauv();
  loop.body.displaced_volume_m3 += 0.0001;
  loop.run(cruise(0, 0, 22), 3600);
  EXPECT_NEAR(loop.state.position_m.z, 22, 0.3);
  EXPECT_NEAR(loop.volume_m3, -0.0001, 2e-5);
  EXPECT_NEAR(loop.effort.thrust_n[0], 0, 1e-6);
}

TEST(AuvAutopilot, CirclesThePlaceItIsToHold) {
  for (const double current : {0.0, 0.3}) {
    tests::ClosedLoop loop = tests::lrauv();
    loop.fluid_m_s = loop.known_m_s = {0, current, 0};
    Reference reference;
    reference.position_m = {150, 40, 20};
    loop.run(reference, 600);
    double nearest = 1e9, furthest = 0;
    for (int i = 0; i < 6000; ++i) {
      loop.step(reference);
      const double away = std::hypot(loop.state.position_m.x - 150, loop.state.position_m.y - 40);
      nearest = std::min(nearest, away);
      furthest = std::max(furthest, away);
    }
    EXPECT_GT(nearest, 15) << current;
    EXPECT_LT(furthest, 45) << current;
    EXPECT_NEAR(loop.state.position_m.z, 20, 0.5);
  }
}

TEST(AuvAutopilot, GivesFiniteAndBoundedCommandsWhateverIsMeasured) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300, -1e12, 9e3, -9e3}) {
    tests::ClosedLoop loop = tests::lrauv();
    loop.run(cruise(1, 0, 20), 30);
    for (int where = 0; where < 4; ++where) {
      Measured measured = loop.measured();
      if (where == 0) measured.position_m.z = bad;
      if (where == 1) measured.nu.linear.x = bad;
      if (where == 2) measured.nu.angular.z = bad;
      if (where == 3) measured.water_m_s.x = bad;
      for (int i = 0; i < 300; ++i) {
        const Effort e = effort_of(loop.autopilot, measured, cruise(1, 2, 30), 0.1, loop.control);
        ASSERT_LE(std::abs(e.thrust_n[0]), 10);
        ASSERT_LE(std::abs(e.rudder_rad), 0.2618);
        ASSERT_LE(std::abs(e.elevator_rad), 0.2618);
        ASSERT_LE(std::abs(e.moving_mass_m), 0.03 + 1e-12);
        ASSERT_LE(std::abs(e.volume_m3), 456e-6);
      }
    }
    loop.run(cruise(1, 0, 20), 600);
    EXPECT_NEAR(loop.state.position_m.z, 20, 0.2) << bad;
  }
}

TEST(AuvAutopilot, IsRefusedWithTheNameOfThePairThatIsMissing) {
  const auto refusal = [](const FinPair& rudder, const FinPair& elevator) -> std::string {
    const auto mounts = tests::lrauv_mounts();
    const auto ranges = tests::lrauv_ranges();
    try {
      (void)plan_autopilot(default_autopilot(VehicleKind::auv), VehicleKind::auv,
                           tests::body_from_data("lrauv_tethys"),
                           {mounts, ranges, rudder, elevator, tests::lrauv_trim(), 0.3});
    } catch (const Error& problem) {
      return problem.message();
    }
    return "nothing was refused";
  };
  FinPair forward = tests::lrauv_fins();
  forward.position_x_m = 1;
  EXPECT_EQ(refusal({}, tests::lrauv_fins()).rfind("rudder: an auv is steered by", 0), 0U);
  EXPECT_EQ(refusal(tests::lrauv_fins(), {}).rfind("elevator: an auv is steered by", 0), 0U);
  EXPECT_EQ(refusal(tests::lrauv_fins(), forward).rfind("elevator: an auv is steered by", 0), 0U);
  EXPECT_EQ(refusal(tests::lrauv_fins(), tests::lrauv_fins()), "nothing was refused");
}

}  // namespace
}  // namespace slackwater::twin::auv_autopilot_test

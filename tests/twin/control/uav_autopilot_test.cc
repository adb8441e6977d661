#include <gtest/gtest.h>

#include <limits>

#include "fields/base/turn.h"
#include "tests/twin/control/closed_loop.h"

namespace slackwater::twin::uav_autopilot_test {
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

double tilt_rad(const tests::ClosedLoop& loop) {
  return std::acos(std::min(rotation_of(loop.state.attitude).down.z, 1.0));
}

TEST(UavAutopilot, HoversWithAQuarterOfItsWeightOnEachRotor) {
  tests::ClosedLoop loop = tests::x500();
  loop.run(station({0, 0, -30}), 20);
  EXPECT_LT(distance_m(loop.state.position_m, {0, 0, -30}), 1e-3);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(loop.effort.thrust_n[i], 5.061, 2e-3);
}

TEST(UavAutopilot, HoldsItsPlaceInWind) {
  for (const Triple<double>& wind : {Triple<double>{8, 0, 0}, {-4, 6.9, 0}, {0, -12, 0}}) {
    tests::ClosedLoop loop = tests::x500();
    loop.fluid_m_s = wind;
    double worst = 0;
    for (int i = 0; i < 20000; ++i) {
      loop.step(station({0, 0, -30}, 0.8));
      if (i * loop.dt_s > 40)
        worst = std::max(worst, distance_m(loop.state.position_m, {0, 0, -30}));
    }
    EXPECT_LT(worst, 0.05) << wind.x << " " << wind.y;
    // Leans into it by what the drag, which goes axis by axis, is to the weight.
    const double ahead = wind.x * std::cos(0.8) + wind.y * std::sin(0.8);
    const double aside = wind.y * std::cos(0.8) - wind.x * std::sin(0.8);
    const double drag_n = 0.03675 * std::hypot(ahead * ahead, aside * aside);
    EXPECT_NEAR(tilt_rad(loop), std::atan(drag_n / 20.244), 0.005);
    EXPECT_NEAR(loop.yaw_rad(), 0.8, 0.01);
  }
}

TEST(UavAutopilot, HoldsItsPlaceWithinTwoDecimetresInGustsAboutEightMetresPerSecond) {
  tests::ClosedLoop loop = tests::x500();
  double worst = 0;
  for (int i = 0; i < 30000; ++i) {
    // 10 % of turbulence, in eddies of 20 and 7 s
    loop.fluid_m_s = {8 + 0.8 * std::sin(0.3 * loop.t_s), 0.8 * std::sin(0.9 * loop.t_s), 0};
    loop.step(station({0, 0, -30}));
    if (i * loop.dt_s > 40) worst = std::max(worst, distance_m(loop.state.position_m, {0, 0, -30}));
  }
  EXPECT_LT(worst, 0.2);
}

TEST(UavAutopilot, FliesToAPlaceWithinItsLimitsOfSpeedClimbAndTilt) {
  tests::ClosedLoop loop = tests::x500();
  const Triple<double> there{120, -90, -60};
  double fastest = 0, climb = 0, steepest = 0, beyond = 0;
  for (int i = 0; i < 15000; ++i) {
    loop.step(station(there, 2));
    const Triple<double> v = loop.velocity_m_s();
    fastest = std::max(fastest, std::hypot(v.x, v.y));
    climb = std::max(climb, -v.z);
    steepest = std::max(steepest, tilt_rad(loop));
    beyond = std::max(beyond, 0.8 * loop.state.position_m.x - 0.6 * loop.state.position_m.y - 150);
  }
  EXPECT_GT(fastest, 10);
  EXPECT_LT(fastest, 12.6);
  EXPECT_GT(climb, 2.5);
  EXPECT_LT(climb, 3.3);
  EXPECT_LT(steepest, 46 * pi / 180);
  EXPECT_LT(beyond, 1.0);
  EXPECT_LT(distance_m(loop.state.position_m, there), 0.05);
  // Down again, slower than up.
  double sink = 0;
  for (int i = 0; i < 5000; ++i) {
    loop.step(station({120, -90, -30}));
    sink = std::max(sink, loop.velocity_m_s().z);
  }
  EXPECT_GT(sink, 1.2);
  EXPECT_LT(sink, 1.5 * 1.1);
}

TEST(UavAutopilot, TurnsWithLittleOvershootAndStaysInItsPlace) {
  for (const double step : {0.5, 2.0, -3.0}) {
    tests::ClosedLoop loop = tests::x500();
    double most = 0;
    for (int i = 0; i < 3000; ++i) {
      loop.step(station({0, 0, -30}, step));
      const double turned = loop.yaw_rad() * (step < 0 ? -1 : 1);
      if (turned > -1) most = std::max(most, turned);
    }
    EXPECT_LT(most, 1.2 * std::abs(step));
    EXPECT_NEAR(wrapped_rad(loop.yaw_rad() - step), 0, 0.01);
    EXPECT_LT(distance_m(loop.state.position_m, {0, 0, -30}), 0.02);
  }
}

TEST(UavAutopilot, RightsItselfFromAnyAttitude) {
  for (const EulerAngles& thrown :
       {EulerAngles{1.5, 0, 0}, {0, -1.4, 1}, {3.1, 0, 0}, {pi, 0, 0}, {2, 1, -2}}) {
    tests::ClosedLoop loop = tests::x500();
    loop.state.attitude = attitude_of(thrown);
    loop.state.nu.angular = {2, -1, 1};
    loop.run(station({0, 0, -30}), 40);
    EXPECT_LT(distance_m(loop.state.position_m, {0, 0, -30}), 0.05) << thrown.roll_rad;
    EXPECT_LT(tilt_rad(loop), 0.01);
  }
}

TEST(UavAutopilot, CruisesOverGroundInWindAndStopsWithoutABump) {
  tests::ClosedLoop loop = tests::x500();
  loop.fluid_m_s = {0, 6, 0};
  Reference cruise = station({0, 0, -40});
  cruise.target = Target::cruise;
  cruise.velocity_m_s = {5, 0, 0};
  loop.run(cruise, 40);
  EXPECT_NEAR(loop.velocity_m_s().x, 5, 0.05);
  EXPECT_NEAR(loop.velocity_m_s().y, 0, 0.05);
  const Effort before = loop.effort;
  Reference path = cruise;
  path.target = Target::path;
  path.position_m = loop.state.position_m;
  path.position_m.z = -40;
  loop.step(path);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(loop.effort.thrust_n[i], before.thrust_n[i], 0.05);
  const Triple<double> here = loop.state.position_m;
  loop.run(station({here.x, here.y, -40}), 40);
  EXPECT_LT(distance_m(loop.state.position_m, {here.x, here.y, -40}), 0.05);
}

TEST(UavAutopilot, CarriesItsWeightWhateverIsMeasured) {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), 1e300, 9e3, -9e3}) {
    for (int where = 0; where < 4; ++where) {
      tests::ClosedLoop loop = tests::x500();
      loop.run(station({0, 0, -30}), 2);
      Measured measured = loop.measured();
      if (where == 0) measured.position_m.z = bad;
      if (where == 1) measured.nu.linear.x = bad;
      if (where == 2) measured.nu.angular.z = bad;
      if (where == 3) measured.attitude.y = bad;
      for (int i = 0; i < 500; ++i) {
        const Effort e =
            effort_of(loop.autopilot, measured, station({0, 0, -30}), 0.004, loop.control);
        for (std::size_t k = 0; k < 4; ++k) {
          ASSERT_GE(e.thrust_n[k], 0);
          ASSERT_LE(e.thrust_n[k], 8.54858);
        }
        if (!(std::abs(bad) < 1e6)) {
          ASSERT_NEAR(e.thrust_n[0], 5.061, 0.001);
        }
      }
      loop.run(station({0, 0, -30}), 60);
      EXPECT_LT(distance_m(loop.state.position_m, {0, 0, -30}), 0.05) << bad << " " << where;
    }
  }
}

}  // namespace
}  // namespace slackwater::twin::uav_autopilot_test

#include "twin/thruster/thruster.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "tests/support/lanes_for_tests.h"
#include "tests/support/thruster_for_tests.h"
#include "twin/thruster/lag.h"

namespace slackwater::twin::thruster_test {
namespace {

using Around = ThrusterSurroundings<double>;
constexpr double high_above_m = 1e3;

Around in_air(double climb_m_s, double edgewise_m_s, double height_m = high_above_m) {
  return {climb_m_s, edgewise_m_s, 16, height_m};
}

// ---- the rotor: a quarter of the X500's 2.064308 kg on a disc of 0.127 m radius

constexpr double hover_n = 2.064308 * constants::gravity_m_s2 / 4;
constexpr double hover_m_s = 6.384926;

TEST(Rotor, HoverTakesTheIdealPowerOfItsDiscs) {
  Rotor ideal = tests::quadrotor_rotor().rotor;
  ideal.efficiency = 1;
  const double speed = std::sqrt(hover_n / ideal.thrust_n_s2);
  EXPECT_NEAR(speed, 769.43, 0.01);
  const auto out = run(ideal, speed, in_air(0, 0));
  EXPECT_NEAR(out.thrust_n, hover_n, 1e-6);  // at 1 km the ground adds a part in 10^9
  EXPECT_NEAR(4 * out.power_w, 129.256, 2e-3);
  EXPECT_NEAR(out.power_w / hover_n, hover_m_s, 1e-6);
  EXPECT_NEAR(out.torque_n_m, 0.016 * hover_n, 1e-12);
  EXPECT_NEAR(out.drag_n_s_m, 8.06428e-05 * speed, 1e-12);
  const auto real = run(tests::quadrotor_rotor(), speed, in_air(0, 0));
  EXPECT_NEAR(4 * real.power_w, 220, 2);
}

TEST(Rotor, InducesTheVelocitiesOfGlauertAndOfClimb) {
  const double hover2 = hover_n / tests::quadrotor_rotor().rotor.disc_kg_m;
  EXPECT_NEAR(std::sqrt(hover2), hover_m_s, 1e-6);
  EXPECT_NEAR(induced_velocity_m_s(hover2, 0.0, 100.0), 3.809638, 1e-6);
  EXPECT_NEAR(induced_velocity_m_s(hover2, 2.0, 0.0), 5.462761, 1e-6);
}

TEST(Rotor, TheInducedVelocitySolvesGlauertsEquationInAnyFlow) {
  Rng random(5, "tests/glauert");
  for (int i = 0; i < 2000; ++i) {
    const double hover2 = std::pow(random.uniform(0.01, 12), 2);
    const double climb = random.uniform(0, 15);
    const double edgewise = random.uniform(0, 25);
    const double v = induced_velocity_m_s(hover2, climb, edgewise * edgewise);
    ASSERT_NEAR(v * std::hypot(edgewise, climb + v) / hover2, 1, 1e-6)
        << hover2 << " " << climb << " " << edgewise;
  }
}

/// Cheeseman & Bennett (1955): at a height of one radius 1/(1 - 1/16), which speed undoes.
TEST(Rotor, TheGroundAddsThrustNearIt) {
  const Thruster rotor = tests::quadrotor_rotor();
  const double radius_m = 0.127;
  const auto gain = [&](double height_m, double edgewise_m_s) {
    return run(rotor, 700.0, in_air(0, edgewise_m_s, height_m)).thrust_n /
           run(rotor, 700.0, in_air(0, edgewise_m_s)).thrust_n;
  };
  EXPECT_NEAR(gain(radius_m, 0), 16.0 / 15, 1e-6);
  EXPECT_NEAR(gain(0.5 * radius_m, 0), 4.0 / 3, 1e-6);
  EXPECT_EQ(gain(0, 0), gain(0.5 * radius_m, 0));
  EXPECT_EQ(gain(-3, 0), gain(0, 0));
  EXPECT_LT(gain(radius_m, 10), 1.02);
}

TEST(Rotor, TurnsNoFasterThanItsBusAllows) {
  const Thruster rotor = tests::quadrotor_rotor();
  Around around = in_air(0, 0);
  around.voltage_v = 14.8;
  const double full_n = run(rotor, 5000.0, around).thrust_n;
  EXPECT_NEAR(full_n, 8.54858, 1e-6);
  around.voltage_v = 7.4;
  EXPECT_NEAR(run(rotor, 5000.0, around).thrust_n, full_n / 4, 1e-6);
  EXPECT_NEAR(run(rotor, 400.0, around).thrust_n, 8.54858e-6 * 160000, 1e-6);
  around.voltage_v = 0;
  EXPECT_EQ(run(rotor, 5000.0, around).thrust_n, 0);
  EXPECT_EQ(run(rotor, -50.0, in_air(0, 0)).thrust_n, 0);
}

// ---- the propeller

TEST(Propeller, PushesTheLrauvAtThreeHundredTurns) {
  const Thruster propeller = tests::slow_propeller();
  const double shaft = 300 * 2 * constants::pi / 60;
  const auto out = run(propeller, shaft, Around{1, 0, 14.4, 0});
  EXPECT_NEAR(out.thrust_n, 6.98, 0.01);
  EXPECT_NEAR(run(propeller, -shaft, Around{1, 0, 14.4, 0}).thrust_n, -out.thrust_n, 1e-12);
}

/// 12 W of propulsion against 6.2282 N at 1 m/s: a total efficiency of 0.52.
TEST(Propeller, TakesTwelveWattsAtOneMetrePerSecond) {
  const Thruster propeller = tests::slow_propeller();
  const Around around{1, 0, 14.4, 0};
  const auto out = run(propeller, command_for(propeller, 6.2282, around), around);
  EXPECT_NEAR(out.thrust_n, 6.2282, 1e-9);
  EXPECT_NEAR(out.power_w, 12, 0.05);
  EXPECT_NEAR(out.thrust_n * 1 / out.power_w, 0.52, 0.005);
}

TEST(Propeller, TakesPowerAtRestAndAsternToo) {
  const Thruster propeller = tests::slow_propeller();
  const double at_rest_w = run(propeller, 20.0, Around{0, 0, 14.4, 0}).power_w;
  EXPECT_GT(at_rest_w, 0.5);
  EXPECT_EQ(run(propeller, -20.0, Around{0, 0, 14.4, 0}).power_w, at_rest_w);
  EXPECT_EQ(run(propeller, -20.0, Around{1, 0, 14.4, 0}).power_w, at_rest_w);
  EXPECT_GT(run(propeller, 20.0, Around{1, 0, 14.4, 0}).power_w, at_rest_w);
}

// ---- the drive

/// WAM-V: 784 W hydrodynamic at 2 m/s for 784/0.45 W.
TEST(Drive, PushesTheWamvAtItsOverallEfficiency) {
  const auto out = run(tests::outboard(), 196.0, Around{2, 0, 25, 0});
  EXPECT_EQ(out.thrust_n, 196);
  EXPECT_NEAR(2 * out.power_w, 784 / 0.45, 5);
  EXPECT_EQ(out.fuel_kg_s, 0);
}

TEST(Drive, HoldsItsThrustWithinItsLimits) {
  const Thruster drive = tests::outboard();
  EXPECT_EQ(run(drive, 900.0, Around{}).thrust_n, 250);
  EXPECT_EQ(run(drive, -900.0, Around{}).thrust_n, -100);
  EXPECT_EQ(command_for(drive, -900, Around{}), -100);
}

TEST(Drive, AtItsMostPowerFasterMeansLessThrust) {
  const Thruster drive = tests::outboard("most_power_w: 600\nidle_power_w: 50\n");
  double last = 1e9;
  for (const double advance_m_s : {0.0, 1.0, 2.0, 4.0}) {
    const auto out = run(drive, 250.0, Around{advance_m_s, 0, 0, 0});
    EXPECT_NEAR(out.power_w, 600, 1e-5);
    EXPECT_LT(out.thrust_n, last);
    last = out.thrust_n;
  }
  EXPECT_EQ(run(drive, 0.0, Around{}).power_w, 50);
}

/// 208 g/kWh: 1 kWh of the shaft in an hour.
TEST(Drive, BurnsFuelByTheEnergyOfItsShaft) {
  const Thruster electric = tests::outboard();
  const Thruster diesel = tests::outboard("fuel_g_kwh: 208\n");
  const Around around{1.5, 0, 0, 0};
  const auto out = run(diesel, 200.0, around);
  EXPECT_EQ(out.power_w, 0);
  EXPECT_NEAR(out.fuel_kg_s * 3600, 0.208 * run(electric, 200.0, around).power_w / 1000, 1e-12);
}

// ---- all of them

struct Case {
  const char* name;
  Thruster thruster;
};
std::vector<Case> one_of_each() {
  return {{"table", tests::t200()},
          {"propeller", tests::slow_propeller()},
          {"open water", tests::remus_propeller("thrust_deduction: 0.1\nastern_share: 0.7\n"
                                                "most_astern_shaft_rad_s: 120\n")},
          {"rotor", tests::quadrotor_rotor()},
          {"drive", tests::outboard("most_power_w: 700\nidle_power_w: 40\n")},
          {"engine", tests::outboard("fuel_g_kwh: 208\n")}};
}

TEST(Thruster, ItsCommandForAThrustGivesThatThrust) {
  Rng random(6, "tests/thruster_inverse");
  for (const Case& c : one_of_each()) {
    int reached = 0;
    for (int i = 0; i < 1000; ++i) {
      const Around around{random.uniform(-1, 2), 0, random.uniform(14.8, 17), random.uniform(0, 2)};
      const double wanted_n =
          random.uniform(0.1, 0.9) * run(c.thruster, c.thruster.most_command, around).thrust_n;
      const double thrust_n =
          run(c.thruster, command_for(c.thruster, wanted_n, around), around).thrust_n;
      ASSERT_NEAR(thrust_n, wanted_n, 1e-6 * wanted_n) << c.name;
      ++reached;
    }
    EXPECT_EQ(reached, 1000);
  }
}

TEST(Thruster, EightLanesGiveTheBitsOfOne) {
  using tests::Lanes;
  Rng random(8, "tests/thruster_lanes");
  for (const Case& c : one_of_each()) {
    const double size = 1.3 * c.thruster.most_command;
    const LagStep lag = lag_step(0.2, 0.35, 0.05);
    for (int i = 0; i < 500; ++i) {
      double now[8], command[8], advance[8], across[8], voltage[8], height[8];
      for (std::size_t k = 0; k < 8; ++k) {
        now[k] = random.uniform(-size, size);
        command[k] = random.uniform() < 0.1 ? 0 : random.uniform(-size, size);
        advance[k] = random.uniform() < 0.1 ? 0 : random.uniform(-6, 6);
        across[k] = random.uniform() < 0.1 ? 0 : random.uniform(0, 15);
        voltage[k] = random.uniform(0, 25);
        height[k] = random.uniform(-1, 3);
      }
      ThrusterSurroundings<Lanes> around;
      around.advance_m_s = tests::lanes_of(advance);
      around.across_m_s = tests::lanes_of(across);
      around.voltage_v = tests::lanes_of(voltage);
      around.height_m = tests::lanes_of(height);
      const Lagged<Lanes> lags = lagged(lag, tests::lanes_of(now), tests::lanes_of(command));
      const ThrusterOutput<Lanes> out = run(c.thruster, lags.mean, around);
      for (std::size_t k = 0; k < 8; ++k) {
        const Lagged<double> alone = lagged(lag, now[k], command[k]);
        ASSERT_EQ(alone.end, tests::lane_of(lags.end, k)) << c.name;
        const auto one =
            run(c.thruster, alone.mean, Around{advance[k], across[k], voltage[k], height[k]});
        ASSERT_EQ(one.thrust_n, tests::lane_of(out.thrust_n, k)) << c.name;
        ASSERT_EQ(one.power_w, tests::lane_of(out.power_w, k)) << c.name;
        ASSERT_EQ(one.fuel_kg_s, tests::lane_of(out.fuel_kg_s, k)) << c.name;
        ASSERT_EQ(one.torque_n_m, tests::lane_of(out.torque_n_m, k)) << c.name;
        ASSERT_EQ(one.drag_n_s_m, tests::lane_of(out.drag_n_s_m, k)) << c.name;
        ASSERT_TRUE(std::isfinite(one.thrust_n) && std::isfinite(one.power_w)) << c.name;
        ASSERT_GE(one.power_w, 0) << c.name;
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::twin::thruster_test

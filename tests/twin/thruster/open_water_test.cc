#include "twin/thruster/open_water.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/support/contains.h"
#include "tests/support/thruster_for_tests.h"

namespace slackwater::twin::open_water_test {
namespace {

using tests::contains;
using tests::remus_propeller;
using tests::thruster_from;
using Around = ThrusterSurroundings<double>;

constexpr double turns_to_rad = 2 * constants::pi;
constexpr double shaft = 25 * turns_to_rad;  // 1500 turns a minute

Around at_speed(double advance_m_s) { return {advance_m_s, 0, 24, 0}; }

std::string propeller_yaml(const std::string& numbers, const std::string& diameter_m = "0.14") {
  return "kind: propeller\npropeller_diameter_m: " + diameter_m +
         "\nmost_shaft_rad_s: 200\n"
         "rise_time_constant_s: 1\nfall_time_constant_s: 1\n" +
         numbers;
}

/// By hand from K_T = 0.4566 - 0.41737 J, K_Q = 0.07 - 0.0585 J: rho D^4 n^2 is 246.1025 N, rho D^5
/// n^2 34.45435 N m, and J that of 0.944 of the speed.
TEST(OpenWater, PushesTheRemusAsItsFourPointsSay) {
  struct Point {
    double speed_m_s, thrust_n, torque_n_m;
  };
  const Thruster propeller = remus_propeller();
  for (const Point& point :
       {Point{0, 112.3704015, 2.4118045}, Point{1.1122881355932204, 81.5556613725, 1.8071306575},
        Point{2.4588983050847464, 44.24928265814, 1.07507219218},
        Point{3.7076271186440684, 9.654601075, 0.396225025}}) {
    const auto out = run(propeller, shaft, at_speed(point.speed_m_s));
    EXPECT_NEAR(out.thrust_n, point.thrust_n, 1e-9);
    EXPECT_NEAR(out.torque_n_m, point.torque_n_m, 1e-10);
    EXPECT_NEAR(0.8 * out.power_w, turns_to_rad * 25 * point.torque_n_m, 1e-8);
  }
}

TEST(OpenWater, ATableOfAStraightLineIsThatLine) {
  const Thruster line = remus_propeller();
  const Thruster table = thruster_from(
      propeller_yaml("motor_efficiency: 0.8\nwake_fraction: 0.056\nopen_water:\n"
                     "  {J: [0, 0.3, 0.9, 1.09], K_T: [0.4566, 0.331389, 0.080967, 0.0016667],\n"
                     "   K_Q: [0.07, 0.05245, 0.01735, 0.006235]}\n"));
  for (double speed_m_s = -1; speed_m_s < 4; speed_m_s += 0.07) {
    const auto a = run(line, shaft, at_speed(speed_m_s)),
               b = run(table, shaft, at_speed(speed_m_s));
    EXPECT_NEAR(a.thrust_n, b.thrust_n, 1e-9) << speed_m_s;
    EXPECT_NEAR(a.torque_n_m, b.torque_n_m, 1e-10) << speed_m_s;
  }
}

TEST(OpenWater, PowersOfJAreTheirPolynomial) {
  const Thruster propeller =
      thruster_from(propeller_yaml("motor_efficiency: 1\nopen_water: {K_T: [0.45, -0.2, -0.25, "
                                   "0.05], K_Q: [0.06, -0.01, -0.03], most_J: 1.1}\n"));
  for (const double ratio : {0.0, 0.11, 0.55, 0.825, 1.1}) {
    const auto out = run(propeller, shaft, at_speed(ratio * 25 * 0.14));
    const double thrust = 0.45 - 0.2 * ratio - 0.25 * ratio * ratio + 0.05 * std::pow(ratio, 3);
    EXPECT_NEAR(out.thrust_n, 246.1025 * thrust, 1e-9) << ratio;
    EXPECT_NEAR(out.torque_n_m, 34.45435 * (0.06 - 0.01 * ratio - 0.03 * ratio * ratio), 1e-9);
  }
}

TEST(OpenWater, TheHullTakesThrustBackAndAStatorTorqueButNoPower) {
  const auto alone = run(remus_propeller(), shaft, at_speed(2));
  const auto behind =
      run(remus_propeller("thrust_deduction: 0.1\ntorque_share: 0.5\n"), shaft, at_speed(2));
  EXPECT_NEAR(behind.thrust_n, 0.9 * alone.thrust_n, 1e-12);
  EXPECT_NEAR(behind.torque_n_m, 0.5 * alone.torque_n_m, 1e-12);
  EXPECT_EQ(behind.power_w, alone.power_w);
}

TEST(OpenWater, FlowFromBehindCountsAsNoneAndBeyondTheTableItsEnd) {
  const Thruster propeller = remus_propeller();
  const auto at_rest = run(propeller, shaft, at_speed(0));
  EXPECT_EQ(run(propeller, shaft, at_speed(-2)).thrust_n, at_rest.thrust_n);
  // Its line ends just above no thrust, at J = 1.09, and runs out over another as far.
  const double last_m_s = 1.09 * 25 * 0.14 / 0.944, last_n = 246.1025 * (0.4566 - 0.41737 * 1.09);
  EXPECT_NEAR(run(propeller, shaft, at_speed(last_m_s)).thrust_n, last_n, 1e-9);
  EXPECT_NEAR(run(propeller, shaft, at_speed(1.5 * last_m_s)).thrust_n, 0.5 * last_n, 1e-9);
  EXPECT_NEAR(run(propeller, shaft, at_speed(9)).thrust_n, 0, 1e-12);
  EXPECT_EQ(run(propeller, 0.0, at_speed(3)).thrust_n, 0);
  EXPECT_EQ(run(propeller, 0.0, at_speed(3)).power_w, 0);
}

TEST(OpenWater, AsternItDoesAsItsOwnNumbersSay) {
  const auto ahead = run(remus_propeller(), shaft, at_speed(0));
  const auto astern = run(remus_propeller("astern_share: 0.7\n"), -shaft, at_speed(1.5));
  EXPECT_NEAR(astern.thrust_n, -0.7 * ahead.thrust_n, 1e-9);  // at rest: no flow in its sense
  EXPECT_NEAR(astern.torque_n_m, -0.7 * ahead.torque_n_m, 1e-9);
  EXPECT_NEAR(astern.power_w, 0.7 * ahead.power_w, 1e-9);
  const Thruster own =
      remus_propeller("astern: {J: [0, 0.5], K_T: [0.3, 0.1], K_Q: [0.06, 0.04]}\n");
  const double speed_m_s = -0.25 * 25 * 0.14 / 0.944;
  EXPECT_NEAR(run(own, -shaft, at_speed(speed_m_s)).thrust_n, -246.1025 * 0.2, 1e-9);
  EXPECT_NEAR(run(own, -shaft, at_speed(speed_m_s)).torque_n_m, -34.45435 * 0.05, 1e-9);
  const Thruster held = remus_propeller("most_astern_shaft_rad_s: 50\n");
  EXPECT_EQ(held.least_command, -50);
  EXPECT_EQ(run(held, -190.0, at_speed(0)).thrust_n, run(held, -50.0, at_speed(0)).thrust_n);
}

/// Both ways, on straight, curved and broken lines, from rest to where the thrust ends.
TEST(OpenWater, TheShaftForAThrustGivesThatThrust) {
  const std::vector<Thruster> propellers{
      remus_propeller("astern: {J: [0, 0.5, 1], K_T: [0.3, 0.2, -0.1], K_Q: [0.06, 0.05, 0.02]}\n"
                      "thrust_deduction: 0.15\n"),
      thruster_from(propeller_yaml("efficiency: 0.5\nopen_water: {K_T: [0.45, -0.2, -0.25, 0.05], "
                                   "most_J: 1.1}\nastern_share: 0.8\n")),
      thruster_from(propeller_yaml("efficiency: 0.5\nopen_water: {J: [0, 0.2, 0.4, 0.6, 0.8, 1], "
                                   "K_T: [0.30, 0.32, 0.31, 0.22, 0.1, 0.05]}\n"))};
  Rng random(31, "tests/shaft_for_thrust");
  for (const Thruster& propeller : propellers) {
    int ahead = 0, astern = 0;
    for (int i = 0; i < 3000; ++i) {
      const double turning = (i % 2 == 0 ? 1 : -1) * random.uniform(5, 190);
      const double ratio = random.uniform(-0.1, 1);
      const Around around = at_speed(ratio * 0.14 * turning / turns_to_rad);
      const double thrust_n = run(propeller, turning, around).thrust_n;
      if (!(thrust_n * turning > 0)) continue;
      ASSERT_NEAR(command_for(propeller, thrust_n, around) / turning, 1, 1e-9)
          << turning << " " << ratio;
      ++(turning > 0 ? ahead : astern);
    }
    EXPECT_GT(ahead, 1000);
    EXPECT_GT(astern, 1000);
    EXPECT_EQ(command_for(propeller, 0, at_speed(1)), 0);
    EXPECT_EQ(command_for(propeller, 1e6, at_speed(1)), 200);
    EXPECT_EQ(command_for(propeller, -1e6, at_speed(1)), -200);
  }
}

/// What it pushes with through the water it takes at the shaft at least, and a shaft that the water
/// turns gives nothing back.
TEST(OpenWater, NoPropellerPushesMoreThanItsShaftGives) {
  const Thruster propeller = remus_propeller("torque_share: 0.5\n");
  for (double turning = -200; turning <= 200; turning += 7)
    for (double speed_m_s = -3; speed_m_s <= 6; speed_m_s += 0.3) {
      const auto out = run(propeller, turning, at_speed(speed_m_s));
      EXPECT_GE(out.power_w, 0);
      EXPECT_NEAR(0.8 * out.power_w, turning * 2 * out.torque_n_m, 1e-9);
      if (speed_m_s * turning > 0)
        EXPECT_LE(out.thrust_n * 0.944 * speed_m_s, 0.8 * out.power_w + 1e-9);
    }
  const Thruster turned = thruster_from(propeller_yaml(
      "motor_efficiency: 1\nopen_water: {K_T: [0.3, -0.4], K_Q: [0.04, -0.05], most_J: 1.2}\n"));
  EXPECT_LT(run(turned, shaft, at_speed(4)).thrust_n, 0);
  EXPECT_EQ(run(turned, shaft, at_speed(4)).power_w, 0);
}

TEST(OpenWater, WithoutKqThePowerIsThatOfTheDiscInItsFlow) {
  const Thruster propeller =
      thruster_from(propeller_yaml("efficiency: 0.5\nwake_fraction: 0.2\nthrust_deduction: 0.1\n"
                                   "open_water: {K_T: [0.4566, -0.41737], most_J: 1.09}\n"));
  const auto out = run(propeller, shaft, at_speed(2));
  const double disc_kg_m = 2 * 1025 * constants::pi * 0.14 * 0.14 / 4;
  EXPECT_NEAR(out.power_w, disc_power_w(disc_kg_m, out.thrust_n / 0.9, 1.6) / 0.5, 1e-9);
  EXPECT_EQ(out.torque_n_m, 0);
}

TEST(SquareLaw, IsOfEitherFormAndUnlikeAstern) {
  const Thruster otter = thruster_from(
      propeller_yaml("efficiency: 0.5\nthrust_n_s2: 0.01108\nastern_thrust_n_s2: 0.006445\n"
                     "most_astern_shaft_rad_s: 101.74\n",
                     "0.2"));
  for (const double speed_m_s : {0.0, 2.0}) {
    EXPECT_NEAR(run(otter, 100.0, at_speed(speed_m_s)).thrust_n, 110.8, 1e-9);
    EXPECT_NEAR(run(otter, -100.0, at_speed(speed_m_s)).thrust_n, -64.45, 1e-9);
  }
  EXPECT_NEAR(command_for(otter, 110.8, {}), 100, 1e-9);
  EXPECT_NEAR(command_for(otter, -64.45, {}), -100, 1e-9);
  EXPECT_EQ(otter.least_command, -101.74);
  // The same propeller by its coefficient.
  const double unit = 1025 * std::pow(0.2, 4);
  const Thruster same =
      thruster_from(propeller_yaml("efficiency: 0.5\nthrust_coefficient_per_rad2: " +
                                       std::to_string(0.01108 / unit) + "\nastern_share: 0.5\n",
                                   "0.2"));
  EXPECT_NEAR(run(same, 100.0, {}).thrust_n, 110.8, 1e-2);
  EXPECT_NEAR(run(same, -100.0, {}).thrust_n, -55.4, 1e-2);
}

std::string refusal(const std::string& numbers) {
  try {
    (void)thruster_from(propeller_yaml(numbers));
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

TEST(ReadPropeller, RefusesWhatNoPropellerIsAndSaysWhy) {
  const std::string square = "efficiency: 0.5\nthrust_n_s2: 0.005\n";
  const std::string motor = "motor_efficiency: 0.8\n";
  const std::string water =
      motor + "open_water: {K_T: [0.45, -0.4], K_Q: [0.07, -0.05], most_J: 1}\n";
  EXPECT_EQ(refusal(square), "nothing was refused");
  EXPECT_EQ(refusal(water), "nothing was refused");
  EXPECT_TRUE(contains(refusal("efficiency: 0.5\n"), "found none of thrust_coefficient_per_rad2"));
  EXPECT_TRUE(contains(refusal(square + water), "found 2 of"));
  EXPECT_TRUE(contains(refusal("efficiency: 0.5\nthrust_n_s2: 1e-5\n"), "rad/s"));
  EXPECT_TRUE(contains(refusal(square + "wake_fraction: 0.1\n"), "goes with open_water"));
  EXPECT_TRUE(contains(refusal(square + "astern_thrust_n_s2: 0.01\nastern_share: 0.5\n"),
                       "leave one of the two out"));
  EXPECT_TRUE(contains(refusal(water + "astern_thrust_n_s2: 0.01\n"), "astern or astern_share"));
  EXPECT_TRUE(contains(refusal(water + "efficiency: 0.5\n"), "give motor_efficiency"));
  EXPECT_TRUE(
      contains(refusal(motor + "open_water: {K_T: [0.45, -0.4], most_J: 1}\n"), "without K_Q"));
  EXPECT_TRUE(contains(refusal(water + "wake_fraction: 1.2\n"), "wake_fraction"));
  EXPECT_TRUE(contains(refusal(water + "astern: {K_T: [0.3], most_J: 1}\n"), "both in open_water"));
  const auto table = [&](const std::string& numbers) {
    return refusal(motor + "open_water: {" + numbers + "}\n");
  };
  EXPECT_EQ(table("J: [0, 1], K_T: [0.4, 0], K_Q: [0.06, 0.01]"), "nothing was refused");
  EXPECT_TRUE(contains(table("J: [0, 1], K_T: [0.4, 0], K_Q: [0.06]"), "2 of J, 2 of K_T and 1"));
  EXPECT_TRUE(contains(table("J: [0.2, 1], K_T: [0.4, 0], K_Q: [0.06, 0.01]"), "begins at 0.2"));
  EXPECT_TRUE(contains(table("J: [0, 1, 0.5], K_T: [0.4, 0, 0], K_Q: [0.06, 0.1, 0.1]"), "rising"));
  EXPECT_TRUE(contains(table("J: [0, 0.337123, 1], K_T: [0.4, 0.2, 0], K_Q: [0.06, 0.05, 0.02]"),
                       "no common step"));
  EXPECT_TRUE(contains(table("J: [0, 1], K_T: [-0.4, 0], K_Q: [0.06, 0.01]"), "at J = 0"));
  EXPECT_TRUE(contains(table("J: [0, 0.2, 0.4], K_T: [0.3, 0.1, 0.5], K_Q: [0.06, 0.06, 0.5]"),
                       "rises from 0.1 at J = 0.2 to 0.5 at J = 0.4"));
  EXPECT_TRUE(contains(table("J: [0, 1], K_T: [0.4, 0], K_Q: [0.6, 0.1]"), "not 10 K_Q"));
  EXPECT_TRUE(contains(table("J: [0, 1], K_T: [0.4, 0.1], K_Q: [0.006, 0.004]"), "not 10 K_Q"));
  EXPECT_TRUE(contains(table("K_T: [4, -4], K_Q: [0.06], most_J: 1"), "comes to 4 at J = 0"));
  EXPECT_TRUE(contains(table("K_T: [], K_Q: [0.06], most_J: 1"), "found 0 coefficients of K_T"));
}

}  // namespace
}  // namespace slackwater::twin::open_water_test

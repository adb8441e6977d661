#include "twin/thruster/actuator_disc.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin::actuator_disc_test {
namespace {

/// 2 rho A of the T200's 76 mm in sea water.
constexpr double disc = 2 * 1025 * constants::pi * 0.076 * 0.076 / 4;

TEST(ActuatorDisc, TheFlowThroughItSolvesItsCubic) {
  for (double k = -0.5; k < 1e4; k += 0.01 + 0.05 * std::abs(k)) {
    const double z = flow_through_disc(k);
    // z - k has lost the digits that k has before them.
    EXPECT_NEAR(z * z * (z - k), 1, 4e-15 * (1 + std::abs(k * k * k))) << k;
    EXPECT_GT(z, k);
  }
}

/// fields/docs/physics.md 11: T0 51.436 N at 16 V, hydraulic power 120.967 W.
TEST(ActuatorDisc, TheT200LosesInFlowWhatItsPowerLeaves) {
  const double rest_n = 51.436227;
  EXPECT_NEAR(disc_power_w(disc, rest_n, 0.0), 120.967358, 1e-5);
  const double expected_n[] = {47.797581, 44.201391, 40.697868, 37.341464};
  for (int i = 0; i < 4; ++i) {
    const double advance_m_s = 0.5 * (i + 1);
    const double thrust_n = thrust_in_flow(disc, rest_n, advance_m_s);
    EXPECT_NEAR(thrust_n, expected_n[i], 1e-5);
    EXPECT_NEAR(disc_power_w(disc, thrust_n, advance_m_s), 120.967358, 1e-5);
    EXPECT_EQ(thrust_in_flow(disc, -rest_n, -advance_m_s), -thrust_n);
  }
}

TEST(ActuatorDisc, FlowAgainstTheThrustAddsAtMostASixth) {
  const double rest_n = 40;
  EXPECT_GT(thrust_in_flow(disc, rest_n, -0.5), rest_n);
  EXPECT_NEAR(thrust_in_flow(disc, rest_n, -0.5), thrust_in_flow(disc, rest_n, -0.5001), 1e-2);
  EXPECT_EQ(thrust_in_flow(disc, rest_n, -30.0), thrust_in_flow(disc, rest_n, -3.0));
  EXPECT_NEAR(thrust_in_flow(disc, rest_n, -30.0) / rest_n, 1.166, 1e-3);
  EXPECT_EQ(thrust_in_flow(disc, -rest_n, 30.0), -thrust_in_flow(disc, rest_n, -30.0));
}

TEST(ActuatorDisc, WithoutThrustThereIsNoneInAnyFlow) {
  for (const double advance_m_s : {-20.0, -1.0, 0.0, 1e-9, 2.0, 50.0})
    EXPECT_EQ(thrust_in_flow(disc, 0.0, advance_m_s), 0);
}

TEST(ActuatorDisc, ThrustFallsSteadilyWithTheFlow) {
  for (const double rest_n : {0.01, 1.0, 50.0}) {
    double last = 2 * rest_n;
    for (double advance_m_s = -4; advance_m_s < 8; advance_m_s += 0.02) {
      const double thrust_n = thrust_in_flow(disc, rest_n, advance_m_s);
      EXPECT_LE(thrust_n, last);
      EXPECT_GT(thrust_n, 0);
      EXPECT_LT(last - thrust_n, std::max(0.2 * rest_n, 0.1) + (last == 2 * rest_n ? last : 0));
      last = thrust_n;
    }
  }
}

TEST(ActuatorDisc, TheThrustAtRestIsHadBack) {
  Rng random(11, "tests/actuator_disc");
  for (int i = 0; i < 1000; ++i) {
    const double rest_n = random.uniform(-60, 60);
    const double advance_m_s = random.uniform(-5, 5);
    const double thrust_n = thrust_in_flow(disc, rest_n, advance_m_s);
    EXPECT_NEAR(rest_thrust_n(disc, thrust_n, advance_m_s), rest_n, 1e-6) << advance_m_s;
  }
}

}  // namespace
}  // namespace slackwater::twin::actuator_disc_test

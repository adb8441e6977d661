// What a vehicle's own conduct makes of a person's stick.
#include "twin/helm/shared_stick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"
#include "twin/body/attitude.h"

namespace slackwater::tests::shared_stick_test {
namespace {

using twin::HelmVelocity;
using twin::SharedStick;
using twin::Structure;
using twin::Triple;

const std::vector<Structure> pile{twin::Cylinder{0, 0, 4, -20, 30}};

twin::Measured at(double north_m, double east_m, double heading_rad = 0,
                  const Triple<double>& water_m_s = {}) {
  twin::Measured known;
  known.position_m = {north_m, east_m, 10};
  known.attitude = {std::cos(heading_rad / 2), 0, 0, std::sin(heading_rad / 2)};
  known.water_m_s = water_m_s;
  return known;
}

twin::StickLimits limits(double most_m_s, double stand_off_m, std::optional<double> fence_m,
                         std::span<const Structure> structures = pile) {
  return {{most_m_s, stand_off_m, fence_m}, {100, 0, 0}, structures};
}

TEST(SharedStick, LeavesToTheLastBitWhatNothingSpeaksAgainst) {
  const HelmVelocity asked{0.1, -0.3, 0.123, 0.2};
  const SharedStick shared = shared_stick(asked, at(50, 3, 1.1), limits(0.5, 0.8, 120));
  EXPECT_EQ(shared.velocity.surge_m_s, asked.surge_m_s);
  EXPECT_EQ(shared.velocity.sway_m_s, asked.sway_m_s);
  EXPECT_EQ(shared.velocity.heave_m_s, asked.heave_m_s);
  EXPECT_EQ(shared.velocity.yaw_rate_rad_s, asked.yaw_rate_rad_s);
  EXPECT_FALSE(shared.is_slowed || shared.is_kept_off || shared.is_kept_in);
}

TEST(SharedStick, SlowsDownWithoutTurningAndLeavesTheTurn) {
  const SharedStick shared = shared_stick({0.6, 0, 0.8, 0.4}, at(50, 3), limits(0.5, 0, {}));
  EXPECT_TRUE(shared.is_slowed);
  EXPECT_NEAR(shared.velocity.surge_m_s, 0.3, 1e-12);
  EXPECT_NEAR(shared.velocity.heave_m_s, 0.4, 1e-12);
  EXPECT_EQ(shared.velocity.yaw_rate_rad_s, 0.4);
}

// d' = -k d: held at the stick all the way, the distance left is d0 exp(-0.5 t).
TEST(SharedStick, ComesNearAStructureAsTheExponentialOfItsBarrier) {
  double north_m = 4 + 0.8 + 1;  // 1 m before the stand-off, heading south at the pile
  const double dt_s = 1e-3;
  double t_s = 0;
  for (; t_s < 6; t_s += dt_s) {
    const SharedStick shared = shared_stick({2, 0, 0, 0}, at(north_m, 0, M_PI), limits(0, 0.8, {}));
    EXPECT_TRUE(shared.is_kept_off);
    north_m -= dt_s * shared.velocity.surge_m_s;
  }
  EXPECT_NEAR(north_m - 4.8, std::exp(-0.5 * t_s), 1e-3);
}

TEST(SharedStick, HoldsAgainstACurrentAndSlidesAlong) {
  // On the stand-off, north of the pile; the current sets on it, the stick asks for nothing.
  const SharedStick held = shared_stick({}, at(4.8, 0, 0, {-0.4, 0, 0}), limits(0, 0.8, {}));
  EXPECT_NEAR(held.velocity.surge_m_s, 0.4, 1e-6);
  // Aslant at it only the part towards it is taken.
  const SharedStick aslant = shared_stick({-1, 0.7, 0.2, 0}, at(4.8, 0), limits(0, 0.8, {}));
  EXPECT_NEAR(aslant.velocity.surge_m_s, 0, 1e-6);
  EXPECT_NEAR(aslant.velocity.sway_m_s, 0.7, 1e-6);
  EXPECT_NEAR(aslant.velocity.heave_m_s, 0.2, 1e-12);
}

TEST(SharedStick, LeadsOutOfWhatItIsAcrossAlreadyAndNotFast) {
  const SharedStick inside = shared_stick({-1, 0, 0, 0}, at(4.3, 0), limits(0, 0.8, {}));
  EXPECT_NEAR(inside.velocity.surge_m_s, 0.25, 1e-6);
  const SharedStick far_out = shared_stick({0, 0, 0, 0}, at(-900, 0), limits(0, 0, 120));
  EXPECT_TRUE(far_out.is_kept_in);
  EXPECT_NEAR(far_out.velocity.surge_m_s, 0.3, 1e-9);
}

// Whatever is asked from wherever, in whatever current: held for long, no barrier is crossed.
TEST(SharedStick, NeverCrossesStandOffNorFenceWhateverIsAsked) {
  Rng rng(7, "sticks");
  const auto draw = [&](double most) { return most * (2 * rng.uniform() - 1); };
  const double dt_s = 0.05;
  for (int run = 0; run < 200; ++run) {
    const double bearing = draw(M_PI), out_m = 5.2 + 14 * rng.uniform();
    Triple<double> at_m{out_m * std::cos(bearing), out_m * std::sin(bearing), 10};
    const Triple<double> water{draw(0.5), draw(0.5), 0};
    const double heading = draw(M_PI);
    for (int step = 0; step < 400; ++step) {
      const HelmVelocity asked{draw(1.5), draw(1.5), draw(0.5), 0};
      twin::Measured known = at(at_m.x, at_m.y, heading, water);
      const SharedStick shared = shared_stick(asked, known, limits(0, 0.8, 120));
      const double c = std::cos(heading), s = std::sin(heading);
      at_m = at_m +
             dt_s * Triple<double>{
                        c * shared.velocity.surge_m_s - s * shared.velocity.sway_m_s + water.x,
                        s * shared.velocity.surge_m_s + c * shared.velocity.sway_m_s + water.y, 0};
      ASSERT_GT(std::hypot(at_m.x, at_m.y), 4.8 - 1e-3) << run << " " << step;
      ASSERT_LT(std::hypot(at_m.x - 100, at_m.y), 120 + 1e-3) << run << " " << step;
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::shared_stick_test

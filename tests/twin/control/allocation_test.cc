#include "twin/control/allocation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/twin/control/craft_for_tests.h"

namespace slackwater::twin::allocation_test {
namespace {

Spatial<double> along(Axis axis, double amount) {
  AxisNumbers w{};
  w[static_cast<std::size_t>(axis)] = amount;
  return {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}};
}

Allocation bluerov2() {
  return plan_allocation(tests::bluerov2_mounts(), tests::t200_ranges(8), tests::six_axes_levels());
}

TEST(ThrustAllocation, GivesTheWrenchThatIsAskedForOnAllSixAxesOfAnRov) {
  const Allocation a = bluerov2();
  Rng random(11, "tests/allocation");
  for (int k = 0; k < 200; ++k) {
    AxisNumbers w{};
    for (std::size_t i = 0; i < axes; ++i) w[i] = random.uniform(-3, 3);
    const Thrusts t = allocate(a, {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}});
    const AxisNumbers had = numbers_of(wrench_of(a, t.thrust_n));
    for (std::size_t i = 0; i < axes; ++i) EXPECT_NEAR(had[i], w[i], 1e-12) << i;
  }
}

TEST(ThrustAllocation, OfManyWaysTakesTheOneOfLeastSquare) {
  const Allocation a = bluerov2();
  const Spatial<double> wrench{{10, 4, -6}, {0.5, -0.3, 1}};
  const Thrusts t = allocate(a, wrench);
  const auto square = [&](const std::array<double, most_mounts>& thrust) {
    double sum = 0;
    for (const double x : thrust) sum += x * x;
    return sum;
  };
  // The four horizontal thrusters may push against each other without moving the vehicle.
  for (const double against : {0.5, -0.5}) {
    auto other = t.thrust_n;
    for (std::size_t i = 0; i < 4; ++i) other[i] += against;
    const AxisNumbers same = numbers_of(wrench_of(a, other)), asked = numbers_of(wrench);
    for (std::size_t i = 0; i < axes; ++i) EXPECT_NEAR(same[i], asked[i], 1e-12);
    EXPECT_GT(square(other), square(t.thrust_n) + 0.9);
  }
}

TEST(ThrustAllocation, FullAheadIsTheBollardThrustOfTheDataSheet) {
  // 129.2 N = cos 45 (2 x 51.44 + 2 x 39.91): only when the forward pair pushes less than the after
  // pair.
  const Allocation a = bluerov2();
  const double sheet_n = std::sqrt(0.5) * (2 * 51.44 + 2 * 39.91);
  EXPECT_NEAR(sheet_n, 129.2, 0.05);
  for (const double asked : {129.0, 150.0, 1e4, 1e300}) {
    const Spatial<double> had = wrench_of(a, allocate(a, along(Axis::surge, asked)).thrust_n);
    EXPECT_NEAR(had.linear.x, sheet_n, 0.004 * sheet_n) << asked;
    EXPECT_NEAR(had.linear.y, 0, 1e-9);
    EXPECT_NEAR(had.angular.z, 0, 1e-9);
  }
  // Up 4 x 39.91, down 4 x 51.44, ranges being what they are.
  EXPECT_NEAR(a.most_astern[2], 159.6, 0.5);
  EXPECT_NEAR(a.most_ahead[2], 205.7, 0.6);
}

TEST(ThrustAllocation, TooMuchKeepsDirectionWithinALevelAndServesTheFirstLevelFirst) {
  const Allocation a = bluerov2();
  Rng random(12, "tests/allocation");
  for (int k = 0; k < 500; ++k) {
    const double size = std::pow(10, random.uniform(0, 4));
    AxisNumbers w{};
    for (std::size_t i = 0; i < axes; ++i) w[i] = size * random.uniform(-1, 1);
    const Thrusts t = allocate(a, {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}});
    for (std::size_t i = 0; i < 8; ++i) {
      EXPECT_LE(t.thrust_n[i], 51.44);
      EXPECT_GE(t.thrust_n[i], -39.91);
    }
    const AxisNumbers had = numbers_of(wrench_of(a, t.thrust_n));
    for (std::size_t i = 0; i < axes; ++i) {
      EXPECT_NEAR(had[i], t.share[i] * w[i], 1e-9 * size) << i << " of " << size;
      EXPECT_GE(t.share[i], 0);
      EXPECT_LE(t.share[i], 1);
    }
    EXPECT_EQ(t.share[0], t.share[1]);
    EXPECT_EQ(t.share[2], t.share[3]);
    // As if nothing else had been asked.
    const Thrusts alone = allocate(a, {{0, 0, w[2]}, {w[3], w[4], 0}});
    EXPECT_NEAR(t.share[2], alone.share[2], 1e-9);
  }
  // Depth is held while the vehicle is driven as hard as it can be.
  const Thrusts t = allocate(a, {{500, 0, 60}, {}});
  EXPECT_NEAR(wrench_of(a, t.thrust_n).linear.z, 60, 1e-9);
  EXPECT_GT(wrench_of(a, t.thrust_n).linear.x, 125);
}

TEST(ThrustAllocation, AHoveringQuadrotorSharesItsWeightEvenly) {
  const Allocation a =
      plan_allocation(tests::x500_mounts(), tests::x500_ranges(), tests::multirotor_axes());
  EXPECT_FALSE(a.commands(Axis::surge));
  EXPECT_TRUE(a.commands(Axis::yaw));
  const Thrusts t = allocate(a, along(Axis::heave, -2.064308 * 9.80665));
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(t.thrust_n[i], 5.061, 5e-4);
  // To starboard down: the port rotors push more; nose to the right: those that turn to the left.
  const Thrusts roll = allocate(a, {{0, 0, -20}, {0.5, 0, 0}});
  EXPECT_GT(roll.thrust_n[1], roll.thrust_n[0]);
  const Thrusts yaw = allocate(a, {{0, 0, -20}, {0, 0, 0.1}});
  EXPECT_GT(yaw.thrust_n[0], yaw.thrust_n[2]);
  // Too much of everything: thrust first, tilt with what is left, no rotor backwards.
  const Thrusts all = allocate(a, {{0, 0, -30}, {50, 20, 5}});
  const Spatial<double> had = wrench_of(a, all.thrust_n);
  EXPECT_NEAR(had.linear.z, -30, 1e-9);
  EXPECT_NEAR(had.angular.x / had.angular.y, 2.5, 1e-9);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_GE(all.thrust_n[i], 0);
}

TEST(ThrustAllocation, ASinglePropellerDrivesAndDoesNotSteer) {
  const std::vector<Mount> mount{{{-1.43, 0, 0}, {1, 0, 0}, 1}};
  const std::vector<ThrustRange> range{{-4, 8, 0.02}};
  const std::vector<WantedAxis> wanted{{Axis::surge, 0}, {Axis::sway, 0},  {Axis::heave, 0},
                                       {Axis::roll, 0},  {Axis::pitch, 0}, {Axis::yaw, 0}};
  const Allocation a = plan_allocation(mount, range, wanted);
  EXPECT_TRUE(a.commands(Axis::surge));
  EXPECT_NEAR(a.most_ahead[0], 8, 0.02);
  EXPECT_NEAR(a.most_astern[0], 4, 0.01);
  // Its torque rolls the hull, as a matter of fact and not of choice.
  EXPECT_NEAR(wrench_of(a, allocate(a, along(Axis::surge, 5)).thrust_n).angular.x, -0.1, 1e-12);
  for (const Axis axis : {Axis::roll, Axis::sway, Axis::heave, Axis::pitch, Axis::yaw})
    EXPECT_FALSE(a.commands(axis));
}

TEST(ThrustAllocation, TwoOutboardsDriveAndSteerAndLeaveTheRestAlone) {
  const Allocation a =
      plan_allocation(tests::wamv_mounts(), tests::outboard_ranges(), tests::surface_axes());
  EXPECT_TRUE(a.commands(Axis::surge));
  EXPECT_TRUE(a.commands(Axis::yaw));
  EXPECT_FALSE(a.commands(Axis::sway));
  EXPECT_NEAR(a.most_ahead[0], 500, 1.5);
  EXPECT_NEAR(a.most_astern[0], 200, 0.6);
  EXPECT_NEAR(a.most_ahead[5], 2 * 1.027135 * 100, 0.6);  // one full astern holds the other back
  const Thrusts turn = allocate(a, along(Axis::yaw, 20));
  EXPECT_GT(turn.thrust_n[0], 0);  // port ahead: bow to starboard
  EXPECT_NEAR(turn.thrust_n[0], -turn.thrust_n[1], 1e-9);
  // Full ahead and hard over: the turn is had, and what is left of the way.
  const Thrusts both = allocate(a, {{500, 0, 0}, {0, 0, 60}});
  EXPECT_NEAR(wrench_of(a, both.thrust_n).angular.z, 60, 1e-9);
  EXPECT_NEAR(both.thrust_n[0], 250, 1.5);
}

TEST(ThrustAllocation, AStrongerThrusterTakesMore) {
  const std::vector<Mount> mounts{{{0, 0, 0}, {1, 0, 0}, 1}, {{0, 0, 0}, {1, 0, 0}, 1}};
  const std::vector<ThrustRange> ranges{{-10, 10, 0}, {-30, 30, 0}};
  const std::vector<WantedAxis> surge{{Axis::surge, 0}};
  const Thrusts t = allocate(plan_allocation(mounts, ranges, surge), along(Axis::surge, 10));
  EXPECT_NEAR(t.thrust_n[1], 9, 1e-9);  // as the squares of their limits
  EXPECT_NEAR(t.thrust_n[0], 1, 1e-9);
}

TEST(ThrustAllocation, RefusesRangesThatCannotStandStill) {
  const std::vector<Mount> mount{{{0, 0, 0}, {1, 0, 0}, 1}};
  const std::vector<ThrustRange> range{{1, 8, 0}};
  EXPECT_THROW((void)plan_allocation(mount, range, tests::six_axes_levels()), ContractViolation);
  EXPECT_THROW((void)plan_allocation({}, {}, tests::six_axes_levels()), ContractViolation);
}

}  // namespace
}  // namespace slackwater::twin::allocation_test

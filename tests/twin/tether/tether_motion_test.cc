#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

#include "fields/base/numbers/random.h"
#include "tests/twin/tether/tether_for_tests.h"

namespace slackwater::twin::tether_motion_test {
namespace {

using tests::fathom;
using State = TetherState<double>;

static_assert(std::is_trivially_copyable_v<State>, "a checkpoint copies it as it is");

WaterAtNodes<double> everywhere(const Triple<double>& velocity_m_s) {
  WaterAtNodes<double> water;
  water.velocity_m_s.fill(velocity_m_s);
  return water;
}

TEST(TetherMotion, ALineTowedThroughStillWaterPullsAsOneHeldInACurrent) {
  const Tether tether = fathom();
  const Triple<double> current{0.4, -0.3, 0};
  const Triple<double> top{0, 0, 2}, vehicle{5, 5, 40};
  State held = laid_out(tether, top, vehicle, 55, {1, 0, 0});
  State towed = held;
  for (Triple<double>& v : towed.velocity_m_s) v = -1.0 * current;
  constexpr double dt_s = 0.02;
  for (int i = 0; i < 3000; ++i) {
    const Triple<double> gone = (-i * dt_s) * current;
    const auto a =
        pull(tether, held, TetherEnds<double>{top, {}, vehicle, {}}, everywhere(current), dt_s);
    const auto b =
        pull(tether, towed,
             TetherEnds<double>{top + gone, -1.0 * current, vehicle + gone, -1.0 * current},
             everywhere({}), dt_s);
    ASSERT_LT(length_of(a.on_vehicle_n - b.on_vehicle_n), 1e-6) << i;
    ASSERT_LT(length_of(a.on_top_n - b.on_top_n), 1e-6) << i;
  }
}

TEST(TetherMotion, TheStepDoesNotStandInTheBalance) {
  const Tether tether = fathom();
  const Triple<double> top{0, 0, 2}, vehicle{5, 5, 40};
  const SteadyWater water = [](double z) { return Triple<double>{0.6 - 0.01 * z, 0.1, 0}; };
  const State rest =
      settled(tether, laid_out(tether, top, vehicle, 55, {1, 0, 0}), top, vehicle, water);
  for (const double dt_s : {0.001, 0.01, 0.1}) {
    State state = rest;
    (void)pull(tether, state, TetherEnds<double>{top, {}, vehicle, {}},
               water_at_nodes(state, top, vehicle, water), dt_s);
    for (std::size_t i = 0; i < tether_inner_nodes; ++i) {
      EXPECT_LT(length_of(state.node_m[i] - rest.node_m[i]), 1e-9);
    }
  }
}

/// A line at rest is met by a current: it is carried to its new shape and settles there, whatever
/// the step.
TEST(TetherMotion, GoesToTheQuasiStaticShapeAndSoonerInAStrongerCurrent) {
  const Tether tether = fathom();
  const Triple<double> top{0, 0, 2}, vehicle{0, 0, 50};
  double before_s = 1e9;
  for (const double speed : {0.25, 0.5, 1.0}) {
    const Triple<double> flow{speed, 0, 0};
    const double steady = tests::settled_line(tether, top, vehicle, 55, [=](double) {
                            return flow;
                          }).pull.vehicle_tension_n;
    State state = laid_out(tether, top, vehicle, 55, {-1, 0, 0});
    double reached_s = 0;
    for (int i = 0; i < 40000; ++i) {
      const auto now =
          pull(tether, state, TetherEnds<double>{top, {}, vehicle, {}}, everywhere(flow), 0.02);
      if (std::abs(now.vehicle_tension_n - steady) > 0.02 * steady) reached_s = 0.02 * (i + 1);
    }
    // The bow crosses over, 2 x 9.6 m, no faster than the water goes.
    EXPECT_GT(reached_s, 15 / speed);
    EXPECT_LT(reached_s, 120 / speed);
    EXPECT_LT(reached_s, before_s);
    before_s = reached_s;
  }
}

TEST(TetherMotion, WaterAtRestTakesTheEnergyOfALineAndGivesNone) {
  Tether tether = tests::stiff_and_neutral();
  tether.axial_stiffness_n = 5e4;
  const Triple<double> top{0, 0, 10}, vehicle{20, 0, 20};
  Rng random(1, "tests/tether_energy");
  State state = laid_out(tether, top, vehicle, 40, {0, 1, 0});
  for (auto& v : state.velocity_m_s) v = {random.normal(), random.normal(), random.normal()};
  const auto energy = [&] {
    double sum = 0;
    for (const auto& v : state.velocity_m_s) sum += dot(v, v);
    return sum;
  };
  const double start = energy();
  for (int i = 0; i < 1000; ++i) {
    (void)pull(tether, state, TetherEnds<double>{top, {}, vehicle, {}}, everywhere({}), 0.02);
    ASSERT_LT(energy(), start);
  }
  EXPECT_LT(energy(), 1e-3 * start);
}

/// A vehicle that thrusts away from its winch comes to hang in its tether: the pull is its thrust,
/// without a tremble.
TEST(TetherMotion, AVehicleThatReachesTheEndOfItsLineIsHeld) {
  Tether tether = fathom();
  constexpr double mass_kg = 20, thrust_n = 80;
  tether.vehicle_mobility_per_kg = 1 / mass_kg;
  for (const double length_m : {10.0, 50.0}) {
    for (const double dt_s : {0.02, 0.05}) {
      const Triple<double> top{0, 0, 20};
      Triple<double> at{0.8 * length_m, 0, 20}, v{};
      State state = laid_out(tether, top, at, length_m, {0, 1, 0});
      TetherPull<double> now;
      double most_n = 0;
      for (double t = 0; t < 120; t += dt_s) {
        now = pull(tether, state, TetherEnds<double>{top, {}, at, v}, everywhere({}), dt_s);
        const double drag = 4 + 46 * length_of(v);
        v = (1 / (1 + dt_s / mass_kg * drag)) *
            (v + (dt_s / mass_kg) * (now.on_vehicle_n + Triple<double>{thrust_n, 0, 0}));
        at = at + dt_s * v;
        most_n = std::max(most_n, now.vehicle_tension_n);
      }
      EXPECT_NEAR(now.vehicle_tension_n, thrust_n, 0.1) << length_m << " m, " << dt_s << " s";
      EXPECT_LT(length_of(v), 1e-2);
      // At most the jerk of its whole motion, v sqrt(k m), on top of its thrust.
      EXPECT_LT(most_n, thrust_n + 1.3 * std::sqrt(5e4 / length_m * mass_kg));
    }
  }
}

TEST(TetherMotion, ALineThatIsThrownAboutStaysALine) {
  Tether tether = fathom();
  constexpr double mass_kg = 20;
  tether.vehicle_mobility_per_kg = 1 / mass_kg;
  for (const double length_m : {10.0, 30.0, 150.0}) {
    for (const double dt_s : {0.02, 0.05}) {
      Rng random(7, "tests/tether_thrown");
      Triple<double> top{}, at{0, 0, 5}, v{}, thrust{};
      State state = laid_out(tether, top, at, length_m, {1, 0, 0});
      double fastest = 0, most_n = 0, stretched = 0;
      for (int i = 0; i < 20000; ++i) {
        const double t = i * dt_s;
        if (i % 250 == 0)
          thrust = {60 * random.normal(), 60 * random.normal(), 40 * random.normal()};
        const Triple<double> heave{0, 0, 1.5 * std::cos(0.8 * t)};
        const auto water =
            everywhere({0.7 * std::sin(t / 100), 0.7 * std::cos(t / 130), 0.3 * std::sin(t)});
        const auto now = pull(tether, state, TetherEnds<double>{top, heave, at, v}, water, dt_s);
        top = top + dt_s * heave;
        const double drag = 4 + 46 * length_of(v);
        Triple<double> force = thrust + now.on_vehicle_n;
        if (at.z < 0) force.z += 130;
        v = (1 / (1 + dt_s / mass_kg * drag)) * (v + (dt_s / mass_kg) * force);
        at = at + dt_s * v;
        most_n = std::max(most_n, now.vehicle_tension_n);
        for (const auto& node : state.velocity_m_s) fastest = std::max(fastest, length_of(node));
        for (std::size_t j = 1; j < tether_inner_nodes; ++j)
          stretched = std::max(stretched, length_of(state.node_m[j] - state.node_m[j - 1]));
      }
      EXPECT_EQ(state.whole, 1) << length_m << " m, " << dt_s << " s";
      EXPECT_LT(fastest, 25) << length_m << " m, " << dt_s << " s";
      EXPECT_LT(most_n, 700) << length_m << " m, " << dt_s << " s";
      // The strain at 700 N is 1.4 %, the rest what the turn of a segment within a step adds.
      EXPECT_LT(stretched, 1.04 * length_m / tether_segments);
    }
  }
}

TEST(TetherMotion, PartsAboveItsBreakingLoadAndThenPullsNoMore) {
  const Tether tether = fathom();
  const auto tension_of = [&](double distance_m) {
    State state = laid_out(tether, {0, 0, 20}, {49, 0, 20}, 50, {0, 1, 0});
    TetherPull<double> now;
    constexpr int steps = 5000;
    for (int i = 0; i < steps; ++i) {
      const double x = 49 + (distance_m - 49) * std::min(1.0, 2.0 * i / steps);
      now = pull(tether, state, TetherEnds<double>{{0, 0, 20}, {}, {x, 0, 20}, {}}, everywhere({}),
                 0.02);
    }
    EXPECT_EQ(now.whole, state.whole);
    return now;
  };
  const double at_1500_n = 50 * (1 + 1500 / 5e4), at_1600_n = 50 * (1 + 1600 / 5e4);
  EXPECT_NEAR(tension_of(at_1500_n).vehicle_tension_n, 1500, 2);
  EXPECT_EQ(tension_of(at_1500_n).whole, 1);
  const TetherPull<double> parted = tension_of(at_1600_n);
  EXPECT_EQ(parted.whole, 0);
  EXPECT_EQ(length_of(parted.on_vehicle_n), 0);
  EXPECT_EQ(parted.vehicle_tension_n, 0);
}

}  // namespace
}  // namespace slackwater::twin::tether_motion_test

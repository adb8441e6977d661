#include "twin/tether/long_step.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/tether/tether_for_tests.h"

namespace slackwater::twin::long_step_test {
namespace {

const Triple<double> top_m{0, 0, 1};
const Triple<double> vehicle_m{14, 3, 12};

Triple<double> sheared(double depth_m) { return {0.1, 0.6 - 0.02 * depth_m, 0}; }

TEST(LongStep, KeepsTheShapeThatSteadyWaterGives) {
  const Tether tether = tests::fathom();
  const auto line = tests::settled_line(tether, top_m, vehicle_m, 40, sheared);
  TetherState<double> state = line.state;
  TetherPull<double> felt;
  for (int step = 0; step < 600; ++step) {
    const WaterAtNodes<double> water = water_at_nodes(state, top_m, vehicle_m, sheared);
    felt = pull_long(tether, state, {top_m, {}, vehicle_m, {}}, water, water, 0.1);
  }
  // What `settled` takes for rest: 1e-12 m/s.
  EXPECT_NEAR(felt.top_tension_n, line.pull.top_tension_n, 1e-6 * line.pull.top_tension_n);
  EXPECT_NEAR(felt.on_vehicle_n.x, line.pull.on_vehicle_n.x, 1e-6);
  for (std::size_t i = 0; i < tether_inner_nodes; ++i)
    EXPECT_NEAR(length_of(state.node_m[i] - line.state.node_m[i]), 0, 1e-6) << i;
}

/// Tensions at the top over 40 s of a swell of 4 s over a current, after 20 s of it.
struct Tensions {
  double mean_n = 0;
  double most_n = 0;
};
template <typename Pull>
Tensions in_waves(Pull&& pull, double dt_s) {
  const Tether tether = tests::fathom();
  TetherState<double> state = tests::settled_line(tether, top_m, vehicle_m, 40, sheared).state;
  const auto water_at = [&](double t_s) {
    constexpr double k = 0.25, omega = 2 * constants::pi / 4;
    WaterAtNodes<double> water;
    for (std::size_t i = 0; i < tether_nodes; ++i) {
      const Triple<double>& at = i == 0                  ? top_m
                                 : i == tether_nodes - 1 ? vehicle_m
                                                         : state.node_m[i - 1];
      const double speed_m_s = 0.9 * std::exp(-k * at.z);
      const double phase = k * at.y - omega * t_s;
      water.velocity_m_s[i] = sheared(at.z) + Triple<double>{0, speed_m_s * std::cos(phase),
                                                             -speed_m_s * std::sin(phase)};
    }
    return water;
  };
  Tensions out;
  const auto steps = static_cast<int>(std::lround(60 / dt_s));
  int counted = 0;
  for (int step = 0; step < steps; ++step) {
    const double t_s = step * dt_s;
    pull(tether, state, water_at(t_s), water_at(t_s + dt_s), dt_s);
    if (t_s < 20) continue;
    out.mean_n += state.tension_n[0];
    out.most_n = std::max(out.most_n, state.tension_n[0]);
    ++counted;
  }
  out.mean_n /= counted;
  return out;
}

void by_long_steps(const Tether& tether, TetherState<double>& state,
                   const WaterAtNodes<double>& before, const WaterAtNodes<double>& after,
                   double dt_s) {
  (void)pull_long(tether, state, {top_m, {}, vehicle_m, {}}, before, after, dt_s);
}
void by_steps(const Tether& tether, TetherState<double>& state, const WaterAtNodes<double>& before,
              const WaterAtNodes<double>& /*after*/, double dt_s) {
  (void)pull(tether, state, {top_m, {}, vehicle_m, {}}, before, dt_s);
}

TEST(LongStep, GivesInWavesTheTensionsOfShortSteps) {
  const Tensions exact = in_waves(by_steps, 0.002);
  const Tensions found = in_waves(by_long_steps, 0.1);
  EXPECT_NEAR(found.mean_n, exact.mean_n, 0.01 * exact.mean_n);
  EXPECT_NEAR(found.most_n, exact.most_n, 0.03 * exact.most_n);
  // Both formulas have one limit ...
  const Tensions fine = in_waves(by_long_steps, 0.002);
  EXPECT_NEAR(fine.mean_n, exact.mean_n, 0.002 * exact.mean_n);
  // ... from which the ordinary one is farther where steps are long.
  const double plain_n = in_waves(by_steps, 0.2).mean_n;
  EXPECT_GT(std::abs(plain_n - exact.mean_n),
            4 * std::abs(in_waves(by_long_steps, 0.2).mean_n - exact.mean_n));
}

TEST(LongStep, ComesToRestUnderTensionInStillWater) {
  // Little drag, much tension: what would swing itself up, at 2 Hz, faster than the step. The ends
  // stretch the line by 1 %.
  const Tether tether = tests::fathom();
  const Triple<double> far_m{0, 0, 21};
  TetherState<double> state = laid_out(tether, {0, 0, 1}, far_m, 19.8, {1, 0, 0});
  state.node_m[7].x += 0.05;
  double early_m_s = 0, late_m_s = 0;
  for (int step = 0; step < 600; ++step) {
    const TetherPull<double> felt = pull_long(tether, state, {{0, 0, 1}, {}, far_m, {}},
                                              WaterAtNodes<double>{}, WaterAtNodes<double>{}, 0.1);
    if (step < 100) continue;
    EXPECT_NEAR(felt.top_tension_n, 5e4 * (20.0 / 19.8 - 1), 10);
    double& most_m_s = step < 350 ? early_m_s : late_m_s;
    for (const Triple<double>& v : state.velocity_m_s) most_m_s = std::max(most_m_s, length_of(v));
  }
  EXPECT_LT(early_m_s, 0.2);
  EXPECT_LT(late_m_s, 0.5 * early_m_s);
}

}  // namespace
}  // namespace slackwater::twin::long_step_test

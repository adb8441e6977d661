#include "fields/wind/wake_turbulence.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/wind/farm_flow.h"
#include "tests/support/shared_data.h"

namespace slackwater::wake_turbulence_test {
namespace {

constexpr double d_m = 126.0;

const Turbine& nrel_5mw() {
  static const Turbine turbine =
      Turbine::load(tests::source_folder() / "data" / "turbines" / "nrel_5mw.yaml");
  return turbine;
}

FarmFlow behind_one(bool added = true) {
  const std::vector<Horizontal> one{{0, 0}};
  FarmSettings settings;
  settings.added_turbulence = added;
  return FarmFlow(nrel_5mw(), one, {10, 0}, settings);
}

TEST(WakeTurbulenceShape, IsLargestBehindTheTipsOfTheBlades) {
  for (const double width : {0.25, 0.5, 1.0}) {
    EXPECT_NEAR(wake_turbulence_shape(0.5, 1, width), 1, 1e-12);
    for (double r = 0; r < 3; r += 0.05) EXPECT_LE(wake_turbulence_shape(r, 1, width), 1 + 1e-9);
    // On the axis both halves are cos^2(pi/4) = 1/2 of e^(-D^2/8 s^2).
    EXPECT_NEAR(wake_turbulence_shape(0, 1, width), std::exp(-0.125 / (width * width)), 1e-12);
  }
}

TEST(WakeTurbulenceShape, IsContinuousAndDiesAway) {
  EXPECT_NEAR(wake_turbulence_shape(0.5 - 1e-9, 1, 0.3), wake_turbulence_shape(0.5 + 1e-9, 1, 0.3),
              1e-8);
  EXPECT_LT(wake_turbulence_shape(0.5 + 5 * 0.3, 1, 0.3), 1e-5);
}

TEST(FarmTurbulence, IsThatOfTheFreeWindAheadAndBeside) {
  const FarmFlow flow = behind_one();
  EXPECT_DOUBLE_EQ(flow.turbulence_intensity({-300, 0}, 90), 0.08);
  EXPECT_DOUBLE_EQ(flow.turbulence_intensity({7 * d_m, 8 * d_m}, 90), 0.08);
  EXPECT_DOUBLE_EQ(behind_one(false).turbulence_intensity({7 * d_m, 0}, 90), 0.08);
}

TEST(FarmTurbulence, AddsWhatCrespoAndHernandezHaveBehindTheTips) {
  const FarmFlow flow = behind_one();
  const double ct = nrel_5mw().thrust_coefficient(10);
  for (const double x : {4.0, 7.0, 12.0}) {
    const double expected = std::hypot(0.08, added_turbulence(ct, 0.08, x));
    EXPECT_NEAR(flow.turbulence_intensity({x * d_m, 0.5 * d_m}, 90), expected, 1e-12) << x;
    EXPECT_NEAR(flow.turbulence_intensity({x * d_m, 0}, 90 + 0.5 * d_m), expected, 1e-12) << x;
    EXPECT_GT(flow.turbulence_intensity({x * d_m, 0}, 90), 0.08);
  }
  // Just behind the rotor no more than the near wake: 0.362 (1 - sqrt(1 - Ct)).
  EXPECT_NEAR(flow.turbulence_intensity({0.01 * d_m, 0.5 * d_m}, 90),
              std::hypot(0.08, 0.362 * (1 - std::sqrt(1 - ct))), 1e-12);
}

TEST(FarmTurbulence, TakesTheStrongestOfSeveralWakes) {
  const std::vector<Horizontal> two{{0, 0}, {5 * d_m, 0}};
  const FarmFlow flow(nrel_5mw(), two, {10, 0}, {});
  const FarmFlow first = behind_one();
  const Horizontal at{10 * d_m, 0.5 * d_m};
  // Five diameters behind the second, whose own wind is slowed; ten behind the first.
  const TurbineFlow& second = flow.turbines()[1];
  const double added =
      second.inflow_speed_m_s / 10 * added_turbulence(second.thrust_coefficient, 0.08, 5);
  EXPECT_NEAR(flow.turbulence_intensity(at, 90),
              std::max(first.turbulence_intensity(at, 90), std::hypot(0.08, added)), 1e-12);
}

TEST(FarmTurbulence, IsNoneBehindARotorThatStandsStill) {
  const std::vector<Horizontal> one{{0, 0}};
  EXPECT_DOUBLE_EQ(FarmFlow(nrel_5mw(), one, {2, 0}, {}).turbulence_intensity({500, 63}, 90), 0.08);
}

}  // namespace
}  // namespace slackwater::wake_turbulence_test

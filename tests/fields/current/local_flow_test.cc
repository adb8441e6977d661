#include "fields/current/local_flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::local_flow_test {
namespace {

constexpr Pile monopile{.diameter_m = 6.0, .drag_coefficient = 1.05};
constexpr double radius_m = 3.0;
constexpr Horizontal to_east{0.8, 0.0};

Horizontal flow(Horizontal current, Horizontal at) {
  const auto value = flow_around_pile(monopile, current, at);
  EXPECT_TRUE(value.has_value());
  return value.value_or(Horizontal(std::nan(""), std::nan("")));
}

TEST(PotentialFlowAroundPile, RunsTwiceAsFastAtTheSidesAndStandsAtBothEnds) {
  for (const double side : {-1.0, 1.0}) {
    const Horizontal flank = potential_flow_around_pile(monopile, to_east, {0, side * radius_m});
    EXPECT_NEAR(std::abs(flank - 2.0 * to_east), 0, 1e-15);
    const Horizontal end = potential_flow_around_pile(monopile, to_east, {side * radius_m, 0});
    EXPECT_NEAR(std::abs(end), 0, 1e-15);
  }
}

TEST(PotentialFlowAroundPile, HasNeitherDivergenceNorRotation) {
  Rng rng(7, "local_flow");
  constexpr double h = 1e-3;
  for (int i = 0; i < 200; ++i) {
    const Horizontal at = std::polar(rng.uniform(1.05, 6) * radius_m, rng.uniform(-3.1, 3.1));
    const Horizontal current = std::polar(rng.uniform(0.1, 2), rng.uniform(-3.1, 3.1));
    const auto part = [&](Horizontal p) {
      return potential_flow_around_pile(monopile, current, p);
    };
    const Horizontal de = (part(at + h) - part(at - h)) / (2 * h);
    const Horizontal dn = (part(at + Horizontal(0, h)) - part(at - Horizontal(0, h))) / (2 * h);
    // Central differences: third derivative 24 U R^2/r^5 times h^2/6, below 1e-6 1/s.
    EXPECT_NEAR(de.real() + dn.imag(), 0, 1e-6);
    EXPECT_NEAR(de.imag() - dn.real(), 0, 1e-6);
  }
}

TEST(FlowAroundPile, PassesNoWaterThroughTheWall) {
  for (int i = 0; i < 360; ++i) {
    // A hair outside: the wall itself may round to the inside.
    const Horizontal outward = std::polar(1.0, i * constants::pi / 180);
    const Horizontal velocity = flow({0.5, -0.6}, (radius_m * (1 + 1e-14)) * outward);
    EXPECT_NEAR((velocity * std::conj(outward)).real(), 0, 1e-12) << i << " deg";
  }
}

TEST(FlowAroundPile, IsNoNumberInsideThePile) {
  EXPECT_FALSE(flow_around_pile(monopile, to_east, {0, 0}).has_value());
  EXPECT_FALSE(flow_around_pile(monopile, to_east, {2.9, 0.5}).has_value());
  EXPECT_FALSE(flow_around_pile(monopile, to_east, {std::nan(""), 0}).has_value());
  EXPECT_TRUE(flow_around_pile(monopile, to_east, {3.0, 0}).has_value());
}

/// The integral of (U - w) w over y at a distance x behind the axis, w the wake's deficit.
double momentum_deficit(const Pile& pile, double speed_m_s, double x_m) {
  double total = 0;
  constexpr double dy = 0.01;
  // The trapezium over a whole Gaussian converges faster than any power of the step.
  for (int i = -20000; i <= 20000; ++i) {
    const double w = -wake_behind_pile(pile, {speed_m_s, 0}, {x_m, i * dy}).real();
    total += (speed_m_s - w) * w * dy;
  }
  return total;
}

TEST(WakeBehindPile, CarriesTheDragOfThePileInItsMomentum) {
  for (const double cd : {0.4, 0.65, 1.05, 1.4})
    for (const double x_diameters : {1.5, 2.0, 5.0, 20.0, 100.0}) {
      const Pile pile{5.0, cd};
      const double drag_over_density = 0.5 * cd * pile.diameter_m * 0.7 * 0.7;
      EXPECT_NEAR(momentum_deficit(pile, 0.7, x_diameters * 5.0) / drag_over_density, 1, 1e-9)
          << "Cd " << cd << ", x/d " << x_diameters;
    }
}

TEST(WakeBehindPile, WidensWithTheRootOfTheDistanceAndFadesWithItsInverse) {
  // Schlichting: half-width 0.25 sqrt(Cd d x), far enough that the origin does not matter.
  const double x = 4000 * monopile.diameter_m;
  const double half_m = 0.25 * std::sqrt(monopile.drag_coefficient * monopile.diameter_m * x);
  const double axis = std::abs(wake_behind_pile(monopile, to_east, {x, 0}));
  EXPECT_NEAR(std::abs(wake_behind_pile(monopile, to_east, {x, half_m})) / axis, 0.5, 2e-3);
  EXPECT_NEAR(std::abs(wake_behind_pile(monopile, to_east, {4 * x, 0})) / axis, 0.5, 5e-3);
}

TEST(WakeBehindPile, IsAllBehindIt) {
  for (const double y : {-4.0, 0.0, 4.0}) {
    EXPECT_EQ(wake_behind_pile(monopile, to_east, {-5.0, y}), Horizontal());
    EXPECT_EQ(wake_behind_pile(monopile, to_east, {0.0, y}), Horizontal());
  }
  EXPECT_LT(wake_behind_pile(monopile, to_east, {9.0, 0}).real(), -0.4 * to_east.real());
}

TEST(FlowAroundPile, TurnsWithTheCurrent) {
  Rng rng(11, "local_flow/turn");
  for (int i = 0; i < 200; ++i) {
    const Horizontal at = std::polar(rng.uniform(1.01, 20) * radius_m, rng.uniform(-3.1, 3.1));
    const Horizontal turn = std::polar(1.0, rng.uniform(-3.1, 3.1));
    EXPECT_NEAR(std::abs(flow(to_east * turn, at * turn) - turn * flow(to_east, at)), 0, 1e-13);
  }
}

TEST(FlowAroundPile, IsTheMirrorImageOfItselfAcrossTheStream) {
  Rng rng(12, "local_flow/mirror");
  for (int i = 0; i < 100; ++i) {
    const Horizontal at = std::polar(rng.uniform(1.01, 9) * radius_m, rng.uniform(0, 3.1));
    EXPECT_NEAR(std::abs(flow(to_east, std::conj(at)) - std::conj(flow(to_east, at))), 0, 1e-15);
  }
}

TEST(FlowAroundPile, BecomesTheFreeStreamFarAway) {
  EXPECT_NEAR(std::abs(flow(to_east, {-600, 0}) - to_east), 0, 1e-4);
  EXPECT_NEAR(std::abs(flow(to_east, {0, 600}) - to_east), 0, 1e-4);
  // The wake recovers slowly: Cd d/(2 sqrt(2 pi) s) on its axis.
  EXPECT_NEAR(std::abs(flow(to_east, {6e6, 0}) - to_east), 0, 1e-3);
}

TEST(FlowAroundPile, HasNoJumpAnywhere) {
  // Along lines through every border of the formulas (x = 0, x = d, wall + d) steps of 1 mm change
  // the velocity by no more than the steepest gradient, 4 U/d near the wall and 3/d in the fade.
  const double largest = 8 * std::abs(to_east) / monopile.diameter_m * 1e-3;
  for (const double y : {0.0, 1.0, 2.9, 3.2, 6.0, 9.0, 12.0})
    for (double x = -15; x < 30; x += 1e-3) {
      if (std::hypot(x, y) < radius_m || std::hypot(x + 1e-3, y) < radius_m) continue;
      ASSERT_LT(std::abs(flow(to_east, {x + 1e-3, y}) - flow(to_east, {x, y})), largest)
          << x << ", " << y;
    }
}

TEST(FlowAroundPile, GrowsWithTheCurrentInProportion) {
  const Horizontal at{5.0, 2.0};
  EXPECT_NEAR(std::abs(flow(3.0 * to_east, at) - 3.0 * flow(to_east, at)), 0, 1e-15);
  EXPECT_EQ(flow({0, 0}, at), Horizontal());
}

TEST(FlowAroundPile, IsTheFreeStreamWhereNoPileStands) {
  EXPECT_EQ(flow_around_pile(Pile{}, to_east, {0, 0}), to_east);
}

}  // namespace
}  // namespace slackwater::local_flow_test

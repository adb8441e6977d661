#include "twin/tether/tension.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::tension_test {
namespace {

using Tensions = std::array<double, tether_segments>;

TensionSystem<double> random_system(Rng& random) {
  TensionSystem<double> s;
  for (std::size_t j = 0; j < tether_segments; ++j) {
    s.diagonal[j] = 2.001;
    if (j + 1 < tether_segments) s.beside[j] = -random.uniform(0.2, 1);
    // Slack in the one half of the line, stretched in the other, with a little of each strewn in.
    s.stretch_m[j] = (j < 8 ? 1 : -1) * random.uniform(0, 1) + 0.1 * random.normal();
  }
  return s;
}

/// Projected Gauss-Seidel, which converges for any symmetric positive definite matrix (Cryer 1971).
Tensions by_relaxation(const TensionSystem<double>& s) {
  Tensions t{};
  for (int sweep = 0; sweep < 20000; ++sweep) {
    for (std::size_t j = 0; j < tether_segments; ++j) {
      double left = s.stretch_m[j];
      if (j > 0) left -= s.beside[j - 1] * t[j - 1];
      if (j + 1 < tether_segments) left -= s.beside[j] * t[j + 1];
      t[j] = std::max(0.0, left / s.diagonal[j]);
    }
  }
  return t;
}

TEST(PullingTensions, AreThoseOfAnIndependentRelaxation) {
  Rng random(3, "tests/tensions");
  for (int trial = 0; trial < 50; ++trial) {
    const TensionSystem<double> s = random_system(random);
    const Tensions expected = by_relaxation(s);
    Tensions found{};
    for (int step = 0; step < 4; ++step) found = pulling_tensions(s, found);
    for (std::size_t j = 0; j < tether_segments; ++j)
      EXPECT_NEAR(found[j], expected[j], 1e-9) << trial << ", segment " << j;
  }
}

TEST(PullingTensions, NeverPushEvenFromTheWorstGuess) {
  Rng random(4, "tests/tensions");
  int undone = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    TensionSystem<double> s = random_system(random);
    // Hairpins too, where what relieves a segment burdens its neighbour.
    for (double& b : s.beside) b = random.uniform(-1, 1);
    for (double& g : s.stretch_m) g = random.normal();
    Tensions before;
    for (double& t : before) t = random.uniform(-1, 1);
    const Tensions expected = pulling_tensions(s, pulling_tensions(s, pulling_tensions(s, before)));
    bool same = true;
    const Tensions found = pulling_tensions(s, before);
    for (std::size_t j = 0; j < tether_segments; ++j) {
      ASSERT_GE(found[j], 0) << trial << ", segment " << j;
      same = same && std::abs(found[j] - expected[j]) < 1e-9;
    }
    undone += !same;
  }
  EXPECT_GT(undone, 0);  // so that the last resort has been tried
}

TEST(PullingTensions, OfAStretchedLineSolveTheWholeSystem) {
  TensionSystem<double> s;
  s.diagonal.fill(2);
  s.beside.fill(-1);
  s.stretch_m.fill(1);
  // -T'' = 1 with T = 0 at both ends, where differences are exact: T_j = (j + 1)(16 - j)/2.
  const Tensions t = pulling_tensions(s, {});
  for (std::size_t j = 0; j < tether_segments; ++j) {
    const auto x = static_cast<double>(j);
    EXPECT_NEAR(t[j], (x + 1) * (16 - x) / 2, 1e-12);
  }
}

TEST(PullingTensions, OfASlackLineAreNothing) {
  TensionSystem<double> s;
  s.diagonal.fill(2);
  s.beside.fill(-1);
  s.stretch_m.fill(-1);
  Tensions before;
  before.fill(100);
  for (const double t : pulling_tensions(s, before)) EXPECT_EQ(t, 0);
}

}  // namespace
}  // namespace slackwater::twin::tension_test

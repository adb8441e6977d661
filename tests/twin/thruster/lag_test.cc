#include "twin/thruster/lag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin::lag_test {
namespace {

/// T x' = command - x: x = c + (x0 - c) e^(-t/T).
TEST(Lag, IsTheExactSolutionWhateverTheStep) {
  for (const double dt_s : {0.01, 0.1, 0.5, 2.0}) {
    const LagStep step = lag_step(0.2, 0.2, dt_s);
    double value = -3, area = 0;
    for (double t = 0; t < 2 - 1e-9; t += dt_s) {
      const Lagged<double> lag = lagged(step, value, 5.0);
      area += lag.mean * dt_s;
      value = lag.end;
    }
    EXPECT_NEAR(value, 5 - 8 * std::exp(-10.0), 1e-12) << dt_s;
    EXPECT_NEAR(area, 10 - 8 * 0.2 * (1 - std::exp(-10.0)), 1e-12) << dt_s;
  }
}

TEST(Lag, RisesAndFallsWithTimeConstantsOfTheirOwn) {
  const LagStep step = lag_step(0.0125, 0.025, 0.004);
  EXPECT_NEAR(lagged(step, 500.0, 900.0).end, 900 - 400 * std::exp(-0.32), 1e-10);
  EXPECT_NEAR(lagged(step, 900.0, 500.0).end, 500 + 400 * std::exp(-0.16), 1e-10);
}

TEST(Lag, WithoutATimeConstantFollowsAtOnce) {
  const LagStep step = lag_step(0, 0, 0.1);
  EXPECT_EQ(lagged(step, -1.0, 0.7).mean, 0.7);
  EXPECT_EQ(lagged(step, -1.0, 0.7).end, 0.7);
}

TEST(Lag, StaysWhereItIsTold) {
  const LagStep step = lag_step(0.2, 0.3, 0.05);
  EXPECT_EQ(lagged(step, 0.4, 0.4).mean, 0.4);
  EXPECT_EQ(lagged(step, 0.4, 0.4).end, 0.4);
}

TEST(Lag, RefusesTimeThatRunsBackwards) {
  EXPECT_THROW((void)lag_step(0.2, -0.1, 0.05), ContractViolation);
  EXPECT_THROW((void)lag_step(0.2, 0.1, 0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::twin::lag_test

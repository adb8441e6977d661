#include "fields/wind/dryden_gust.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "fields/base/check.h"

namespace slackwater::dryden_gust_test {
namespace {

constexpr std::array<GustAxis, 3> all_axes{GustAxis::along, GustAxis::across, GustAxis::up};

double of(const Gust& gust, GustAxis axis) {
  return axis == GustAxis::along ? gust.along_m_s
                                 : (axis == GustAxis::across ? gust.across_m_s : gust.up_m_s);
}

TEST(DrydenTurbulence, HasThePublishedScales) {
  // fields/docs/physics.md, section 9.
  const DrydenTurbulence air = dryden_turbulence(30.0, 7.7167);
  EXPECT_NEAR(air.length_horizontal_m, 152.464823, 1e-4);
  EXPECT_NEAR(air.length_vertical_m, 30.0, 1e-12);
  EXPECT_NEAR(air.sigma_vertical_m_s, 0.77167, 1e-12);
  EXPECT_NEAR(air.sigma_horizontal_m_s, 1.3267255, 1e-4);
}

TEST(DrydenTurbulence, IsHeldWhereTheStandardEnds) {
  EXPECT_EQ(dryden_turbulence(0.5, 8), dryden_turbulence(3.048, 8));
  EXPECT_EQ(dryden_turbulence(900, 8), dryden_turbulence(304.8, 8));
}

TEST(DrydenFilter, HasTheExactAutocovarianceAtAnyStep) {
  // sigma^2 e^(-t/T) along, sigma^2 (1 - t/2T) e^(-t/T) across and up: von Karman and Howarth's
  // pair for an exponential f(r).
  const DrydenTurbulence air = dryden_turbulence(30.0, 7.7167);
  constexpr double airspeed = 12.0;
  for (const double step : {1e-4, 0.05, 0.5, 7.0, 60.0}) {
    const DrydenFilter filter(air, airspeed, step);
    for (const GustAxis axis : all_axes)
      for (const int k : {0, 1, 2, 10, 100}) {
        const bool up = axis == GustAxis::up;
        const double sigma = up ? air.sigma_vertical_m_s : air.sigma_horizontal_m_s;
        const double t =
            k * step * airspeed / (up ? air.length_vertical_m : air.length_horizontal_m);
        const double shape = axis == GustAxis::along ? 1 : 1 - 0.5 * t;
        // 1 - e^(-2h) of the shortest step, h = 8e-6, is known to 1e-11.
        EXPECT_NEAR(filter.autocovariance_m2_s2(axis, k), sigma * sigma * shape * std::exp(-t),
                    step < 1e-3 ? 1e-9 : 1e-12)
            << step << " s, " << k;
      }
  }
}

TEST(DrydenFilter, RealisesThatAutocovarianceFromItsFirstStep) {
  // Independent short series: N products scatter by less than sqrt(2/N) = 0.7 %, four times that is
  // allowed.
  const DrydenTurbulence air = dryden_turbulence(50.0, 10.0);
  const DrydenFilter filter(air, 10.0, 1.5);
  constexpr int series = 40000;
  constexpr int lag = 4;
  Rng rng(20240611, "dryden_test");
  for (const GustAxis axis : all_axes) {
    double square = 0;
    double lagged = 0;
    for (int i = 0; i < series; ++i) {
      DrydenFilter::State state = filter.stationary_state(rng);
      const double first = of(filter.gust(state), axis);
      double last = 0;
      for (int k = 0; k < lag; ++k) last = of(filter.step(state, rng), axis);
      square += last * last / series;
      lagged += first * last / series;
    }
    const double variance = filter.autocovariance_m2_s2(axis, 0);
    EXPECT_NEAR(square / variance, 1, 0.03);
    EXPECT_NEAR(lagged / variance, filter.autocovariance_m2_s2(axis, lag) / variance, 0.03);
  }
}

TEST(DrydenFilter, MakesTheStepNoDifferenceToTheStatistics) {
  const DrydenTurbulence air = dryden_turbulence(30.0, 8.0);
  const DrydenFilter fine(air, 15.0, 0.05);
  const DrydenFilter coarse(air, 15.0, 1.0);
  for (const GustAxis axis : all_axes) {
    EXPECT_NEAR(fine.autocovariance_m2_s2(axis, 20), coarse.autocovariance_m2_s2(axis, 1), 1e-12);
  }
}

TEST(DrydenFilter, StaysSmoothInTheSmallestSteps) {
  // The noise of the second state is of order h^3: naive subtraction would make it rounding.
  const DrydenTurbulence air{1.0, 1.0, 100.0, 100.0};
  Rng rng(3, "dryden_small");
  const DrydenFilter filter(air, 1.0, 1e-6);
  DrydenFilter::State state = filter.stationary_state(rng);
  const double x2 = state.up[1];
  static_cast<void>(filter.step(state, rng));
  // h = 1e-8: x2 moves by h (x1 - x2) and noise of sqrt(2/3) h^1.5.
  EXPECT_NEAR(state.up[1] - x2, 0, 1e-7);
}

TEST(DrydenFilter, RepeatsItselfForTheSameSeed) {
  const DrydenFilter filter(dryden_turbulence(30.0, 8.0), 12.0, 0.1);
  const auto run = [&](std::uint64_t seed) {
    Rng rng(seed, "dryden");
    DrydenFilter::State state = filter.stationary_state(rng);
    Gust gust;
    for (int i = 0; i < 50; ++i) gust = filter.step(state, rng);
    return gust;
  };
  EXPECT_EQ(run(1), run(1));
  EXPECT_NE(run(1), run(2));
}

TEST(DrydenFilter, RefusesStandingStill) {
  EXPECT_THROW(DrydenFilter(dryden_turbulence(30, 8), 0.0, 0.1), ContractViolation);
  EXPECT_THROW(DrydenFilter(dryden_turbulence(30, 8), 10.0, 0.0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::dryden_gust_test

#include "calibration/propagate/memory_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration::memory_kernel_test {
namespace {

constexpr double damping_per_h = 1.0 / 60;
constexpr double coriolis_rad_h = 0.42;

const MemoryCovariance& covariance() {
  static const MemoryCovariance all(MemoryKernel{}, damping_per_h, coriolis_rad_h);
  return all;
}

/// Only the inertial term.
MemoryKernel inertial_alone() {
  MemoryKernel kernel;
  kernel.constant_m_s = kernel.slow_m_s = kernel.recent_m_s = 0;
  return kernel;
}

/// Mean of the covariance of instants over two cells by the midpoint rule, which owes to the kink
/// where they overlap an error of order 1/parts^2.
Horizontal by_quadrature(const HourCell& a, const HourCell& b, int parts) {
  Horizontal sum{};
  for (int i = 0; i < parts; ++i) {
    for (int j = 0; j < parts; ++j) {
      const auto instant = [&](const HourCell& cell, int k) {
        return HourCell::at(cell.from_h + cell.length_h() * (k + 0.5) / parts);
      };
      sum += covariance().between(instant(a, i), instant(b, j));
    }
  }
  return sum / static_cast<double>(parts * parts);
}

TEST(MemoryCovariance, OfMeansIsTheMeanOfThatOfInstants) {
  const HourCell day{-24, 0};
  const HourCell before{-48, -24};
  const HourCell across{-30, -6};
  const HourCell long_ago{-90, -82};
  for (const HourCell& a : {day, before, across, long_ago, HourCell::at(7), HourCell::at(-5)}) {
    for (const HourCell& b : {day, across, long_ago, HourCell::at(-30)}) {
      // 400 parts: h^2/24 of the curvature 0.2^2, and of the kinks, is below 1e-5 of the whole.
      const Horizontal expected = by_quadrature(a, b, 400);
      EXPECT_LT(std::abs(covariance().between(a, b) - expected), 1e-5 * std::abs(expected))
          << a.from_h << " " << b.from_h;
    }
  }
}

TEST(MemoryCovariance, IsHermitianAndItsTermsAddToTheVariance) {
  const std::vector<HourCell> cells{{-72, -48}, HourCell::at(-20), {-18, -12}, HourCell::at(0)};
  const Eigen::MatrixXcd matrix = covariance().between(cells, cells);
  EXPECT_LT((matrix - matrix.adjoint()).norm(), 1e-15);
  const MemoryKernel k;
  EXPECT_NEAR(covariance().variance_m2_s2(), matrix(3, 3).real(), 1e-15);
  EXPECT_NEAR(covariance().variance_m2_s2(),
              k.constant_m_s * k.constant_m_s + k.slow_m_s * k.slow_m_s +
                  k.inertial_m_s * k.inertial_m_s + k.recent_m_s * k.recent_m_s,
              1e-15);
}

TEST(MemoryCovariance, AMeanOverAnInertialPeriodHoldsNoInertialMotion) {
  const double period_h = 2 * std::acos(-1.0) / coriolis_rad_h;
  const MemoryCovariance slow(inertial_alone(), 1e-9, coriolis_rad_h);
  const HourCell mean{-period_h, 0};
  const double variance = slow.variance_m2_s2();
  EXPECT_LT(std::abs(slow.between(mean, mean)), 1e-8 * variance);
  EXPECT_LT(std::abs(slow.between(HourCell::at(5), mean)), 1e-8 * variance);
}

TEST(MemoryCovariance, InertialMotionTurnsClockwiseInTheNorthAndDecays) {
  const MemoryCovariance inertial(inertial_alone(), damping_per_h, coriolis_rad_h);
  const Horizontal later = inertial.between(HourCell::at(3), HourCell::at(0));
  EXPECT_NEAR(std::arg(later), -3 * coriolis_rad_h, 1e-12);
  EXPECT_NEAR(std::abs(later) / inertial.variance_m2_s2(), std::exp(-3 * damping_per_h), 1e-12);
}

TEST(MemoryKernel, AmplitudesFadeFromTheSurfaceToTheDeepShare) {
  const MemoryKernel kernel;
  EXPECT_DOUBLE_EQ(kernel.amplitude_at(0), 1.0);
  EXPECT_NEAR(kernel.amplitude_at(kernel.fading_depth_m),
              kernel.deep_share + (1 - kernel.deep_share) / std::exp(1.0), 1e-15);
  EXPECT_NEAR(kernel.amplitude_at(5000), kernel.deep_share, 1e-15);
}

TEST(HourCell, MeansOfThreeHoursStandAtTheirCentreAndLongerOnesAreMeans) {
  const UtcTime end{std::chrono::hours(24)};
  const HourCell three = HourCell::of({add_hours(end, -3), end}, end);
  EXPECT_TRUE(three.is_instant());
  EXPECT_DOUBLE_EQ(three.from_h, -1.5);
  const HourCell day = HourCell::of({add_hours(end, -24), end}, end);
  EXPECT_DOUBLE_EQ(day.from_h, -24);
  EXPECT_DOUBLE_EQ(day.to_h, 0);
}

TEST(MemoryCovariance, RefusesAMemoryWithoutNoiseDampingOrTime) {
  MemoryKernel kernel;
  EXPECT_THROW(MemoryCovariance(kernel, 0.0, coriolis_rad_h), ContractViolation);
  kernel.noise_m_s = 0;
  EXPECT_THROW(MemoryCovariance(kernel, damping_per_h, coriolis_rad_h), ContractViolation);
  kernel = {};
  kernel.recent_h = 0;
  EXPECT_THROW(MemoryCovariance(kernel, damping_per_h, coriolis_rad_h), ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::memory_kernel_test

#include "twin/body/spatial.h"

#include <gtest/gtest.h>

#include "tests/support/body_for_tests.h"

namespace slackwater::twin::spatial_test {
namespace {

using tests::random_triple;

SpatialMatrix random_symmetric(Rng& random) {
  SpatialMatrix m;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j <= i; ++j) m.entry[i][j] = m.entry[j][i] = random.normal();
  return m;
}

TEST(SpatialCoriolis, DoesNoWorkWhateverTheMassAndTheMotion) {
  Rng random(1, "tests/coriolis");
  for (int i = 0; i < 500; ++i) {
    const SpatialMatrix m = random_symmetric(random);
    const Spatial<double> nu{random_triple(random, 3), random_triple(random, 2)};
    const Spatial<double> force = coriolis(m, nu);
    EXPECT_NEAR(dot(nu.linear, force.linear) + dot(nu.angular, force.angular), 0, 2e-13 * 100);
  }
}

/// Fossen (2011) 6.44, for M_A = diag(a_1 ... a_6).
TEST(SpatialCoriolis, IsFossensForADiagonalAddedMass) {
  const std::array<double, 6> a{6.36, 7.12, 18.69, 0.19, 0.13, 0.22};
  SpatialMatrix m;
  for (std::size_t i = 0; i < 6; ++i) m.entry[i][i] = a[i];
  Rng random(2, "tests/coriolis");
  for (int i = 0; i < 100; ++i) {
    const Spatial<double> nu{random_triple(random), random_triple(random)};
    const auto [u, v, w] = nu.linear;
    const auto [p, q, r] = nu.angular;
    const Spatial<double> c = coriolis(m, nu);
    EXPECT_NEAR(c.linear.x, a[2] * w * q - a[1] * v * r, 1e-12);
    EXPECT_NEAR(c.linear.y, a[0] * u * r - a[2] * w * p, 1e-12);
    EXPECT_NEAR(c.linear.z, a[1] * v * p - a[0] * u * q, 1e-12);
    EXPECT_NEAR(c.angular.x, (a[2] - a[1]) * v * w + (a[5] - a[4]) * q * r, 1e-12);
    EXPECT_NEAR(c.angular.y, (a[0] - a[2]) * u * w + (a[3] - a[5]) * p * r, 1e-12);
    EXPECT_NEAR(c.angular.z, (a[1] - a[0]) * u * v + (a[4] - a[3]) * p * q, 1e-12);
  }
}

TEST(RigidMassMatrix, HoldsTheKineticEnergyOfTheMassAndOfItsTurning) {
  Rng random(3, "tests/mass");
  for (int i = 0; i < 100; ++i) {
    const Triple<double> g = random_triple(random);
    const Inertia inertia{3, 4, 5, 0.1, -0.2, 0.3};
    const SpatialMatrix m = rigid_mass_matrix(7, inertia, g);
    const Spatial<double> nu{random_triple(random), random_triple(random)};
    const Triple<double> moved = nu.linear + cross(nu.angular, g);
    const Triple<double>& w = nu.angular;
    const double turning = 3 * w.x * w.x + 4 * w.y * w.y + 5 * w.z * w.z +
                           2 * (0.1 * w.x * w.y - 0.2 * w.x * w.z + 0.3 * w.y * w.z);
    EXPECT_NEAR(kinetic_energy_j(m, nu), 0.5 * 7 * dot(moved, moved) + 0.5 * turning, 1e-11);
  }
}

TEST(InverseOfMass, IsTheInverseAndIsRefusedToWhatWouldGainEnergy) {
  const SpatialMatrix m = rigid_mass_matrix(7, {3, 4, 5, 0.1, -0.2, 0.3}, {0.1, 0.2, -0.3});
  const SpatialMatrix inverse = inverse_of(m).value();
  Rng random(4, "tests/mass");
  const Spatial<double> nu{random_triple(random), random_triple(random)};
  const Spatial<double> back = inverse * (m * nu);
  EXPECT_NEAR(back.linear.y, nu.linear.y, 1e-13);
  EXPECT_NEAR(back.angular.x, nu.angular.x, 1e-13);
  SpatialMatrix bad = m;
  bad.entry[0][0] = -7;
  EXPECT_FALSE(inverse_of(bad));
  bad = m;
  bad.entry[0][1] = 0.5;
  EXPECT_FALSE(inverse_of(bad));
}

TEST(PrincipalMoments, AscendAndDoNotDependOnTheAxes) {
  const auto moments = principal_moments({3, 4, 5, 0, 0, 0});
  EXPECT_NEAR(moments[0], 3, 1e-14);
  EXPECT_NEAR(moments[2], 5, 1e-14);
  // (3, 4) turned by 45 degrees about z.
  EXPECT_NEAR(principal_moments({3.5, 3.5, 5, -0.5, 0, 0})[1], 4, 1e-14);
}

}  // namespace
}  // namespace slackwater::twin::spatial_test

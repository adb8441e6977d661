#include "calibration/blend/simplex_quadratic.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::calibration::simplex_quadratic_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A Gram matrix of `samples` random errors plus a ridge; nearly singular where samples < size.
MatrixXd random_form(Index size, Index samples, double ridge, Rng& random) {
  MatrixXd errors(size, samples);
  for (Index i = 0; i < size; ++i) {
    const double level = std::exp(2.0 * random.normal());
    for (Index j = 0; j < samples; ++j) errors(i, j) = level * random.normal();
  }
  const MatrixXd gram = errors * errors.transpose();
  return gram + ridge * gram.diagonal().maxCoeff() * MatrixXd::Identity(size, size);
}

double cost(const MatrixXd& a, const VectorXd& b, const VectorXd& w) {
  return 0.5 * w.dot(a * w) - b.dot(w);
}

/// The lowest cost over all 2^K - 1 faces of the simplex, each by its own linear system.
double lowest_cost_of_all_faces(const MatrixXd& a, const VectorXd& b) {
  double lowest = std::numeric_limits<double>::infinity();
  for (unsigned face = 1; face < (1U << b.size()); ++face) {
    std::vector<Index> some;
    for (Index i = 0; i < b.size(); ++i) {
      if ((face >> i) & 1U) some.push_back(i);
    }
    const auto n = static_cast<Index>(some.size());
    MatrixXd system = MatrixXd::Zero(n + 1, n + 1);
    system.topLeftCorner(n, n) = a(some, some);
    system.topRightCorner(n, 1).setOnes();
    system.bottomLeftCorner(1, n).setOnes();
    VectorXd right(n + 1);
    right << VectorXd(b(some)), 1.0;
    const VectorXd solution = system.fullPivLu().solve(right);
    if (solution.head(n).minCoeff() < 0) continue;
    VectorXd w = VectorXd::Zero(b.size());
    w(some) = solution.head(n);
    lowest = std::min(lowest, cost(a, b, w));
  }
  return lowest;
}

TEST(MinimiseOnSimplex, FindsTheLowestOfAllFaces) {
  Rng random(1, "faces");
  for (int round = 0; round < 300; ++round) {
    const Index size = 1 + round % 7;
    const MatrixXd a = random_form(size, 1 + round % 5, 1e-6, random);
    VectorXd b = VectorXd::Zero(size);
    if (round % 2 == 0) {
      for (Index i = 0; i < size; ++i) b[i] = a(i, i) * random.normal();
    }
    const VectorXd w = minimise_on_simplex(a, b);
    const double lowest = lowest_cost_of_all_faces(a, b);
    // Rounding of the enumeration: 1e-16 times its condition of 1e6.
    EXPECT_LE(cost(a, b, w), lowest + 1e-9 * a.maxCoeff()) << "round " << round;
    EXPECT_NEAR(w.sum(), 1.0, 1e-14);
    EXPECT_GE(w.minCoeff(), 0.0);
  }
}

TEST(MinimiseOnSimplex, SatisfiesTheConditionsOfKarushKuhnAndTucker) {
  Rng random(2, "kkt");
  for (int round = 0; round < 2000; ++round) {
    const Index size = 2 + round % 9;
    const MatrixXd a = random_form(size, 1 + round % 12, 1e-7, random);
    const VectorXd b = VectorXd::Zero(size);
    const VectorXd w = minimise_on_simplex(a, b);
    const VectorXd slope = a * w - b;
    const double level = w.dot(slope);  // the multiplier of sum w = 1
    for (Index i = 0; i < size; ++i) {
      const double tolerance = 1e-9 * a.maxCoeff();
      if (w[i] > 0) {
        EXPECT_NEAR(slope[i], level, tolerance) << "round " << round;
      } else {
        EXPECT_GE(slope[i], level - tolerance) << "round " << round;
      }
    }
  }
}

TEST(MinimiseOnSimplex, IndependentErrorsAreWeighedByTheirInverseVariance) {
  MatrixXd a = MatrixXd::Zero(3, 3);
  a.diagonal() << 1.0, 2.0, 4.0;
  const VectorXd w = minimise_on_simplex(a, VectorXd::Zero(3));
  EXPECT_NEAR(w[0], 4.0 / 7.0, 1e-14);
  EXPECT_NEAR(w[1], 2.0 / 7.0, 1e-14);
  EXPECT_NEAR(w[2], 1.0 / 7.0, 1e-14);
}

TEST(MinimiseOnSimplex, OneShareIsOne) {
  EXPECT_EQ(minimise_on_simplex(MatrixXd::Constant(1, 1, 5.0), VectorXd::Constant(1, -3.0))[0],
            1.0);
}

TEST(MinimiseOnSimplex, RefusesWhatIsNoConvexForm) {
  EXPECT_THROW((void)minimise_on_simplex(-MatrixXd::Identity(2, 2), VectorXd::Zero(2)),
               ContractViolation);
  EXPECT_THROW((void)minimise_on_simplex(MatrixXd::Identity(2, 2), VectorXd::Zero(3)),
               ContractViolation);
  EXPECT_THROW((void)minimise_on_simplex(MatrixXd::Constant(2, 2, NAN), VectorXd::Zero(2)),
               ContractViolation);
}

}  // namespace
}  // namespace slackwater::calibration::simplex_quadratic_test

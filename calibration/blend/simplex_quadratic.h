#pragma once
#include <Eigen/Core>

namespace slackwater::calibration {

/// The shares that minimise a convex quadratic form over the simplex:
///
///   argmin  1/2 w^T A w - b^T w   with  w >= 0,  sum w = 1
///
/// Primal active set: the equality-constrained minimum of the free shares is exact (one Cholesky
/// factorisation); a share that would turn negative is fixed at 0, one whose multiplier is negative
/// is freed. Each step lowers the cost, so no set comes back and the end is exact up to rounding.
///
/// @param a  symmetric, positive definite (the caller adds the ridge that makes it so), K x K,
///           K >= 1
/// @param b  K
/// @return K shares; those of the bound are exactly 0.
/// Throws ContractViolation for unlike sizes, values that are not finite, or an A that is not
/// positive definite.  Cost: some K^4 for K shares, 10 us for K = 8.  Thread-safe.
/// Source: Nocedal & Wright (2006), Numerical Optimization, section 16.5.
[[nodiscard]] Eigen::VectorXd minimise_on_simplex(const Eigen::MatrixXd& a,
                                                  const Eigen::VectorXd& b);

}  // namespace slackwater::calibration

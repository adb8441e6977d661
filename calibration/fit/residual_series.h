#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

namespace slackwater::calibration {

/// What a residual is of: one quantity in one row of a table, whose rows come in the order of time.
struct ResidualPlace {
  std::size_t series = 0;  ///< the quantity, from 0
  std::size_t row = 0;
};

/// How much residuals that follow on one another repeat themselves: n of them are worth n divided
/// by this,
///
///   n / n_eff = 1 + 2 sum_l rho_l,
///
/// with rho_l their correlation at a lag of l, about zero and not about their mean, so that a bias
/// counts as memory. Summed up to the first lag that lies within two standard errors of none,
/// 2/sqrt(n) (Bartlett 1946), so that white noise keeps its full number, and to half of them at
/// most; beyond that they fall on geometrically. Of first-order autoregressive noise it is
/// (1 + c)/(1 - c). Needs about even steps in time.
/// Source: Bayley and Hammersley, The "effective" number of independent observations in an
/// autocorrelated time series, Suppl. J. R. Stat. Soc. 8 (1946).
/// @return from 1 to n; 1 for residuals that are all 0. Cost: n times the lags.
[[nodiscard]] double repeats_itself(std::span<const double> residuals);

/// What the residuals of a fit tell of their own errors, series by series.
struct ResidualErrors {
  double effective = 0;       ///< how many independent ones they are worth together
  Eigen::MatrixXd variance;   ///< series by series: of errors in one row, as if none had memory
  std::vector<double> times;  ///< by series: how much memory makes the variance of a sum greater
};
/// @param place  of each residual; rows of a series rising, no place twice
[[nodiscard]] ResidualErrors errors_in(std::span<const double> residuals,
                                       std::span<const ResidualPlace> place);

/// J^T V J with V the covariance of residuals that errors of these kinds have: of two series k and
/// l in one row sqrt(t_k t_l) times their covariance, and none between rows, which t stands for.
/// Exact where a parameter moves residuals slowly against their memory, else too large.
/// @param jacobian  a row for each residual
[[nodiscard]] Eigen::MatrixXd spread_of_gradient(const Eigen::MatrixXd& jacobian,
                                                 std::span<const ResidualPlace> place,
                                                 const ResidualErrors& errors);

}  // namespace slackwater::calibration

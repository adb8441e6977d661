#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibration/propagate/memory_kernel.h"

namespace slackwater::calibration {

/// What levels that have values in the same cells, with the same errors, say of other times:
/// Gaussian process regression (Rasmussen and Williams 2006, Gaussian Processes for Machine
/// Learning, ch. 2, algorithm 2.1) of complex numbers. Matrices are cells or times x levels.
///
/// With y the values of a level, S its answer to the wind there and S_* later, K the covariance of
/// the values but for the own share, k_* that of later times with them, k_** that of later times:
///
///   mean = k_* K^-1 (y - g S) + g S_*,       g = b^2 S^H K^-1 y / e,   e = 1 + b^2 S^H K^-1 S
///   cov  = k_** + n^2 - k_* K^-1 k_*^H + x x^H b^2 / e,                x = S_* - k_* K^-1 S
///
/// The own share b is a rank-one update, so that the levels share one Cholesky factor. `cov` is
/// that of a value as the product would give it, the kernel's noise n included.
class LevelRegression {
 public:
  struct Values {
    std::vector<HourCell> cell;
    Eigen::VectorXd error_m2_s2;  ///< per cell: stated variance of the vector
    Eigen::MatrixXcd value_m_s;
    Eigen::MatrixXcd wind_answer_m_s;
  };
  struct Posterior {
    Eigen::MatrixXcd mean;           ///< times x levels
    Eigen::MatrixXd variance;        ///< of the vector, times x levels
    Eigen::MatrixXcd half;           ///< L^-1 k_*^H, K = L L^H, cells x times
    Eigen::MatrixXcd share_missing;  ///< x, times x levels
  };

  /// No cells: the prior is left.
  LevelRegression(const MemoryKernel& kernel, const MemoryCovariance& covariance, Values values);

  [[nodiscard]] Posterior at(std::span<const HourCell> times,
                             const Eigen::MatrixXcd& wind_answer_later) const;
  /// F with F F^H = k_** + n^2 - k_* K^-1 k_*^H: `cov` without its last term.
  [[nodiscard]] Eigen::MatrixXcd departure_factor(std::span<const HourCell> times,
                                                  const Posterior& posterior) const;
  /// Standard deviation of the own share of a level, as a complex number: sqrt(b^2/e).
  [[nodiscard]] double share_sigma(Eigen::Index level) const { return share_sigma_(level); }
  /// y^H (K + b^2 S S^H)^-1 y, summed over the levels: as many as there are values, if all is as
  /// believed.
  [[nodiscard]] double chi_squared() const noexcept { return chi_squared_; }
  /// log p(y), summed over the levels; natural logarithm.
  [[nodiscard]] double log_evidence() const noexcept { return log_evidence_; }

 private:
  MemoryCovariance covariance_;
  double noise_m2_s2_;
  std::vector<HourCell> cell_;
  Eigen::MatrixXcd factor_;         ///< L
  Eigen::MatrixXcd weights_;        ///< K^-1 (y - g S)
  Eigen::MatrixXcd share_weights_;  ///< K^-1 S
  Eigen::VectorXcd share_;          ///< g
  Eigen::VectorXd share_sigma_;
  double chi_squared_ = 0;
  double log_evidence_ = 0;
};

}  // namespace slackwater::calibration

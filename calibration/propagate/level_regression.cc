#include "calibration/propagate/level_regression.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

MatrixXcd cholesky_factor(const MatrixXcd& covariance) {
  if (covariance.size() == 0) return covariance;
  const Eigen::LLT<MatrixXcd> cholesky(covariance);
  expects(cholesky.info() == Eigen::Success, "a finite covariance with noise has a factor");
  return cholesky.matrixL();
}

/// L^-1 right.
MatrixXcd whitened(const MatrixXcd& factor, MatrixXcd right) {
  factor.triangularView<Eigen::Lower>().solveInPlace(right);
  return right;
}

/// L^-H right.
MatrixXcd unwhitened(const MatrixXcd& factor, MatrixXcd right) {
  factor.adjoint().triangularView<Eigen::Upper>().solveInPlace(right);
  return right;
}

}  // namespace

LevelRegression::LevelRegression(const MemoryKernel& kernel, const MemoryCovariance& covariance,
                                 Values values)
    : covariance_(covariance),
      noise_m2_s2_(kernel.noise_m_s * kernel.noise_m_s),
      cell_(std::move(values.cell)) {
  MatrixXcd of_values = covariance_.between(cell_, cell_);
  of_values.diagonal().array() += noise_m2_s2_;
  of_values.diagonal() += values.error_m2_s2;
  factor_ = cholesky_factor(of_values);
  MatrixXcd y = whitened(factor_, std::move(values.value_m_s));
  const MatrixXcd s = whitened(factor_, std::move(values.wind_answer_m_s));

  const double b2 = kernel.own_share * kernel.own_share;
  const double log_normal = 2.0 * factor_.diagonal().real().array().log().sum() +
                            static_cast<double>(cell_.size()) * std::log(constants::pi);
  share_.resize(y.cols());
  share_sigma_.resize(y.cols());
  for (Index k = 0; k < y.cols(); ++k) {
    const double e = 1.0 + b2 * s.col(k).squaredNorm();
    const Horizontal overlap = s.col(k).dot(y.col(k));  // S^H K^-1 y
    share_(k) = b2 * overlap / e;
    share_sigma_(k) = std::sqrt(b2 / e);
    chi_squared_ += y.col(k).squaredNorm() - b2 * std::norm(overlap) / e;
    log_evidence_ -= std::log(e) + log_normal;
    y.col(k) -= share_(k) * s.col(k);
  }
  log_evidence_ -= chi_squared_;
  weights_ = unwhitened(factor_, std::move(y));
  share_weights_ = unwhitened(factor_, s);
}

LevelRegression::Posterior LevelRegression::at(std::span<const HourCell> times,
                                               const MatrixXcd& wind_answer_later) const {
  const MatrixXcd later = covariance_.between(times, cell_);
  Posterior out;
  out.mean = wind_answer_later * share_.asDiagonal();
  out.mean.noalias() += later * weights_;
  out.share_missing = wind_answer_later;
  out.share_missing.noalias() -= later * share_weights_;
  out.half = whitened(factor_, later.adjoint());
  const Eigen::ArrayXd known = out.half.colwise().squaredNorm().transpose();
  out.variance = out.share_missing.cwiseAbs2() * share_sigma_.cwiseAbs2().asDiagonal();
  // Rounding must not make a value surer than its noise.
  out.variance.colwise() +=
      ((covariance_.variance_m2_s2() - known).max(0.0) + noise_m2_s2_).matrix();
  return out;
}

MatrixXcd LevelRegression::departure_factor(std::span<const HourCell> times,
                                            const Posterior& posterior) const {
  MatrixXcd covariance = covariance_.between(times, times);
  covariance.noalias() -= posterior.half.adjoint() * posterior.half;
  covariance.diagonal().array() += noise_m2_s2_;
  return cholesky_factor(covariance);
}

}  // namespace slackwater::calibration

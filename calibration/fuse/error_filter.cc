#include "calibration/fuse/error_filter.h"

#include <Eigen/Cholesky>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::calibration {

ErrorFilter::ErrorFilter(const std::vector<double>& depths_m, Kind slow, Kind quick,
                         double length_m, double noise_m2_s2)
    : n_(static_cast<Eigen::Index>(depths_m.size())),
      slow_(slow),
      quick_(quick),
      noise_(noise_m2_s2),
      shape_(n_, n_),
      state_(Eigen::VectorXcd::Zero(2 * n_)),
      covariance_(Eigen::MatrixXd::Zero(2 * n_, 2 * n_)) {
  expects(n_ > 0 && length_m > 0 && noise_m2_s2 > 0, "depths, a length and a noise");
  for (Eigen::Index i = 0; i < n_; ++i) {
    for (Eigen::Index j = 0; j < n_; ++j) {
      const double apart_m =
          depths_m[static_cast<std::size_t>(i)] - depths_m[static_cast<std::size_t>(j)];
      shape_(i, j) = std::exp(-std::abs(apart_m) / length_m);
    }
  }
  covariance_.topLeftCorner(n_, n_) = slow_.variance_m2_s2 * shape_;
  covariance_.bottomRightCorner(n_, n_) = quick_.variance_m2_s2 * shape_;
}

void ErrorFilter::forget(double hours) {
  const double a = std::exp(-hours / slow_.memory_h);
  const double b = std::exp(-hours / quick_.memory_h);
  state_.head(n_) *= a;
  state_.tail(n_) *= b;
  covariance_.topLeftCorner(n_, n_) *= a * a;
  covariance_.topRightCorner(n_, n_) *= a * b;
  covariance_.bottomLeftCorner(n_, n_) *= a * b;
  covariance_.bottomRightCorner(n_, n_) *= b * b;
  covariance_.topLeftCorner(n_, n_) += (1 - a * a) * slow_.variance_m2_s2 * shape_;
  covariance_.bottomRightCorner(n_, n_) += (1 - b * b) * quick_.variance_m2_s2 * shape_;
}

void ErrorFilter::observe(const Eigen::MatrixXd& h, const Eigen::VectorXcd& y) {
  if (y.size() == 0) return;
  const Eigen::MatrixXd top = covariance_.leftCols(n_) * h.transpose();
  const Eigen::MatrixXd bottom = covariance_.rightCols(n_) * h.transpose();
  const Eigen::MatrixXd cross = top + bottom;  // Cov(state, y)
  Eigen::MatrixXd spread = h * (cross.topRows(n_) + cross.bottomRows(n_));
  spread.diagonal().array() += noise_;
  const Eigen::LLT<Eigen::MatrixXd> factor(spread);
  const Eigen::VectorXcd innovation = y - h * (state_.head(n_) + state_.tail(n_));
  const Eigen::MatrixXd gain = factor.solve(cross.transpose()).transpose();
  state_ += gain * innovation;
  covariance_ -= gain * cross.transpose();
  // Rounding must not make it lean.
  const Eigen::MatrixXd turned = covariance_.transpose();
  covariance_ = 0.5 * (covariance_ + turned);
}

Eigen::VectorXcd ErrorFilter::mean() const { return state_.head(n_) + state_.tail(n_); }

Eigen::VectorXd ErrorFilter::variance() const {
  return covariance_.topLeftCorner(n_, n_).diagonal() +
         covariance_.bottomRightCorner(n_, n_).diagonal() +
         2 * covariance_.topRightCorner(n_, n_).diagonal();
}

}  // namespace slackwater::calibration

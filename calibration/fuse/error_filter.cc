#include "calibration/fuse/error_filter.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <utility>

#include "fields/base/check.h"

namespace slackwater::calibration {

ErrorFilter::ErrorFilter(const std::vector<double>& depths_m, Kind slow, Kind quick,
                         double length_m)
    : n_(static_cast<Eigen::Index>(depths_m.size())),
      slow_(slow),
      quick_(quick),
      shape_(n_, n_),
      state_(Eigen::VectorXcd::Zero(2 * n_)),
      covariance_(Eigen::MatrixXd::Zero(2 * n_, 2 * n_)) {
  expects(n_ > 0 && length_m > 0, "depths and a length");
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
  state_.head(n_) *= std::exp(-hours / slow_.memory_h);
  state_.tail(n_) *= std::exp(-hours / quick_.memory_h);
  pending_h_ += hours;
}

void ErrorFilter::spread_for(double hours) {
  const double a = std::exp(-hours / slow_.memory_h);
  const double b = std::exp(-hours / quick_.memory_h);
  covariance_.topLeftCorner(n_, n_) *= a * a;
  covariance_.topRightCorner(n_, n_) *= a * b;
  covariance_.bottomLeftCorner(n_, n_) *= a * b;
  covariance_.bottomRightCorner(n_, n_) *= b * b;
  covariance_.topLeftCorner(n_, n_) += (1 - a * a) * slow_.variance_m2_s2 * shape_;
  covariance_.bottomRightCorner(n_, n_) += (1 - b * b) * quick_.variance_m2_s2 * shape_;
}

void ErrorFilter::take_in(const Step& step) {
  const Eigen::MatrixXd& h = step.h;
  const Eigen::MatrixXd both = covariance_.leftCols(n_) + covariance_.rightCols(n_);
  const Eigen::MatrixXd cross = both * h.transpose();  // Cov(state, y)
  Eigen::MatrixXd spread = h * (cross.topRows(n_) + cross.bottomRows(n_));
  spread.diagonal() += step.noise_m2_s2;
  const Eigen::LLT<Eigen::MatrixXd> factor(spread);
  gain_ = factor.solve(cross.transpose()).transpose();
  covariance_ -= gain_ * cross.transpose();
  // Rounding must not make it lean.
  const Eigen::MatrixXd turned = covariance_.transpose();
  covariance_ = 0.5 * (covariance_ + turned);
}

void ErrorFilter::observe(const Eigen::MatrixXd& h, const Eigen::VectorXcd& y,
                          const Eigen::VectorXd& noise_m2_s2) {
  if (y.size() == 0) return;
  expects(noise_m2_s2.size() == y.size() && (noise_m2_s2.array() > 0).all(),
          "a noise for each observation");
  Step step{pending_h_, h, noise_m2_s2};
  const bool repeated = step == last_;
  if (!repeated || !settled_) {
    const Eigen::MatrixXd before = covariance_;
    spread_for(pending_h_);
    take_in(step);
    const double total = slow_.variance_m2_s2 + quick_.variance_m2_s2;
    settled_ = repeated && (covariance_ - before).cwiseAbs().maxCoeff() < 1e-9 * total;
    last_ = std::move(step);
  }
  pending_h_ = 0;
  const Eigen::VectorXcd innovation = y - h * (state_.head(n_) + state_.tail(n_));
  state_ += gain_ * innovation;
}

Eigen::VectorXcd ErrorFilter::mean() const { return state_.head(n_) + state_.tail(n_); }

Eigen::VectorXd ErrorFilter::fresh_noise() const {
  if (gain_.size() == 0) return Eigen::VectorXd::Zero(n_);
  return (gain_.topRows(n_) + gain_.bottomRows(n_)).cwiseAbs2() * last_.noise_m2_s2;
}

Eigen::VectorXd ErrorFilter::variance() const {
  if (pending_h_ > 0) {
    ErrorFilter later = *this;
    later.spread_for(pending_h_);
    later.pending_h_ = 0;
    return later.variance();
  }
  return covariance_.topLeftCorner(n_, n_).diagonal() +
         covariance_.bottomRightCorner(n_, n_).diagonal() +
         2 * covariance_.topRightCorner(n_, n_).diagonal();
}

}  // namespace slackwater::calibration

#include "calibration/provider/run_error.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "calibration/propagate/memory_kernel.h"
#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// Principal semidiurnal and diurnal lines, rad per hour (Doodson).
constexpr double m2_rad_h = 2 * std::numbers::pi / 12.4206012;
constexpr double k1_rad_h = 2 * std::numbers::pi / 23.9344696;

bool is_finite(Horizontal value) {
  return std::isfinite(value.real()) && std::isfinite(value.imag());
}

Index signed_index(std::size_t i) { return static_cast<Index>(i); }

}  // namespace

RunError::RunError(std::vector<double> depth_m, std::vector<RunMoment> seen, MatrixXcd error,
                   double coriolis_rad_h, const RunErrorKernel& kernel)
    : kernel_(kernel), coriolis_rad_h_(coriolis_rad_h) {
  expects(error.rows() == signed_index(seen.size()) && error.cols() == signed_index(depth_m.size()),
          "one error for each moment and level");
  expects(!kernel.sizes_m_s.empty(), "an error has a size");
  const MemoryKernel fading;
  for (const double depth : depth_m) amplitude_.push_back(fading.amplitude_at(depth));
  for (const double shared : kernel.sizes_m_s)
    for (const double gathered : kernel.sizes_m_s) sizes_.push_back({shared, gathered});

  std::map<std::vector<bool>, std::vector<std::size_t>> by_what_is_seen;
  std::size_t witnesses = 0;
  for (std::size_t k = 0; k < depth_m.size(); ++k) {
    std::vector<bool> is_seen;
    for (std::size_t i = 0; i < seen.size(); ++i)
      is_seen.push_back(is_finite(error(signed_index(i), signed_index(k))));
    witnesses += std::count(is_seen.begin(), is_seen.end(), true) > 0 ? 1 : 0;
    by_what_is_seen[is_seen].push_back(k);
  }
  std::vector<double> log_evidence(sizes_.size());
  for (const auto& [is_seen, levels] : by_what_is_seen) {
    Group group{levels, {}, {}, {}};
    std::vector<Index> rows;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!is_seen[i]) continue;
      rows.push_back(signed_index(i));
      group.seen.push_back(seen[i]);
    }
    MatrixXcd values(rows.size(), levels.size());
    for (std::size_t j = 0; j < levels.size(); ++j) {
      for (std::size_t i = 0; i < rows.size(); ++i) {
        values(signed_index(i), signed_index(j)) =
            error(rows[i], signed_index(levels[j])) / amplitude_[levels[j]];
      }
    }
    regress(group, values, log_evidence);
    groups_.push_back(std::move(group));
  }
  const double share = std::min(
      1.0, kernel.independent_levels / static_cast<double>(std::max<std::size_t>(1, witnesses)));
  const double best = *std::max_element(log_evidence.begin(), log_evidence.end());
  double sum = 0;
  for (const double evidence : log_evidence) {
    belief_.push_back(std::exp(share * (evidence - best)));
    sum += belief_.back();
  }
  for (double& belief : belief_) belief = belief / sum < 1e-3 ? 0.0 : belief / sum;
}

Horizontal RunError::covariance(const RunMoment& a, const RunMoment& b, const Size& size) const {
  const double lag = a.hour - b.hour;
  const double apart = std::abs(lag);
  const double lasting = std::exp(-apart / kernel_.shared_h);
  const Horizontal inertial =
      std::exp(-apart / kernel_.inertial_decay_h) * std::polar(1.0, -coriolis_rad_h_ * lag);
  const double tidal = std::cos(m2_rad_h * lag) + std::cos(k1_rad_h * lag);
  Horizontal sum =
      size.shared * size.shared * (0.6 * lasting + 0.2 * inertial + 0.1 * tidal * lasting);
  if (a.run == b.run) {
    sum += size.gathered * size.gathered *
           (std::exp(-apart / kernel_.gathering_h) -
            std::exp(-(a.lead_h + b.lead_h) / kernel_.gathering_h));
  }
  return sum;
}

MatrixXcd RunError::covariance(std::span<const RunMoment> a, std::span<const RunMoment> b,
                               const Size& size) const {
  MatrixXcd matrix(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j)
      matrix(signed_index(i), signed_index(j)) = covariance(a[i], b[j], size);
  return matrix;
}

void RunError::regress(Group& group, const MatrixXcd& error, std::vector<double>& log_evidence) {
  if (group.seen.empty()) return;
  for (std::size_t s = 0; s < sizes_.size(); ++s) {
    MatrixXcd k = covariance(group.seen, group.seen, sizes_[s]);
    k.diagonal().array() += kernel_.noise_m_s * kernel_.noise_m_s;
    const Eigen::LLT<MatrixXcd> cholesky(k);
    const MatrixXcd factor = cholesky.matrixL();
    const MatrixXcd white = cholesky.matrixL().solve(error);
    const double log_determinant = 2.0 * factor.diagonal().real().array().log().sum();
    log_evidence[s] -= white.squaredNorm() + static_cast<double>(error.cols()) * log_determinant;
    group.weights.push_back(cholesky.matrixU().solve(white));
    group.factor.push_back(factor);
  }
}

RunError::Expected RunError::at(std::span<const RunMoment> moments) const {
  Expected expected;
  expected.error_m_s = MatrixXcd::Zero(moments.size(), amplitude_.size());
  expected.variance_m2_s2 = MatrixXd::Zero(moments.size(), amplitude_.size());
  for (const Group& group : groups_) {
    const auto count = signed_index(group.levels.size());
    MatrixXcd mean = MatrixXcd::Zero(moments.size(), count);
    MatrixXd square = MatrixXd::Zero(moments.size(), count);
    for (std::size_t s = 0; s < sizes_.size(); ++s) {
      if (belief_[s] <= 0) continue;
      Eigen::VectorXd own(moments.size());
      for (std::size_t i = 0; i < moments.size(); ++i)
        own[signed_index(i)] = covariance(moments[i], moments[i], sizes_[s]).real() +
                               kernel_.noise_m_s * kernel_.noise_m_s;
      MatrixXcd one = MatrixXcd::Zero(moments.size(), count);
      if (!group.seen.empty()) {
        const MatrixXcd across = covariance(moments, group.seen, sizes_[s]);
        one = across * group.weights[s];
        const MatrixXcd half =
            group.factor[s].triangularView<Eigen::Lower>().solve(across.adjoint());
        own -= half.colwise().squaredNorm().transpose();
      }
      mean += belief_[s] * one;
      for (Index k = 0; k < count; ++k)
        square.col(k) += belief_[s] * (own.cwiseMax(0.0) + one.col(k).cwiseAbs2());
    }
    for (Index k = 0; k < count; ++k) {
      const std::size_t level = group.levels[static_cast<std::size_t>(k)];
      const double a = amplitude_[level];
      expected.error_m_s.col(signed_index(level)) = a * mean.col(k);
      expected.variance_m2_s2.col(signed_index(level)) =
          0.5 * a * a * (square.col(k) - mean.col(k).cwiseAbs2()).cwiseMax(0.0);
    }
  }
  return expected;
}

}  // namespace slackwater::calibration

#include "calibration/solve/normal_equations.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

constexpr double huber_threshold = 2.0;
constexpr Eigen::Index block_rows = 256;  ///< of derivatives, weighted while they are in the cache

/// Twice the cost of one pair: Huber's rho(s), or s.
double loss_of(double squared_residual, Loss loss) {
  if (loss == Loss::plain || squared_residual <= huber_threshold * huber_threshold)
    return squared_residual;
  return 2.0 * huber_threshold * std::sqrt(squared_residual) - huber_threshold * huber_threshold;
}

/// rho'(s)
double slope_of(double squared_residual, Loss loss) {
  if (loss == Loss::plain || squared_residual <= huber_threshold * huber_threshold) return 1.0;
  return huber_threshold / std::sqrt(squared_residual);
}

}  // namespace

DayMisfit::DayMisfit(const ColumnDay& day, const std::vector<Pair>& pairs)
    : points_{Point{ColumnRows(day), {}, false}, Point{ColumnRows(day), {}, false}} {
  const auto levels = static_cast<Eigen::Index>(day.depth_m.size());
  const auto cells = static_cast<Eigen::Index>(day.time.size()) * levels;
  observed_.setZero(2 * cells);
  has_pair_.setZero(cells);
  sharpness_.setOnes(cells);
  for (const Pair& pair : pairs) {
    const Eigen::Index at =
        static_cast<Eigen::Index>(pair.time) * levels + static_cast<Eigen::Index>(pair.level);
    observed_(at) = pair.observed_m_s.real();
    observed_(cells + at) = pair.observed_m_s.imag();
    has_pair_(at) = 1.0;
    sharpness_(at) = 1.0 / pair.relative_sigma;
  }
  root_.resize(2 * cells);
}

const ColumnRows& DayMisfit::at(const std::vector<double>& estimate, bool with_derivatives) {
  if (points_.front().estimate != estimate) std::swap(points_.front(), points_.back());
  Point& point = points_.front();
  const bool is_there = point.estimate == estimate;
  if (is_there && (point.has_derivatives || !with_derivatives)) return point.rows;
  point.rows.evaluate(estimate.data(), with_derivatives);
  point.estimate = estimate;
  point.has_derivatives = with_derivatives;
  return point.rows;
}

double DayMisfit::weigh(const PairWeighing& weighing) {
  const Eigen::Index cells = has_pair_.size();
  double sum = 0;
  for (Eigen::Index i = 0; i < cells; ++i) {
    const double whitening = sharpness_(i) / weighing.sigma_m_s;
    const double east = whitening * miss_(i);
    const double north = whitening * miss_(cells + i);
    const double square = east * east + north * north;
    sum += has_pair_(i) * loss_of(square, weighing.loss);
    root_(i) =
        has_pair_(i) * whitening * std::sqrt(weighing.weight * slope_of(square, weighing.loss));
  }
  root_.tail(cells) = root_.head(cells);
  return 0.5 * weighing.weight * sum;
}

const NormalEquations& DayMisfit::normal_equations(const std::vector<double>& estimate,
                                                   const PairWeighing& weighing) {
  const ColumnRows& rows = at(estimate, true);
  miss_ = rows.stacked_model().array() - observed_;
  equations_.cost = weigh(weighing);
  const Eigen::MatrixXd& derivatives = rows.stacked_derivatives();
  const Eigen::Index count = derivatives.cols();
  equations_.gradient.setZero(count);
  equations_.information.setZero(count, count);
  auto half = equations_.information.selfadjointView<Eigen::Lower>();
  for (Eigen::Index from = 0; from < miss_.size(); from += block_rows) {
    const Eigen::Index n = std::min(block_rows, miss_.size() - from);
    const auto root = root_.segment(from, n).matrix();
    weighted_.noalias() = root.asDiagonal() * derivatives.middleRows(from, n);
    equations_.gradient.noalias() +=
        weighted_.transpose() * miss_.segment(from, n).matrix().cwiseProduct(root);
    half.rankUpdate(weighted_.transpose());
  }
  equations_.information.triangularView<Eigen::StrictlyUpper>() =
      equations_.information.transpose();
  return equations_;
}

}  // namespace slackwater::calibration

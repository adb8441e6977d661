#include "calibration/fit/fit_parameters.h"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

using Values = std::vector<double>;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What a parameter is counted in, so that all are of about one size.
double unit_of(const FreeParameter& p) {
  return p.start != 0 ? std::abs(p.start) : 0.5 * (p.high - p.low);
}

/// The black box, and its slopes.
class Box {
 public:
  Box(const std::vector<FreeParameter>& parameters, std::size_t residuals,
      const ResidualsOf& residuals_of, int threads)
      : parameters_(parameters), count_(residuals), of_(residuals_of), threads_(threads) {}

  [[nodiscard]] std::size_t parameters() const { return parameters_.size(); }
  [[nodiscard]] std::size_t residuals() const { return count_; }
  /// At parameters in their units. A rounding beyond a bound is on it.
  [[nodiscard]] Values physical(const double* scaled) const {
    Values out(parameters_.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] =
          std::clamp(scaled[i] * unit_of(parameters_[i]), parameters_[i].low, parameters_[i].high);
    return out;
  }
  [[nodiscard]] bool evaluate(const Values& at, double* residuals) const {
    return of_(at, std::span(residuals, count_));
  }
  /// Slopes per unit of each parameter; one-sided where a bound, or what cannot be computed, is in
  /// the way. @param here  the residuals there
  [[nodiscard]] bool slopes(const Values& at, const double* here,
                            Eigen::Ref<RowMajor> jacobian) const {
    std::atomic<bool> is_computable = true;
    std::vector<Values> columns(parameters_.size());
    for_all(parameters_.size(), threads_, [&](std::size_t i) {
      const FreeParameter& p = parameters_[i];
      const double h = difference * std::max(std::abs(at[i]), 0.1 * unit_of(p));
      Values above = at, below = at;
      above[i] = std::min(at[i] + h, p.high);
      below[i] = std::max(at[i] - h, p.low);
      Values &higher = columns[i], lower(count_);
      higher.resize(count_);
      const auto stay = [&](Values& away, Values& residuals) {
        away = at;
        std::copy(here, here + count_, residuals.begin());
      };
      if (!evaluate(above, higher.data())) stay(above, higher);
      if (!evaluate(below, lower.data())) stay(below, lower);
      const double across = (above[i] - below[i]) / unit_of(p);
      if (!(across > 0)) {
        is_computable = false;
        return;
      }
      for (std::size_t k = 0; k < count_; ++k) higher[k] = (higher[k] - lower[k]) / across;
    });
    if (!is_computable) return false;
    for (std::size_t i = 0; i < columns.size(); ++i)
      jacobian.col(static_cast<Eigen::Index>(i)) = Eigen::Map<Eigen::VectorXd>(
          columns[i].data(), static_cast<Eigen::Index>(columns[i].size()));
    return true;
  }

 private:
  static constexpr double difference = 1e-5;
  const std::vector<FreeParameter>& parameters_;
  std::size_t count_;
  const ResidualsOf& of_;
  int threads_;
};

class BoxCost final : public ceres::CostFunction {
 public:
  explicit BoxCost(const Box& box) : box_(box) {
    set_num_residuals(static_cast<int>(box.residuals()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(box.parameters()));
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    const Values at = box_.physical(parameters[0]);
    if (!box_.evaluate(at, residuals)) return false;
    if (jacobians == nullptr || jacobians[0] == nullptr) return true;
    return box_.slopes(at, residuals,
                       Eigen::Map<RowMajor>(jacobians[0], num_residuals(),
                                            static_cast<Eigen::Index>(box_.parameters())));
  }

 private:
  const Box& box_;
};

ceres::Solver::Options search_options(const FitOptions& fit) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = fit.most_steps;
  options.max_num_consecutive_invalid_steps = 20;
  options.function_tolerance = 1e-8;
  options.parameter_tolerance = 1e-9;
  options.gradient_tolerance = 1e-14;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

std::string end_of(const ceres::Solver::Summary& summary) {
  const std::string steps = counted(summary.iterations.size(), "step");
  if (summary.termination_type == ceres::CONVERGENCE)
    return "converged after " + steps + ": the misfit no longer falls";
  return "stopped after " + steps + " before the misfit stopped falling: give it better starts";
}

/// Where a search came to.
struct Minimum {
  Values value;
  double rms = 0;
  bool has_converged = false;
  std::string ended;
};

double root_mean_square(const Values& values) {
  double squares = 0;
  for (const double value : values) squares += value * value;
  return values.empty() ? 0 : std::sqrt(squares / static_cast<double>(values.size()));
}

/// Of all residuals there; nothing: they cannot be computed.
std::optional<double> misfit_at(const Box& box, const Values& at) {
  Values residuals(box.residuals());
  if (!box.evaluate(at, residuals.data())) return std::nullopt;
  return root_mean_square(residuals);
}

/// A better place to begin: each parameter in turn at seven values from bound to bound, evenly by
/// factors where they have one sign.
Values looked_round(const Box& box, const std::vector<FreeParameter>& parameters,
                    const Values& start, double misfit) {
  constexpr int looks = 7;
  constexpr double clearly = 0.99;
  Values best = start;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const FreeParameter& p = parameters[i];
    Values at = best;
    for (int k = 0; k < looks; ++k) {
      const double share = static_cast<double>(k) / (looks - 1);
      at[i] = p.low * p.high > 0 ? p.low * std::pow(p.high / p.low, share)
                                 : p.low + share * (p.high - p.low);
      at[i] = std::clamp(at[i], p.low, p.high);
      const auto there = misfit_at(box, at);
      if (!there || !(*there < clearly * misfit)) continue;
      misfit = *there;
      best = at;
    }
  }
  return best;
}

/// Downhill from a start. Nothing: it came to where the residuals or slopes cannot be computed.
std::optional<Minimum> minimum_from(const Box& box, const std::vector<FreeParameter>& parameters,
                                    const Values& start, const FitOptions& options) {
  Values scaled(start.size());
  for (std::size_t i = 0; i < scaled.size(); ++i) scaled[i] = start[i] / unit_of(parameters[i]);
  BoxCost cost(box);
  ceres::Problem::Options owned;
  owned.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(owned);
  problem.AddResidualBlock(&cost, nullptr, scaled.data());
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    const double unit = unit_of(parameters[i]);
    problem.SetParameterLowerBound(scaled.data(), static_cast<int>(i), parameters[i].low / unit);
    problem.SetParameterUpperBound(scaled.data(), static_cast<int>(i), parameters[i].high / unit);
  }
  ceres::Solver::Summary summary;
  ceres::Solve(search_options(options), &problem, &summary);
  Minimum found{box.physical(scaled.data()), 0, summary.termination_type == ceres::CONVERGENCE,
                end_of(summary)};
  const auto misfit = misfit_at(box, found.value);
  if (summary.termination_type == ceres::FAILURE || !misfit) return std::nullopt;
  found.rms = *misfit;
  return found;
}

/// The inverse of J^T J on what the residuals see of the parameters.
struct Seen {
  Eigen::MatrixXd inverse;
  std::vector<bool> is_seen;
};
Seen seen_by(const Eigen::MatrixXd& jacobian) {
  constexpr double unseen = 1e-10;       // of the eigenvalues of J^T J with a diagonal of ones
  constexpr double member_share = 1e-3;  // of a direction of length one
  const Eigen::Index n = jacobian.cols();
  const Eigen::VectorXd size = jacobian.colwise().norm();
  Seen out{Eigen::MatrixXd::Zero(n, n), std::vector<bool>(static_cast<std::size_t>(n), true)};
  Eigen::VectorXd inverse_size(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    inverse_size(i) = size(i) > 0 ? 1 / size(i) : 0;
    if (!(size(i) > 0)) out.is_seen[static_cast<std::size_t>(i)] = false;
  }
  const Eigen::MatrixXd even = jacobian * inverse_size.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(even.transpose() * even);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Eigen::VectorXd direction = eigen.eigenvectors().col(k);
    if (eigen.eigenvalues()(k) > unseen) {
      out.inverse += direction * direction.transpose() / eigen.eigenvalues()(k);
      continue;
    }
    for (Eigen::Index i = 0; i < n; ++i)
      if (std::abs(direction(i)) >= member_share) out.is_seen[static_cast<std::size_t>(i)] = false;
  }
  out.inverse = inverse_size.asDiagonal() * out.inverse * inverse_size.asDiagonal();
  return out;
}

EndedOn end_on_bound(const FreeParameter& p, double value) {
  const double near = 1e-6 * (p.high - p.low);
  if (value <= p.low + near) return EndedOn::low;
  return value >= p.high - near ? EndedOn::high : EndedOn::neither;
}

/// Standard deviations, what is determined, and correlations.
void judge(const std::vector<FreeParameter>& parameters, const std::vector<ResidualPlace>& place,
           const Eigen::MatrixXd& jacobian, const Values& left, ParameterFit& fit) {
  const Seen seen = seen_by(jacobian);
  const ResidualErrors errors = errors_in(left, place);
  fit.effective_residuals = errors.effective;
  const double free = errors.effective - static_cast<double>(parameters.size());
  const Eigen::MatrixXd covariance = seen.inverse * spread_of_gradient(jacobian, place, errors) *
                                     seen.inverse * (free > 0 ? errors.effective / free : 0);
  const auto n = static_cast<Eigen::Index>(parameters.size());
  fit.correlation.setIdentity(n, n);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const FreeParameter& p = parameters[i];
    FittedParameter& fitted = fit.parameters[i];
    fitted.ended_on = end_on_bound(p, fitted.value);
    if (!seen.is_seen[i] || !(free > 0)) continue;
    const double deviation = unit_of(p) * std::sqrt(std::max(covariance(row, row), 0.0));
    fitted.standard_deviation = deviation;
    fitted.is_determined = deviation < (p.high - p.low) / std::sqrt(12.0);
    for (Eigen::Index column = 0; column < row; ++column) {
      if (!seen.is_seen[static_cast<std::size_t>(column)]) continue;
      const double both = std::sqrt(covariance(row, row) * covariance(column, column));
      if (both > 0)
        fit.correlation(row, column) = fit.correlation(column, row) =
            std::clamp(covariance(row, column) / both, -1.0, 1.0);
    }
  }
}

}  // namespace

ParameterFit fit_parameters(const std::vector<FreeParameter>& parameters,
                            const std::vector<ResidualPlace>& place,
                            const ResidualsOf& residuals_of, const FitOptions& options) {
  expects(!parameters.empty() && !place.empty(), "a fit has parameters and residuals");
  for (const FreeParameter& p : parameters)
    expects(p.low < p.high && p.start >= p.low && p.start <= p.high,
            "a parameter starts between its bounds");
  const Box box(parameters, place.size(), residuals_of, options.threads);
  Values start;
  for (const FreeParameter& p : parameters) start.push_back(p.start);
  const auto misfit = misfit_at(box, start);
  if (!misfit)
    throw Error(ErrorKind::not_converged,
                "nothing can be computed with the values that the fit would start from; give it "
                "others");
  ParameterFit fit;
  fit.residuals = place.size();
  fit.rms_before = *misfit;
  std::optional<Minimum> found = minimum_from(box, parameters, start, options);
  if (const Values other = looked_round(box, parameters, start, *misfit); other != start) {
    const auto also = minimum_from(box, parameters, other, options);
    constexpr double clearly = 1 - 1e-6;
    if (also && (!found || also->rms < clearly * found->rms)) found = also;
  }
  RowMajor jacobian(static_cast<Eigen::Index>(place.size()),
                    static_cast<Eigen::Index>(parameters.size()));
  Values residuals(place.size());
  if (!found || !box.evaluate(found->value, residuals.data()) ||
      !box.slopes(found->value, residuals.data(), jacobian))
    throw Error(ErrorKind::not_converged,
                "the fit found no values with which all can be computed; give it other starts, or "
                "fewer parameters");
  fit.has_converged = found->has_converged;
  fit.ended = found->ended;
  fit.rms_after = root_mean_square(residuals);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const FreeParameter& p = parameters[i];
    fit.parameters.push_back({p.name, p.start, p.low, p.high, found->value[i], {}, false, {}});
  }
  judge(parameters, place, jacobian, residuals, fit);
  return fit;
}

}  // namespace slackwater::calibration

#include "calibration/solve/day_fit.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "calibration/solve/parameter_set.h"
#include "fields/base/error.h"

namespace slackwater::calibration {
namespace {

constexpr double huber_threshold = 2.0;

/// What all pairs share at one evaluation point.
struct SharedRows {
  ColumnRows rows;
  std::vector<double> estimate;  ///< Ceres writes the point here before it calls
  double sigma_m_s = 1;

  explicit SharedRows(const DayProblem& problem)
      : rows(problem.day), estimate(problem.parameters.size()) {}
};

class RowsUpdate final : public ceres::EvaluationCallback {
 public:
  explicit RowsUpdate(SharedRows& shared) : shared_(shared) {}
  void PrepareForEvaluation(bool evaluate_jacobians, bool new_evaluation_point) override {
    if (new_evaluation_point) has_derivatives_ = false;
    if (!new_evaluation_point && (has_derivatives_ || !evaluate_jacobians)) return;
    shared_.rows.evaluate(shared_.estimate.data(), evaluate_jacobians);
    has_derivatives_ = evaluate_jacobians;
  }

 private:
  SharedRows& shared_;
  bool has_derivatives_ = false;
};

/// (model - observed)/sigma of one pair, east and north, with its row of derivatives.
class PairCost final : public ceres::CostFunction {
 public:
  PairCost(const SharedRows& shared, const Pair& pair) : shared_(&shared), pair_(&pair) {
    set_num_residuals(2);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(shared.estimate.size()));
  }
  bool Evaluate(double const* const* /*parameters*/, double* residuals,
                double** jacobians) const override {
    const double whitening = 1.0 / shared_->sigma_m_s;
    const auto t = static_cast<Eigen::Index>(pair_->time);
    const auto k = static_cast<Eigen::Index>(pair_->level);
    const Horizontal miss = shared_->rows.model()(t, k) - pair_->observed_m_s;
    residuals[0] = whitening * miss.real();
    residuals[1] = whitening * miss.imag();
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      const std::size_t count = shared_->estimate.size();
      for (std::size_t i = 0; i < count; ++i) {
        const Horizontal by = shared_->rows.derivative(i)(t, k);
        jacobians[0][i] = whitening * by.real();
        jacobians[0][count + i] = whitening * by.imag();
      }
    }
    return std::isfinite(residuals[0]) && std::isfinite(residuals[1]);
  }

 private:
  const SharedRows* shared_;
  const Pair* pair_;
};

class PriorCost final : public ceres::CostFunction {
 public:
  PriorCost(const Prior& prior, std::size_t index, std::size_t count)
      : prior_(prior), index_(index), count_(count) {
    set_num_residuals(1);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(count));
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    residuals[0] = prior_.residual(parameters[0][index_]);
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      std::fill_n(jacobians[0], count_, 0.0);
      jacobians[0][index_] = prior_.derivative();
    }
    return true;
  }

 private:
  Prior prior_;
  std::size_t index_;
  std::size_t count_;
};

/// Huber's loss times the share of independent pairs, which changes between two solutions of one
/// problem.
class WeightedHuber final : public ceres::LossFunction {
 public:
  double weight = 1;
  void Evaluate(double s, double rho[3]) const override {
    huber_.Evaluate(s, rho);
    for (int i = 0; i < 3; ++i) rho[i] *= weight;
  }

 private:
  ceres::HuberLoss huber_{huber_threshold};
};

ceres::Problem::Options problem_options(ceres::EvaluationCallback* callback) {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // every block has the one parameter block
  options.evaluation_callback = callback;
  return options;
}

ceres::Solver::Options solver_options(DayFit::Precision precision) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  // The cost is about the number of independent pairs: 1e-9 of it moves no parameter by a
  // thousandth of its sigma.
  options.function_tolerance = precision == DayFit::Precision::rough ? 1e-4 : 1e-9;
  options.parameter_tolerance = 1e-8;
  options.gradient_tolerance = 1e-9;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

std::string sentence(const ceres::Solver::Summary& summary) {
  const std::string steps = std::to_string(summary.iterations.size()) + " steps";
  if (summary.termination_type == ceres::CONVERGENCE) {
    const char* what = "the cost no longer falls";
    if (summary.message.starts_with("Gradient")) what = "the gradient has vanished";
    if (summary.message.starts_with("Parameter")) what = "the parameters no longer move";
    return "converged after " + steps + ": " + what;
  }
  return "no minimum after " + steps + ": " + summary.message;
}

}  // namespace

double robust_weight(double squared_residual) noexcept {
  return squared_residual <= huber_threshold * huber_threshold
             ? 1.0
             : huber_threshold / std::sqrt(squared_residual);
}

struct DayFit::State {
  DayProblem day;
  SharedRows shared;
  RowsUpdate update;
  WeightedHuber loss;
  std::deque<PairCost> pair_costs;  // cost functions can be neither copied nor moved
  std::deque<PriorCost> prior_costs;
  ceres::Problem problem;

  explicit State(const DayProblem& given)
      : day(given), shared(day), update(shared), problem(problem_options(&update)) {
    const std::size_t count = day.parameters.size();
    double* const block = shared.estimate.data();
    problem.AddParameterBlock(block, static_cast<int>(count));
    for (const Pair& pair : day.pairs) {
      pair_costs.emplace_back(shared, pair);
      problem.AddResidualBlock(&pair_costs.back(), &loss, block);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const Parameter& p = day.parameters[i];
      prior_costs.emplace_back(prior_of(p), i, count);
      problem.AddResidualBlock(&prior_costs.back(), nullptr, block);
      problem.SetParameterLowerBound(block, static_cast<int>(i), estimated(p, p.lower));
      problem.SetParameterUpperBound(block, static_cast<int>(i), estimated(p, p.upper));
    }
  }
};

DayFit::DayFit(const DayProblem& problem) : state_(std::make_unique<State>(problem)) {}
DayFit::~DayFit() = default;

DayMinimum DayFit::minimise(const std::vector<double>& start, double sigma_m_s, double weight,
                            Precision precision) {
  expects(start.size() == state_->shared.estimate.size(), "one start per parameter");
  std::copy(start.begin(), start.end(),
            state_->shared.estimate.begin());  // the block keeps its address
  state_->shared.sigma_m_s = sigma_m_s;
  state_->loss.weight = weight;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(precision), &state_->problem, &summary);
  if (summary.termination_type != ceres::CONVERGENCE) {
    throw Error(ErrorKind::not_converged,
                sentence(summary) +
                    "; look at the day's currents and wind for values that are not physical");
  }
  return {state_->shared.estimate, summary.final_cost, static_cast<int>(summary.iterations.size()),
          sentence(summary)};
}

const ColumnRows::Matrix& DayFit::model(const std::vector<double>& estimate) {
  state_->shared.rows.evaluate(estimate.data(), false);
  return state_->shared.rows.model();
}

const ColumnRows::Matrix& DayFit::wind_driven() const { return state_->shared.rows.wind_driven(); }

Eigen::MatrixXd DayFit::information(const std::vector<double>& estimate, double sigma_m_s,
                                    double weight) {
  ColumnRows& rows = state_->shared.rows;
  rows.evaluate(estimate.data(), true);
  const auto count = static_cast<Eigen::Index>(estimate.size());
  const auto pairs = static_cast<Eigen::Index>(state_->day.pairs.size());
  const double whitening = 1.0 / sigma_m_s;
  Eigen::MatrixXd jacobian(2 * pairs, count);
  for (Eigen::Index n = 0; n < pairs; ++n) {
    const Pair& pair = state_->day.pairs[static_cast<std::size_t>(n)];
    const auto t = static_cast<Eigen::Index>(pair.time);
    const auto k = static_cast<Eigen::Index>(pair.level);
    const double square = std::norm(whitening * (rows.model()(t, k) - pair.observed_m_s));
    const double root = whitening * std::sqrt(weight * robust_weight(square));
    for (Eigen::Index i = 0; i < count; ++i) {
      const Horizontal by = root * rows.derivative(static_cast<std::size_t>(i))(t, k);
      jacobian(2 * n, i) = by.real();
      jacobian(2 * n + 1, i) = by.imag();
    }
  }
  return jacobian.transpose() * jacobian;
}

}  // namespace slackwater::calibration

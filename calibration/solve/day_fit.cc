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
struct SharedResponses {
  const DayProblem& problem;
  std::vector<double> estimate;  ///< Ceres writes the point here before it calls
  double sigma_m_s = 1;
  double stress_factor = 1;
  std::vector<ResponseDerivatives> response;

  explicit SharedResponses(const DayProblem& day)
      : problem(day), estimate(day.parameters.size()), response(day.depth_m.size()) {}

  void update() {
    const bool has_shape = estimate.size() > log_bottom;
    response_derivatives(problem.form, has_shape ? estimate[log_eddy_viscosity] : 0.0,
                         has_shape ? estimate[log_bottom] : 0.0, problem.latitude,
                         problem.water_depth_m, problem.depth_m, response);
    stress_factor =
        estimate.size() > log_stress_factor ? std::exp(estimate[log_stress_factor]) : 1.0;
  }
};

class ResponseUpdate final : public ceres::EvaluationCallback {
 public:
  explicit ResponseUpdate(SharedResponses& shared) : shared_(shared) {}
  void PrepareForEvaluation(bool /*evaluate_jacobians*/, bool new_evaluation_point) override {
    if (new_evaluation_point) shared_.update();
  }

 private:
  SharedResponses& shared_;
};

class LevelVelocityCost final : public ceres::CostFunction {
 public:
  LevelVelocityCost(const SharedResponses& shared, const LevelVelocity& pair)
      : shared_(&shared), pair_(&pair) {
    set_num_residuals(2);
    mutable_parameter_block_sizes()->push_back(static_cast<int>(shared.estimate.size()));
  }
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    level_velocity_residual(*pair_, shared_->response[pair_->level], parameters[0],
                            shared_->estimate.size(), shared_->stress_factor, shared_->sigma_m_s,
                            residuals, jacobians == nullptr ? nullptr : jacobians[0]);
    return std::isfinite(residuals[0]) && std::isfinite(residuals[1]);
  }

 private:
  const SharedResponses* shared_;
  const LevelVelocity* pair_;
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
  SharedResponses shared;
  ResponseUpdate update;
  WeightedHuber loss;
  std::deque<LevelVelocityCost> pair_costs;  // cost functions can be neither copied nor moved
  std::deque<PriorCost> prior_costs;
  ceres::Problem problem;

  explicit State(const DayProblem& given)
      : day(given), shared(day), update(shared), problem(problem_options(&update)) {
    const std::size_t count = day.parameters.size();
    double* const block = shared.estimate.data();
    problem.AddParameterBlock(block, static_cast<int>(count));
    for (const LevelVelocity& pair : day.pairs) {
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
  return {state_->shared.estimate, static_cast<int>(summary.iterations.size()), sentence(summary)};
}

Eigen::MatrixXd DayFit::information(const std::vector<double>& estimate, double sigma_m_s,
                                    double weight) const {
  SharedResponses at(state_->day);
  at.estimate = estimate;
  at.update();
  const std::size_t count = estimate.size();
  Eigen::MatrixXd information =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
  double residual[2];
  double jacobian[2 * parameter_count];
  for (const LevelVelocity& pair : state_->day.pairs) {
    level_velocity_residual(pair, at.response[pair.level], estimate.data(), count, at.stress_factor,
                            sigma_m_s, residual, jacobian);
    const Eigen::Map<const Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor>> j(
        jacobian, 2, static_cast<Eigen::Index>(count));
    const double robust = robust_weight(residual[0] * residual[0] + residual[1] * residual[1]);
    information.noalias() += (weight * robust) * j.transpose() * j;
  }
  return information;
}

}  // namespace slackwater::calibration

#include "calibration/solve/day_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/solve/parameter_set.h"
#include "fields/base/error.h"

namespace slackwater::calibration {
namespace {

/// The squares of the priors beside those of the pairs.
void add_priors(const std::vector<Parameter>& parameters, const std::vector<double>& estimate,
                NormalEquations& equations) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const Prior prior = prior_of(parameters[i]);
    const double off = prior.residual(estimate[i]);
    equations.cost += 0.5 * off * off;
    equations.gradient(row) += off * prior.derivative();
    equations.information(row, row) += prior.derivative() * prior.derivative();
  }
}

/// The whole day as one block of n + 1 residuals, see `DayFit`.
class DayCost final : public ceres::CostFunction {
 public:
  DayCost(const DayProblem& problem, DayMisfit& misfit)
      : problem_(&problem), misfit_(&misfit), estimate_(problem.parameters.size()) {
    const auto count = static_cast<int>(estimate_.size());
    set_num_residuals(count + 1);
    mutable_parameter_block_sizes()->push_back(count);
  }

  void set_weighing(const PairWeighing& weighing) {
    weighing_ = weighing;
    stands_ = false;
  }

  // The derivatives are made at once: most points that are tried are kept.
  bool Evaluate(double const* const* parameters, double* residuals,
                double** jacobians) const override {
    if (!stands_ || !std::equal(estimate_.begin(), estimate_.end(), parameters[0])) {
      stands_ = false;
      estimate_.assign(parameters[0], parameters[0] + estimate_.size());
      if (!rotate()) return false;
      stands_ = true;
    }
    const Eigen::Index n = turned_.size() - 1;
    Eigen::Map<Eigen::VectorXd>(residuals, n + 1) = turned_;
    if (jacobians != nullptr && jacobians[0] != nullptr) {
      Eigen::Map<Planes> jacobian(jacobians[0], n + 1, n);
      jacobian.topRows(n) = factor_.matrixU();
      jacobian.row(n).setZero();
    }
    return true;
  }

 private:
  bool rotate() const {
    NormalEquations equations = misfit_->normal_equations(estimate_, weighing_);
    add_priors(problem_->parameters, estimate_, equations);
    factor_.compute(equations.information);
    if (!std::isfinite(equations.cost) || factor_.info() != Eigen::Success) return false;
    const Eigen::Index n = equations.gradient.size();
    turned_.resize(n + 1);
    turned_.head(n) = factor_.matrixL().solve(equations.gradient);
    turned_(n) = std::sqrt(std::max(0.0, 2.0 * equations.cost - turned_.head(n).squaredNorm()));
    return true;
  }

  const DayProblem* problem_;
  DayMisfit* misfit_;
  PairWeighing weighing_;
  // What stands at a point is kept for the next question about it; Ceres asks through const.
  mutable std::vector<double> estimate_;
  mutable bool stands_ = false;
  mutable Eigen::LLT<Eigen::MatrixXd> factor_;
  mutable Eigen::VectorXd turned_;
};

ceres::Problem::Options problem_options() {
  ceres::Problem::Options options;
  options.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  options.disable_all_safety_checks = true;  // there is one block
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

struct DayFit::State {
  DayProblem day;
  DayMisfit misfit;
  std::vector<double> estimate;  ///< Ceres writes here
  DayCost cost;
  ceres::Problem problem;

  explicit State(const DayProblem& given)
      : day(given),
        misfit(day.day, day.pairs),
        estimate(day.parameters.size()),
        cost(day, misfit),
        problem(problem_options()) {
    problem.AddResidualBlock(&cost, nullptr, estimate.data());
    for (std::size_t i = 0; i < estimate.size(); ++i) {
      const Parameter& p = day.parameters[i];
      problem.SetParameterLowerBound(estimate.data(), static_cast<int>(i), estimated(p, p.lower));
      problem.SetParameterUpperBound(estimate.data(), static_cast<int>(i), estimated(p, p.upper));
    }
  }
};

DayFit::DayFit(const DayProblem& problem) : state_(std::make_unique<State>(problem)) {}
DayFit::~DayFit() = default;

DayMinimum DayFit::minimise(const std::vector<double>& start, double sigma_m_s, double weight,
                            Precision precision) {
  State& state = *state_;
  expects(start.size() == state.estimate.size(), "one start per parameter");
  std::copy(start.begin(), start.end(), state.estimate.begin());  // the block keeps its address
  state.cost.set_weighing({sigma_m_s, weight, state.day.loss});
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(precision), &state.problem, &summary);
  if (summary.termination_type != ceres::CONVERGENCE) {
    throw Error(ErrorKind::not_converged,
                sentence(summary) +
                    "; look at the day's currents and wind for values that are not physical");
  }
  return {state.estimate, summary.final_cost, static_cast<int>(summary.iterations.size()),
          sentence(summary)};
}

const ColumnRows& DayFit::at(const std::vector<double>& estimate, bool with_derivatives) {
  return state_->misfit.at(estimate, with_derivatives);
}

Eigen::MatrixXd DayFit::information(const std::vector<double>& estimate, double sigma_m_s,
                                    double weight) {
  return state_->misfit.normal_equations(estimate, {sigma_m_s, weight, state_->day.loss})
      .information;
}

}  // namespace slackwater::calibration

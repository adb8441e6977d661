#include "tests/published/profile_problem.h"

#include <ceres/ceres.h>

#include <deque>

#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

using LevelCost = ceres::AutoDiffCostFunction<ProfileLevelResidual, 2, profile_parameter_count>;

struct PriorResidual {
  Prior prior;
  std::size_t index;

  template <typename T>
  bool operator()(const T* estimate, T* residual) const {
    residual[0] = (estimate[index] - T(prior.mean)) / T(prior.sigma);
    return true;
  }
};
using PriorCost = ceres::AutoDiffCostFunction<PriorResidual, 1, profile_parameter_count>;

ceres::Solver::Options solver_options() {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = 200;
  // The cost is about the number of levels: 1e-9 of it moves no parameter by a thousandth of sigma.
  options.function_tolerance = 1e-9;
  options.parameter_tolerance = 1e-8;
  options.gradient_tolerance = 1e-9;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace

ProfileMinimum minimise_profile(ProfileForm form, Angle latitude,
                                std::span<const ProfileLevel> levels, double sigma_m_s,
                                const ProfileEstimate& start) {
  ProfileMinimum minimum{.form = form, .estimate = start, .termination = {}};
  double* const block = minimum.estimate.data();
  ceres::Problem problem;  // owns the cost functions
  for (const ProfileLevel& level : levels) {
    problem.AddResidualBlock(
        new LevelCost(new ProfileLevelResidual{form, level, sigma_m_s, latitude.radians() > 0}),
        nullptr, block);
  }
  const std::vector<Parameter> parameters = profile_parameters(form, latitude);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const Parameter& p = parameters[i];
    problem.AddResidualBlock(new PriorCost(new PriorResidual{prior_of(p), i}), nullptr, block);
    problem.SetParameterLowerBound(block, static_cast<int>(i), estimated(p, p.lower));
    problem.SetParameterUpperBound(block, static_cast<int>(i), estimated(p, p.upper));
  }
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(), &problem, &summary);
  minimum.cost = summary.final_cost;
  minimum.converged = summary.termination_type == ceres::CONVERGENCE;
  minimum.termination = (minimum.converged ? "converged after " : "no minimum after ") +
                        std::to_string(summary.iterations.size()) + " steps: " + summary.message;
  return minimum;
}

ProfileInformation profile_information(ProfileForm form, bool is_northern,
                                       std::span<const ProfileLevel> levels, double sigma_m_s,
                                       const ProfileEstimate& estimate) {
  ProfileInformation information = ProfileInformation::Zero();
  for (const ProfileLevel& level : levels) {
    const LevelCost cost(new ProfileLevelResidual{form, level, sigma_m_s, is_northern});
    Eigen::Matrix<double, 2, profile_parameter_count, Eigen::RowMajor> jacobian;
    double residual[2];
    double* const jacobians[1] = {jacobian.data()};
    const double* const blocks[1] = {estimate.data()};
    cost.Evaluate(blocks, residual, const_cast<double**>(jacobians));
    information.noalias() += jacobian.transpose() * jacobian;
  }
  return information;
}

}  // namespace slackwater::calibration

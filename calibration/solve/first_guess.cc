#include "calibration/solve/first_guess.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/solve/normal_equations.h"
#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

constexpr double searched_sigma = 0.55;  ///< of a logarithm: narrower than any general prior's

/// Values of one parameter to try, in the terms of the estimate.
std::vector<double> tries(const Parameter& p, int steps) {
  const Prior prior = prior_of(p);
  std::vector<double> values;
  for (int i = 0; i < steps; ++i) {
    const double offset = steps == 1 ? 0.0 : 4.0 * i / (steps - 1) - 2.0;
    values.push_back(std::clamp(prior.mean + offset * prior.sigma, estimated(p, p.lower),
                                estimated(p, p.upper)));
  }
  return values;
}

/// The points of the grid: all parameters at their priors but for those that shape the column.
std::vector<std::vector<double>> grid(const DayProblem& problem) {
  const ParameterLayout& layout = problem.day.layout;
  std::vector<double> prior;
  for (const Parameter& p : problem.parameters) prior.push_back(estimated(p, p.prior));
  std::vector<std::vector<double>> points{prior};
  const auto spread = [&](std::size_t index, int steps) {
    // What is known already, be it from yesterday, needs no search.
    const Parameter& p = problem.parameters[index];
    const std::vector<double> values = tries(p, p.prior_sigma < searched_sigma ? 1 : steps);
    std::vector<std::vector<double>> more;
    for (const auto& point : points) {
      for (const double value : values) {
        more.push_back(point);
        more.back()[index] = value;
      }
    }
    points = std::move(more);
  };
  if (!layout.has_shape) return points;
  const bool is_steady = !layout.is_unsteady;
  spread(ParameterLayout::log_viscosity, is_steady ? 7 : 3);
  if (is_steady) spread(ParameterLayout::log_bottom, 3);
  if (layout.has_layer()) spread(layout.log_layer(), 3);
  return points;
}

struct Guess {
  double cost = std::numeric_limits<double>::infinity();
  std::vector<double> estimate;
};

/// Gauss-Newton in the linear parameters from a point of the grid, which is exact but for the
/// factor.
Guess solve_linear(const DayProblem& problem, DayMisfit& misfit, std::vector<double> estimate) {
  const ParameterLayout& layout = problem.day.layout;
  const NormalEquations& all =
      misfit.normal_equations(estimate, {problem.sigma_m_s, 1.0, Loss::plain});
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const bool shapes = layout.has_shape &&
                        (i == ParameterLayout::log_viscosity || i == ParameterLayout::log_bottom ||
                         (layout.has_layer() && i == layout.log_layer()));
    if (!shapes) free.push_back(i);
  }
  Eigen::MatrixXd normal = all.information(free, free);
  const Eigen::VectorXd right = -all.gradient(free);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double sigma = problem.parameters[free[i]].prior_sigma;
    const auto row = static_cast<Eigen::Index>(i);
    normal(row, row) += 1.0 / (sigma * sigma);
  }
  const Eigen::VectorXd step = normal.ldlt().solve(right);
  Guess guess;
  guess.cost = 2.0 * all.cost - step.dot(right);
  for (std::size_t i = 0; i < free.size(); ++i) {
    const double x = step(static_cast<Eigen::Index>(i));
    // The factor itself is linear, its logarithm is not; a step may leave what that can follow.
    const bool is_factor = layout.has_wind && free[i] == layout.log_factor();
    estimate[free[i]] += is_factor ? std::log1p(std::clamp(x, -0.8, 4.0)) : x;
  }
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const Parameter& p = problem.parameters[i];
    const double off = prior_of(p).residual(estimate[i]);
    if (std::find(free.begin(), free.end(), i) == free.end()) guess.cost += off * off;
    estimate[i] = std::clamp(estimate[i], estimated(p, p.lower), estimated(p, p.upper));
  }
  guess.estimate = std::move(estimate);
  return guess;
}

}  // namespace

std::vector<double> first_guess(const DayProblem& problem) {
  DayMisfit misfit(problem.day, problem.pairs);
  Guess best;
  for (std::vector<double>& point : grid(problem)) {
    Guess guess = solve_linear(problem, misfit, std::move(point));
    if (guess.cost < best.cost) best = std::move(guess);
  }
  return best.estimate;
}

}  // namespace slackwater::calibration

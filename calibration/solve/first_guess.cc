#include "calibration/solve/first_guess.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

/// What the linear problem needs of one level's pairs (y observed, t stress).
struct LevelSums {
  double n = 0;
  Horizontal y{};
  Horizontal t{};
  double tt = 0;    ///< sum |t|^2
  Horizontal yt{};  ///< sum y conj(t)
  double yy = 0;    ///< sum |y|^2
};

std::vector<LevelSums> sums_of(const DayProblem& problem) {
  std::vector<LevelSums> sums(problem.depth_m.size());
  for (const LevelVelocity& pair : problem.pairs) {
    LevelSums& s = sums[pair.level];
    s.n += 1;
    s.y += pair.observed_m_s;
    s.t += pair.stress_pa;
    s.tt += std::norm(pair.stress_pa);
    s.yt += pair.observed_m_s * std::conj(pair.stress_pa);
    s.yy += std::norm(pair.observed_m_s);
  }
  return sums;
}

struct Guess {
  double cost = std::numeric_limits<double>::infinity();
  Horizontal flow{};
  double factor = 1;
};

/// Least squares of y = W A + c t B over all levels in W (complex) and c (real).
Guess solve_linear(const std::vector<LevelSums>& sums,
                   const std::vector<LevelResponse<double>>& response, const DayProblem& problem) {
  const double weight = 1.0 / (problem.sigma_m_s * problem.sigma_m_s);
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double constant = 0;
  for (std::size_t k = 0; k < sums.size(); ++k) {
    const Horizontal a = to_horizontal(response[k].interior);
    const Horizontal b = to_horizontal(response[k].stress);
    const Horizontal at = std::conj(a) * b * sums[k].t;  // sum conj(A) B t
    const Horizontal ay = std::conj(a) * sums[k].y;
    normal(0, 0) += weight * sums[k].n * std::norm(a);
    normal(0, 2) += weight * at.real();
    normal(1, 2) += weight * at.imag();
    normal(2, 2) += weight * std::norm(b) * sums[k].tt;
    right(0) += weight * ay.real();
    right(1) += weight * ay.imag();
    right(2) += weight * (std::conj(b) * sums[k].yt).real();
    constant += weight * sums[k].yy;
  }
  normal(1, 1) = normal(0, 0);
  const double flow_prior =
      1.0 / (problem.parameters[0].prior_sigma * problem.parameters[0].prior_sigma);
  normal(0, 0) += flow_prior;
  normal(1, 1) += flow_prior;
  normal(2, 0) = normal(0, 2);
  normal(2, 1) = normal(1, 2);

  // About 1 the logarithm of the factor and the factor itself have the same prior.
  const bool has_factor = problem.parameters.size() > log_stress_factor;
  const double sigma = has_factor ? problem.parameters[log_stress_factor].prior_sigma : 1.0;
  normal(2, 2) += 1.0 / (sigma * sigma);
  right(2) += 1.0 / (sigma * sigma);
  Eigen::Vector3d x = normal.ldlt().solve(right);
  if (has_factor && !(x(2) > 0.2 && x(2) < 5.0)) {
    // Out of what the logarithm can reach in a step: fix the factor at the nearer end and solve for
    // the flow.
    x(2) = x(2) > 0.2 ? 5.0 : 0.2;
    const Eigen::Vector2d rest = right.head<2>() - normal.block<2, 1>(0, 2) * x(2);
    x.head<2>() = normal.topLeftCorner<2, 2>().ldlt().solve(rest);
  }
  Guess guess;
  guess.cost = x.dot(normal * x) - 2.0 * x.dot(right) + constant;
  guess.flow = {x(0), x(1)};
  guess.factor = x(2);
  return guess;
}

}  // namespace

std::vector<double> first_guess(const DayProblem& problem) {
  const std::vector<LevelSums> sums = sums_of(problem);
  std::vector<LevelResponse<double>> response(problem.depth_m.size());
  const bool has_shape = problem.parameters.size() > log_bottom;
  Guess best;
  double best_viscosity = 0;
  double best_bottom = 0;
  const int viscosity_steps = has_shape ? 13 : 1;
  const int bottom_steps = has_shape ? 7 : 1;
  for (int i = 0; i < viscosity_steps; ++i) {
    for (int j = 0; j < bottom_steps; ++j) {
      double log_viscosity = 0;
      double log_friction = 0;
      double prior_cost = 0;
      if (has_shape) {
        // Two and a half standard deviations of the prior either way, within the bounds.
        const auto at = [&](std::size_t index, int step, int steps) {
          const Parameter& p = problem.parameters[index];
          const Prior prior = prior_of(p);
          const double offset = 2.5 * (2.0 * step / (steps - 1) - 1.0);
          const double x = std::clamp(prior.mean + offset * prior.sigma, estimated(p, p.lower),
                                      estimated(p, p.upper));
          prior_cost += prior.residual(x) * prior.residual(x);
          return x;
        };
        log_viscosity = at(log_eddy_viscosity, i, viscosity_steps);
        log_friction = at(log_bottom, j, bottom_steps);
      }
      steady_responses<double>(problem.form, std::exp(log_viscosity), std::exp(log_friction),
                               problem.latitude, problem.water_depth_m, problem.depth_m, response);
      Guess guess = solve_linear(sums, response, problem);
      guess.cost += prior_cost;
      if (guess.cost < best.cost) {
        best = guess;
        best_viscosity = log_viscosity;
        best_bottom = log_friction;
      }
    }
  }
  std::vector<double> start{best.flow.real(), best.flow.imag()};
  if (has_shape) {
    start.push_back(best_viscosity);
    start.push_back(best_bottom);
  }
  if (problem.parameters.size() > log_stress_factor) start.push_back(std::log(best.factor));
  for (std::size_t i = 0; i < start.size(); ++i) {
    const Parameter& p = problem.parameters[i];
    start[i] = std::clamp(start[i], estimated(p, p.lower), estimated(p, p.upper));
  }
  return start;
}

}  // namespace slackwater::calibration

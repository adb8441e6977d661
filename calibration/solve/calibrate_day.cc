#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "calibration/solve/calibration.h"
#include "calibration/solve/day_fit.h"
#include "calibration/solve/determination.h"
#include "calibration/solve/first_guess.h"
#include "calibration/solve/misfit.h"
#include "calibration/solve/observations.h"
#include "calibration/solve/parameter_set.h"
#include "calibration/solve/residual_memory.h"
#include "fields/base/error.h"

namespace slackwater::calibration {
namespace {

Eigen::MatrixXd posterior_covariance(Eigen::MatrixXd information,
                                     const std::vector<Parameter>& parameters) {
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    information(row, row) += 1.0 / (parameters[i].prior_sigma * parameters[i].prior_sigma);
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(information);
  if (factor.info() != Eigen::Success) {
    throw Error(ErrorKind::not_converged,
                "the information matrix at the optimum is not positive definite; look at the day's "
                "currents "
                "and wind for values that are not physical");
  }
  return factor.solve(Eigen::MatrixXd::Identity(information.rows(), information.cols()));
}

DayProblem make_problem(const CalibrationInput& input, const Observations& observations,
                        SteadyForm form) {
  DayProblem problem;
  ColumnDay& day = problem.day;
  day.layout.form = form;
  day.layout.has_shape = !is_equatorial(input.latitude);
  day.layout.has_wind = observations.wind_used && day.layout.has_shape;
  day.layout.is_unsteady = input.is_unsteady;
  day.latitude = input.latitude;
  day.water_depth_m = observations.water_depth_m;
  day.depth_m = observations.depth_m;
  day.time = input.current.time;
  day.stress_pa = observations.stress_pa;
  day.start = UtcTime(day_of(input.current.time.front().start));
  if (day.layout.has_modes() && day.layout.has_wind) {
    const double last_h = hours_between(day.start, input.current.time.back().end);
    day.hourly = HourlyStress::sample(observations.stress, day.start, stress_history_h, last_h);
  }
  problem.pairs = observations.pairs;
  problem.parameters = prior_parameters(day.layout, day.water_depth_m, input.known);
  problem.sigma_m_s = std::hypot(input.observation_sigma_m_s, observations.noise_m_s);
  return problem;
}

double log_occam(const std::vector<double>& estimate, const std::vector<Parameter>& parameters,
                 const Eigen::MatrixXd& covariance) {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance);
  double sum = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const double off = prior_of(parameters[i]).residual(estimate[i]);
    sum += std::log(factor.matrixL()(row, row) / parameters[i].prior_sigma) - 0.5 * off * off;
  }
  return sum;
}

}  // namespace

Calibration calibrate_day(const CalibrationInput& input) {
  const Observations observations = pair_observations(input);
  const SteadyForm form =
      input.form.value_or(default_form(observations.water_depth_m, input.latitude));
  const DayProblem problem = make_problem(input, observations, form);
  Calibration result;
  result.form = form;
  result.layout = problem.day.layout;
  result.start = problem.day.start;
  result.drag_law = input.drag_law;
  result.latitude = input.latitude;
  result.water_depth_m = observations.water_depth_m;
  result.wind_used = observations.wind_used;
  result.observations = observations.pairs.size();
  result.warnings = observations.warnings;
  result.noise_m_s = input.noise_m_s;
  result.parameters = problem.parameters;

  // The misfit says what the day is worth: how large it is, and how much of it repeats itself. A
  // rough minimum under the first guess's misfit is enough to measure both.
  DayFit fit(problem);
  const auto residual_at = [&](const std::vector<double>& estimate) {
    return residual_column(input.current, observations, fit.at(estimate, true).model());
  };
  const auto whitening = [&](const VectorColumn& residual) {
    return std::max(problem.sigma_m_s, robust_component_sigma_m_s(residual));
  };
  const std::vector<double> start = first_guess(problem);
  const DayMinimum rough =
      fit.minimise(start, whitening(residual_at(start)), 1.0, DayFit::Precision::rough);
  result.iterations = rough.iterations;
  DayMinimum minimum = rough;
  result.residual = residual_at(rough.estimate);
  double sigma_m_s = 0;
  double weight = 1;
  // A poor first guess leaves a rough minimum that takes its own error for noise: measured again
  // where the noise turns out much smaller.
  do {
    sigma_m_s = whitening(result.residual);
    result.effective_observations = residual_memory(result.residual).effective_pairs;
    weight = result.effective_observations / static_cast<double>(result.observations);
    minimum = fit.minimise(minimum.estimate, sigma_m_s, weight, DayFit::Precision::full);
    result.iterations += minimum.iterations;
    result.residual = residual_at(minimum.estimate);
  } while (whitening(result.residual) < 0.7 * sigma_m_s);
  result.whitening_sigma_m_s = sigma_m_s;
  result.misfit_sigma_m_s = robust_component_sigma_m_s(result.residual);
  result.termination = minimum.termination;

  const Eigen::MatrixXd covariance =
      posterior_covariance(fit.information(minimum.estimate, sigma_m_s, weight), result.parameters);
  result.log_occam = log_occam(minimum.estimate, result.parameters, covariance);
  for (std::string& warning :
       judge_determination(minimum.estimate, covariance, result.parameters)) {
    result.warnings.push_back(std::move(warning));
  }
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    for (Eigen::Index j = 0; j < covariance.cols(); ++j)
      result.covariance.push_back(covariance(i, j));
  }
  // The wind's part alone: the model without interior and free inertial motion.
  const ColumnRows& driven = fit.at(without_flow(minimum.estimate, result.layout), false);
  result.remembered = residual_column(input.current, observations, driven.model());
  const ColumnRows::Matrix& wind = driven.wind_driven();
  result.wind_driven_m_s.assign(wind.data(), wind.data() + wind.size());
  result.misfit = misfit_by_depth(result.residual, observations.depth_m);
  result.rms_m_s = rms_m_s(result.residual);
  return result;
}

std::vector<double> form_weights(const std::vector<Calibration>& forms) {
  constexpr double finest_m_s = 0.005;
  double observations = 0;
  for (const Calibration& c : forms)
    observations = std::max(observations, c.effective_observations);
  std::vector<double> log_weight;
  for (const Calibration& c : forms) {
    const double sigma_m_s = std::max(finest_m_s, c.misfit_sigma_m_s);
    log_weight.push_back(-2.0 * observations * std::log(sigma_m_s) + c.log_occam);
  }
  double sum = 0;
  const double best = *std::max_element(log_weight.begin(), log_weight.end());
  for (double& w : log_weight) sum += w = std::exp(w - best);
  for (double& w : log_weight) w /= sum;
  return log_weight;
}

SteadyParameters steady_parameters(const std::vector<Parameter>& parameters) {
  SteadyParameters steady;
  for (const Parameter& p : parameters) {
    if (p.name == "interior_east") steady.interior_east_m_s = p.value;
    if (p.name == "interior_north") steady.interior_north_m_s = p.value;
    if (p.name == "eddy_viscosity") steady.eddy_viscosity_m2_s = p.value;
    if (p.name == "bottom_friction") steady.bottom_friction_m_s = p.value;
    if (p.name == "bottom_eddy_viscosity") steady.bottom_eddy_viscosity_m2_s = p.value;
    if (p.name == "base_friction") steady.base_friction_m_s = p.value;
    if (p.name == "mixed_layer_depth") steady.mixed_layer_depth_m = p.value;
    if (p.name == "stress_factor") steady.stress_factor = p.value;
  }
  return steady;
}

SteadyParameters steady_parameters(const Calibration& calibration) {
  return steady_parameters(calibration.parameters);
}

const Parameter* find_parameter(const Calibration& calibration, std::string_view name) {
  const auto found = std::find_if(calibration.parameters.begin(), calibration.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  return found == calibration.parameters.end() ? nullptr : &*found;
}

}  // namespace slackwater::calibration

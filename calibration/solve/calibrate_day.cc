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

SteadyParameters to_steady(const std::vector<Parameter>& set) {
  SteadyParameters steady;
  for (const Parameter& p : set) {
    if (p.name == "interior_east") steady.interior_east_m_s = p.value;
    if (p.name == "interior_north") steady.interior_north_m_s = p.value;
    if (p.name == "eddy_viscosity") steady.eddy_viscosity_m2_s = p.value;
    if (p.name == "bottom_friction") steady.bottom_friction_m_s = p.value;
    if (p.name == "bottom_eddy_viscosity") steady.bottom_eddy_viscosity_m2_s = p.value;
    if (p.name == "stress_factor") steady.stress_factor = p.value;
  }
  return steady;
}

SteadyParameters to_steady(std::vector<Parameter> set, const std::vector<double>& estimate) {
  for (std::size_t i = 0; i < set.size(); ++i) set[i].value = physical(set[i], estimate[i]);
  return to_steady(set);
}

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
  problem.form = form;
  problem.latitude = input.latitude;
  problem.water_depth_m = observations.water_depth_m;
  problem.depth_m = observations.depth_m;
  problem.pairs = observations.pairs;
  problem.parameters =
      prior_parameters(form, is_equatorial(input.latitude), observations.wind_used);
  problem.sigma_m_s = input.observation_sigma_m_s;
  return problem;
}

}  // namespace

Calibration calibrate_day(const CalibrationInput& input) {
  const Observations observations = pair_observations(input);
  Calibration result;
  result.form = input.form.value_or(default_form(observations.water_depth_m, input.latitude));
  result.drag_law = input.drag_law;
  result.latitude = input.latitude;
  result.water_depth_m = observations.water_depth_m;
  result.wind_used = observations.wind_used;
  result.observations = observations.pairs.size();
  result.warnings = observations.warnings;

  const DayProblem problem = make_problem(input, observations, result.form);
  result.parameters = problem.parameters;
  const auto residual_at = [&](const std::vector<double>& estimate) {
    return residual_column(input.current, observations, result.form,
                           to_steady(problem.parameters, estimate), input.latitude);
  };

  // The misfit says what the day is worth: how large it is, and how much of it repeats itself. A
  // rough minimum under the first guess's misfit is enough to measure both.
  const auto whitening = [&](const VectorColumn& residual) {
    return std::max(problem.sigma_m_s, robust_component_sigma_m_s(residual));
  };
  DayFit fit(problem);
  const std::vector<double> start = first_guess(problem);
  const DayMinimum rough =
      fit.minimise(start, whitening(residual_at(start)), 1.0, DayFit::Precision::rough);
  const VectorColumn rough_residual = residual_at(rough.estimate);
  const double sigma_m_s = whitening(rough_residual);
  const ResidualMemory memory = residual_memory(rough_residual);
  const double weight = memory.effective_pairs / static_cast<double>(result.observations);

  const DayMinimum minimum =
      fit.minimise(rough.estimate, sigma_m_s, weight, DayFit::Precision::full);
  result.iterations = rough.iterations + minimum.iterations;
  result.residual = residual_at(minimum.estimate);
  result.effective_observations = memory.effective_pairs;
  result.whitening_sigma_m_s = sigma_m_s;
  result.termination = minimum.termination;

  const Eigen::MatrixXd covariance =
      posterior_covariance(fit.information(minimum.estimate, sigma_m_s, weight), result.parameters);
  for (std::string& warning :
       judge_determination(minimum.estimate, covariance, result.parameters)) {
    result.warnings.push_back(std::move(warning));
  }
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    for (Eigen::Index j = 0; j < covariance.cols(); ++j)
      result.covariance.push_back(covariance(i, j));
  }
  result.misfit = misfit_by_depth(result.residual, observations.depth_m);
  result.rms_m_s = rms_m_s(result.residual);
  return result;
}

SteadyParameters steady_parameters(const Calibration& calibration) {
  return to_steady(calibration.parameters);
}

const Parameter* find_parameter(const Calibration& calibration, std::string_view name) {
  const auto found = std::find_if(calibration.parameters.begin(), calibration.parameters.end(),
                                  [&](const Parameter& p) { return p.name == name; });
  return found == calibration.parameters.end() ? nullptr : &*found;
}

}  // namespace slackwater::calibration

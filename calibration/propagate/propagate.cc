#include "calibration/propagate/propagate.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "calibration/propagate/carried_residual.h"
#include "calibration/propagate/inertial_memory.h"
#include "calibration/residuals/level_velocity.h"
#include "fields/current/coriolis.h"
#include "fields/current/stress_series.h"

namespace slackwater::calibration {
namespace {

/// Variance of one component (mean of the two) that the parameters' covariance gives the model.
class ParameterVariance {
 public:
  ParameterVariance(const Calibration& calibration, std::span<const double> depths_m)
      : count_(calibration.parameters.size()), response_(depths_m.size()) {
    for (const Parameter& p : calibration.parameters) {
      estimate_.push_back(p.is_logarithmic ? std::log(p.value) : p.value);
    }
    stress_factor_ =
        count_ > log_stress_factor ? calibration.parameters[log_stress_factor].value : 1.0;
    const auto n = static_cast<Eigen::Index>(count_);
    expects(calibration.covariance.size() == count_ * count_, "the covariance is n x n");
    covariance_ = Eigen::Map<const Eigen::MatrixXd>(calibration.covariance.data(), n, n);
    response_derivatives(calibration.form,
                         count_ > log_bottom ? estimate_[log_eddy_viscosity] : 0.0,
                         count_ > log_bottom ? estimate_[log_bottom] : 0.0, calibration.latitude,
                         calibration.water_depth_m, depths_m, response_);
  }

  [[nodiscard]] double at(std::size_t depth, Horizontal stress_pa) const {
    double value[2];
    double jacobian[2 * parameter_count];
    level_velocity_residual({{}, stress_pa, depth}, response_[depth], estimate_.data(), count_,
                            stress_factor_, 1.0, value, jacobian);
    const auto n = static_cast<Eigen::Index>(count_);
    const Eigen::Map<const Eigen::VectorXd> east(jacobian, n);
    const Eigen::Map<const Eigen::VectorXd> north(jacobian + count_, n);
    return 0.5 * (east.dot(covariance_ * east) + north.dot(covariance_ * north));
  }

 private:
  std::size_t count_;
  std::vector<double> estimate_;
  double stress_factor_ = 1;
  Eigen::MatrixXd covariance_;
  std::vector<ResponseDerivatives> response_;
};

}  // namespace

Propagated propagate(const Calibration& calibration, std::span<const UtcTime> times,
                     std::span<const double> depths_m, const std::optional<VectorColumn>& wind,
                     UtcTime end_of_day, const PropagationSettings& settings) {
  const std::size_t depths = depths_m.size();
  const StressSeries series =
      wind && calibration.wind_used ? StressSeries(*wind, calibration.drag_law) : StressSeries();
  Propagated result;
  std::vector<Horizontal> stress_pa(times.size());
  result.has_wind.assign(times.size(), false);
  for (std::size_t t = 0; t < times.size(); ++t) {
    if (!calibration.wind_used) continue;
    const std::optional<Horizontal> stress = series.at(times[t]);
    result.has_wind[t] = stress.has_value();
    if (stress) {
      stress_pa[t] = *stress;
    } else {
      ++result.wind_missing;
    }
  }

  const SteadyParameters parameters = steady_parameters(calibration);
  const LevelResponses responses = level_responses(
      calibration.form, parameters, calibration.latitude, calibration.water_depth_m, depths_m);
  result.mean_m_s.resize(times.size() * depths);
  result.wind_driven_m_s.resize(times.size() * depths);
  result.carried_m_s.resize(times.size() * depths);
  result.sigma_m_s.resize(times.size() * depths);
  evaluate_steady(responses, parameters.interior_m_s(), stress_pa, result.mean_m_s);
  evaluate_steady(responses, Horizontal{}, stress_pa, result.wind_driven_m_s);

  const CarriedResidual carried = carried_residual(calibration, depths_m, end_of_day, settings);
  const Horizontal inertia(inertial_damping_per_h(calibration, settings.inertial_decay_h),
                           3600.0 * coriolis_parameter_rad_s(calibration.latitude));
  const ParameterVariance variance(calibration, depths_m);
  for (std::size_t t = 0; t < times.size(); ++t) {
    const double lead_h = std::max(0.0, hours_between(end_of_day, times[t]));
    const double bias_left = std::exp(-lead_h / settings.bias_decay_h);
    const double recent_left = std::exp(-(lead_h + carried.age_h) / settings.residual_decay_h);
    const Horizontal turned = std::exp(-inertia * lead_h);
    const double drift = settings.interior_drift_m_s * settings.interior_drift_m_s *
                         -std::expm1(-2.0 * lead_h / settings.drift_time_h);
    const bool may_blow = calibration.wind_used && !result.has_wind[t];
    for (std::size_t k = 0; k < depths; ++k) {
      const std::size_t at = t * depths + k;
      result.carried_m_s[at] = bias_left * carried.bias_m_s[k] +
                               turned * carried.oscillation_m_s[k] +
                               recent_left * carried.recent_m_s[k];
      result.mean_m_s[at] += result.carried_m_s[at];
      const double unknown_wind =
          may_blow ? settings.unknown_stress_pa * std::abs(responses.stress(k)) : 0.0;
      const double misfit = carried.misfit_sigma_m_s[k];
      result.sigma_m_s[at] = std::sqrt(variance.at(k, stress_pa[t]) + misfit * misfit + drift +
                                       unknown_wind * unknown_wind);
    }
  }
  return result;
}

}  // namespace slackwater::calibration

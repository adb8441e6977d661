#include "calibration/propagate/propagate.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "calibration/propagate/carried_residual.h"
#include "calibration/propagate/inertial_memory.h"
#include "calibration/propagate/transient_column.h"
#include "calibration/residuals/level_velocity.h"
#include "fields/current/coriolis.h"
#include "fields/current/stress_series.h"

namespace slackwater::calibration {
namespace {

/// Variance of one component (mean of the two) that the parameters' covariance gives the model. The
/// interior enters with a share: a level that knows its own mean over D has the doubt about it in
/// its memory, and there without what inertial motion adds to the misfit of a steady fit.
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

  [[nodiscard]] double at(std::size_t depth, Horizontal stress_pa, double share_of_interior) const {
    double value[2];
    double jacobian[2 * parameter_count];
    level_velocity_residual({{}, stress_pa, depth}, response_[depth], estimate_.data(), count_,
                            stress_factor_, 1.0, value, jacobian);
    for (const std::size_t i : {interior_east, interior_north}) {
      jacobian[i] *= share_of_interior;
      jacobian[count_ + i] *= share_of_interior;
    }
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

std::vector<double> levels_of(const VectorColumn& column) {
  return column.levels_m.empty() ? std::vector<double>{0.0} : column.levels_m;
}

/// The residual of D less what the unsteady column explains of it.
VectorColumn without(const TransientColumn& transient, VectorColumn residual) {
  std::vector<Horizontal> velocity(residual.levels());
  for (std::size_t t = 0; t < residual.times(); ++t) {
    transient.velocities(residual.time[t], velocity);
    for (std::size_t k = 0; k < velocity.size(); ++k)
      residual.value[residual.offset(t, k)] -= velocity[k];
  }
  return residual;
}

/// The sea's memory for one decay of inertial motion.
struct SeaMemory {
  TransientColumn transient;
  CarriedResidual carried;
};

/// The memory whose decay leaves least of D's residual unexplained.
SeaMemory remember(const Calibration& calibration, const LevelResponses& responses,
                   const StressSeries& series, UtcTime end_of_day, double last_lead_h,
                   const PropagationSettings& settings) {
  expects(!settings.inertial_decays_h.empty(), "inertial motion decays");
  const HourlyStress hourly =
      HourlyStress::sample(series, end_of_day, 24.0 + settings.stress_history_h, last_lead_h);
  const LevelResponses observed =
      level_responses(calibration.form, steady_parameters(calibration), calibration.latitude,
                      calibration.water_depth_m, levels_of(calibration.residual));
  const double coriolis_rad_h = 3600.0 * coriolis_parameter_rad_s(calibration.latitude);
  // The modes of the finite column hold all of its answer; how deep the open sea's layer is, no
  // parameter of the three-layer form says.
  const bool is_slab = calibration.wind_used && calibration.form == SteadyForm::three_layer &&
                       !is_equatorial(calibration.latitude);
  std::optional<SeaMemory> best;
  for (const double decay_h : settings.inertial_decays_h) {
    const double damping_per_h = 1.0 / decay_h;
    const TransientColumn at_levels(calibration, observed, hourly, damping_per_h);
    const Horizontal lambda_per_h(inertial_damping_per_h(calibration, decay_h), coriolis_rad_h);
    CarriedResidual carried(calibration, without(at_levels, calibration.residual),
                            is_slab ? InertialBasis(end_of_day, lambda_per_h, series, hourly)
                                    : InertialBasis(end_of_day, lambda_per_h),
                            settings);
    if (best && carried.left_over_m2_s2() >= best->carried.left_over_m2_s2()) continue;
    best.emplace(SeaMemory{TransientColumn(calibration, responses, hourly, damping_per_h),
                           std::move(carried)});
  }
  return std::move(*best);
}

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

  double last_lead_h = 0;
  for (const UtcTime time : times)
    last_lead_h = std::max(last_lead_h, hours_between(end_of_day, time));
  const SeaMemory memory =
      remember(calibration, responses, series, end_of_day, last_lead_h, settings);
  const ParameterVariance variance(calibration, depths_m);
  std::vector<Carried> carried(depths);
  std::vector<Horizontal> behind(depths);
  for (std::size_t t = 0; t < times.size(); ++t) {
    const double lead_h = std::max(0.0, hours_between(end_of_day, times[t]));
    const double drift = settings.interior_drift_m_s * settings.interior_drift_m_s *
                         -std::expm1(-2.0 * lead_h / settings.drift_time_h);
    const bool may_blow = calibration.wind_used && !result.has_wind[t];
    memory.carried.at(times[t], depths_m, carried);
    memory.transient.velocities(TimeCell::instant(times[t]), behind);
    for (std::size_t k = 0; k < depths; ++k) {
      const std::size_t at = t * depths + k;
      result.wind_driven_m_s[at] += behind[k];
      result.carried_m_s[at] = carried[k].mean_m_s;
      result.mean_m_s[at] += behind[k] + carried[k].mean_m_s;
      const double unknown_wind =
          may_blow ? settings.unknown_stress_pa * std::abs(responses.stress(k)) : 0.0;
      result.sigma_m_s[at] =
          std::sqrt(variance.at(k, stress_pa[t], carried[k].interior_doubt) +
                    carried[k].variance_m2_s2 + drift + unknown_wind * unknown_wind);
    }
  }
  return result;
}

}  // namespace slackwater::calibration

#include "calibration/propagate/carried_residual.h"

#include <algorithm>
#include <cmath>

#include "calibration/propagate/inertial_memory.h"
#include "fields/current/coriolis.h"

namespace slackwater::calibration {
namespace {

/// Linear between the nodes (ascending), held beyond them.
template <typename T>
T at_depth(const std::vector<double>& node_m, const std::vector<T>& value, double depth_m) {
  const auto after = std::lower_bound(node_m.begin(), node_m.end(), depth_m);
  if (after == node_m.begin()) return value.front();
  if (after == node_m.end()) return value.back();
  const auto i = static_cast<std::size_t>(after - node_m.begin());
  const double weight = (depth_m - node_m[i - 1]) / (node_m[i] - node_m[i - 1]);
  return (1.0 - weight) * value[i - 1] + weight * value[i];
}

/// The end of the last cell that holds a residual and does not reach past the end of D.
std::optional<UtcTime> last_residual(const VectorColumn& residual, UtcTime end_of_day) {
  for (std::size_t t = residual.times(); t-- > 0;) {
    if (residual.time[t].end > end_of_day) continue;
    for (std::size_t k = 0; k < residual.levels(); ++k) {
      if (residual.has(t, k)) return residual.time[t].end;
    }
  }
  return std::nullopt;
}

}  // namespace

CarriedResidual carried_residual(const Calibration& calibration, std::span<const double> depths_m,
                                 UtcTime end_of_day, const PropagationSettings& settings) {
  const VectorColumn& residual = calibration.residual;
  expects(!calibration.misfit.empty(), "a calibration has a misfit at one depth at least");
  const std::optional<UtcTime> last = last_residual(residual, end_of_day);
  const double damping_per_h = inertial_damping_per_h(calibration, settings.inertial_decay_h);
  const double coriolis_rad_h = 3600.0 * coriolis_parameter_rad_s(calibration.latitude);
  const bool turns = settings.inertial_prior_observations && !is_equatorial(calibration.latitude);

  std::vector<double> node_m;
  std::vector<Horizontal> bias;
  std::vector<Horizontal> oscillation;
  std::vector<Horizontal> recent;
  std::vector<double> sigma;
  auto level = calibration.misfit.begin();
  for (std::size_t k = 0; k < residual.levels() && level != calibration.misfit.end(); ++k) {
    const double depth_m = residual.levels_m.empty() ? 0.0 : residual.levels_m[k];
    if (depth_m != level->depth_m) continue;  // a level without observations
    InertialMemory memory{{level->bias_east_m_s, level->bias_north_m_s}, {}};
    if (turns) {
      memory = fit_inertial_memory(residual, k, end_of_day, damping_per_h, coriolis_rad_h,
                                   *settings.inertial_prior_observations)
                   .value_or(memory);
    }
    Horizontal sum{};
    double n = 0;
    for (std::size_t t = 0; last && t < residual.times(); ++t) {
      if (!residual.has(t, k)) continue;
      const UtcTime end = residual.time[t].end;
      if (end > *last || hours_between(end, *last) >= settings.recent_h) continue;
      const double lead_h = hours_between(end_of_day, residual.time[t].centre());
      sum += residual.value[residual.offset(t, k)] - memory.constant_m_s -
             memory.oscillation_at(lead_h, damping_per_h, coriolis_rad_h);
      n += 1;
    }
    node_m.push_back(depth_m);
    bias.push_back(memory.constant_m_s);
    oscillation.push_back(memory.oscillation_m_s);
    recent.push_back(n > 0 ? sum / n : Horizontal{});
    sigma.push_back(level->rms_m_s / std::sqrt(2.0));
    ++level;
  }

  CarriedResidual carried;
  carried.age_h = last ? std::max(0.0, hours_between(*last, end_of_day)) : 0.0;
  for (const double depth_m : depths_m) {
    carried.bias_m_s.push_back(at_depth(node_m, bias, depth_m));
    carried.oscillation_m_s.push_back(at_depth(node_m, oscillation, depth_m));
    carried.recent_m_s.push_back(at_depth(node_m, recent, depth_m));
    carried.misfit_sigma_m_s.push_back(at_depth(node_m, sigma, depth_m));
  }
  return carried;
}

}  // namespace slackwater::calibration

#include "calibration/propagate/inertial_memory.h"

#include <cmath>

namespace slackwater::calibration {
namespace {

/// e^{-lambda t} at an instant, or its exact average over a cell; t in hours after the end of D.
Horizontal exponential_over(const TimeCell& cell, UtcTime end_of_day, Horizontal lambda) {
  const double from_h = hours_between(end_of_day, cell.start);
  if (!cell.is_mean()) return std::exp(-lambda * from_h);
  const double to_h = hours_between(end_of_day, cell.end);
  return (std::exp(-lambda * from_h) - std::exp(-lambda * to_h)) / (lambda * (to_h - from_h));
}

}  // namespace

double inertial_damping_per_h(const Calibration& calibration, double decay_h) {
  double damping_per_h = 1.0 / decay_h;
  if (calibration.form == SteadyForm::finite_depth) {
    damping_per_h +=
        3600.0 * steady_parameters(calibration).bottom_friction_m_s / calibration.water_depth_m;
  }
  return damping_per_h;
}

Horizontal InertialMemory::oscillation_at(double lead_h, double damping_per_h,
                                          double coriolis_rad_h) const noexcept {
  return oscillation_m_s * std::exp(-Horizontal(damping_per_h, coriolis_rad_h) * lead_h);
}

std::optional<InertialMemory> fit_inertial_memory(const VectorColumn& residual, std::size_t level,
                                                  UtcTime end_of_day, double damping_per_h,
                                                  double coriolis_rad_h,
                                                  double prior_observations) {
  const Horizontal lambda(damping_per_h, coriolis_rad_h);
  // Normal equations of two complex unknowns.
  double n = 0;
  Horizontal sum_e{};
  double sum_ee = 0;
  Horizontal sum_r{};
  Horizontal sum_er{};
  for (std::size_t t = 0; t < residual.times(); ++t) {
    if (!residual.has(t, level) || residual.time[t].end > end_of_day) continue;
    const Horizontal e = exponential_over(residual.time[t], end_of_day, lambda);
    const Horizontal r = residual.value[residual.offset(t, level)];
    n += 1;
    sum_e += e;
    sum_ee += std::norm(e);
    sum_r += r;
    sum_er += std::conj(e) * r;
  }
  if (n == 0) return std::nullopt;
  // b = (sum_r - c sum_e)/n; what is left for c after the constant has had its share.
  const double own = sum_ee - std::norm(sum_e) / n;
  const Horizontal left = sum_er - std::conj(sum_e) * sum_r / n;
  InertialMemory memory;
  if (own + prior_observations > 0) memory.oscillation_m_s = left / (own + prior_observations);
  memory.constant_m_s = (sum_r - memory.oscillation_m_s * sum_e) / n;
  return memory;
}

}  // namespace slackwater::calibration

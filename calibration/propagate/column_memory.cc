#include "calibration/propagate/column_memory.h"

#include <algorithm>
#include <cmath>

#include "fields/current/coriolis.h"

namespace slackwater::calibration {

namespace {

/// Rate at which free inertial motion dies out, 1/h: that of the mixed layer (e-folding `decay_h`),
/// and where the column feels the bed (finite_depth) the spin-down r/H of its linear drag beside
/// it: 20 h in 35 m of water.
double inertial_damping_per_h(const Calibration& calibration, double decay_h) {
  double damping_per_h = 1.0 / decay_h;
  if (calibration.form == SteadyForm::finite_depth && calibration.layout.has_shape) {
    damping_per_h +=
        3600.0 * steady_parameters(calibration).bottom_friction_m_s / calibration.water_depth_m;
  }
  return damping_per_h;
}

/// The memory's part of a line: the root mean square over the levels, each in units of its own
/// amplitude.
void set_line(const Calibration& c, MemoryKernel& kernel) {
  if (!c.near_inertial) return;
  const std::vector<double>& modulus = c.near_inertial->modulus_m_s;
  double squares = 0;
  for (std::size_t k = 0; k < modulus.size(); ++k) {
    const double depth_m = k < c.remembered.levels_m.size() ? c.remembered.levels_m[k] : 0.0;
    squares += std::pow(modulus[k] / kernel.amplitude_at(depth_m), 2);
  }
  kernel.line_m_s = std::sqrt(squares / static_cast<double>(modulus.size()));
  kernel.line_rad_h = 3600.0 * c.near_inertial->speed_rad_s;
}

}  // namespace

ColumnMemory::ColumnMemory(const Calibration& c, UtcTime end_of_day, const Spread& spread) {
  const double coriolis_rad_h = 3600.0 * coriolis_parameter_rad_s(c.latitude);
  const double damping_per_h = inertial_damping_per_h(c, spread.inertial_decay_h);
  std::size_t levels = 0;
  for (const MisfitAtDepth& m : c.misfit) levels += m.n > 0 ? 1 : 0;
  const double witnesses = std::min(
      1.0, spread.independent_levels / static_cast<double>(std::max<std::size_t>(1, levels)));
  std::vector<double> log_weight;
  for (const double slow : spread.slow_scales) {
    for (const double recent : spread.recent_scales) {
      for (const double inertial : spread.inertial_scales) {
        MemoryKernel kernel = spread.memory;
        kernel.slow_m_s *= slow;
        kernel.recent_m_s *= recent;
        kernel.inertial_m_s *= inertial;
        set_line(c, kernel);
        memory_.emplace_back(c.remembered, c.wind_driven_m_s, end_of_day, damping_per_h,
                             coriolis_rad_h, kernel, c.noise_m_s);
        log_weight.push_back(witnesses * memory_.back().log_evidence());
      }
    }
  }
  const double best = *std::max_element(log_weight.begin(), log_weight.end());
  double sum = 0;
  for (const double w : log_weight) {
    // A kernel of less than a hundredth would move nothing.
    weight_.push_back(w - best < std::log(0.01) ? 0.0 : std::exp(w - best));
    sum += weight_.back();
  }
  for (double& w : weight_) w /= sum;
}

void ColumnMemory::predict(std::span<const UtcTime> times, std::span<const Horizontal> driven,
                           std::vector<Horizontal>& mean, std::vector<double>& variance) const {
  std::vector<Horizontal> one(mean.size());
  std::vector<double> spread(mean.size());
  std::vector<double> square(mean.size());
  for (std::size_t m = 0; m < memory_.size(); ++m) {
    if (weight_[m] <= 0) continue;
    memory_[m].predict(times, driven, one, spread);
    for (std::size_t i = 0; i < mean.size(); ++i) {
      mean[i] += weight_[m] * one[i];
      square[i] += 0.5 * weight_[m] * std::norm(one[i]);
      variance[i] += weight_[m] * spread[i];
    }
  }
  for (std::size_t i = 0; i < mean.size(); ++i)
    variance[i] += std::max(0.0, square[i] - 0.5 * std::norm(mean[i]));
}

const GaussianMemory& ColumnMemory::likeliest() const {
  return memory_[static_cast<std::size_t>(std::max_element(weight_.begin(), weight_.end()) -
                                          weight_.begin())];
}

}  // namespace slackwater::calibration

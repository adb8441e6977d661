#include "calibration/propagate/inertial_memory.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::calibration {
namespace {

/// e^{-lambda t} at an instant, or its exact mean over a cell; t in hours after the end of D.
Horizontal exponential_over(const TimeCell& cell, UtcTime end_of_day, Horizontal lambda) {
  const double from_h = hours_between(end_of_day, cell.start);
  if (!cell.is_mean()) return std::exp(-lambda * from_h);
  const double to_h = hours_between(end_of_day, cell.end);
  return (std::exp(-lambda * from_h) - std::exp(-lambda * to_h)) / (lambda * (to_h - from_h));
}

/// The values of one level and the functions that may explain them.
struct LevelDay {
  std::vector<Eigen::Vector3cd> rows;
  std::vector<Horizontal> values;
  double hours = 0;  ///< from the first value to the end of D
};

LevelDay level_day(const VectorColumn& residual, std::size_t level, const InertialBasis& basis) {
  LevelDay day;
  for (std::size_t t = 0; t < residual.times(); ++t) {
    if (!residual.has(t, level) || residual.time[t].end > basis.end_of_day()) continue;
    if (day.values.empty()) day.hours = hours_between(residual.time[t].start, basis.end_of_day());
    day.rows.push_back(basis.over(residual.time[t]));
    day.values.push_back(residual.value[residual.offset(t, level)]);
  }
  return day;
}

/// Nothing but the mean; the doubt about it stays with the parameters of the steady fit.
InertialMemory mean_of(const LevelDay& day) {
  InertialMemory memory;
  double squares = 0;
  for (const Horizontal value : day.values) {
    memory.coefficients(0) += value;
    squares += std::norm(value);
  }
  const auto n = static_cast<double>(day.values.size());
  memory.coefficients(0) /= n;
  memory.left_over_m_s = std::sqrt(squares / (2.0 * n));
  return memory;
}

InertialMemory ridge(const LevelDay& day, const MemoryPrior& prior, double noise_m_s) {
  const auto n = static_cast<double>(day.values.size());
  const double independent = std::clamp(day.hours / prior.unexplained_memory_h, 1.0, n);
  Eigen::Matrix3cd normal = Eigen::Matrix3cd::Zero();
  Eigen::Vector3cd right = Eigen::Vector3cd::Zero();
  for (std::size_t i = 0; i < day.values.size(); ++i) {
    normal += day.rows[i].conjugate() * day.rows[i].transpose();
    right += day.rows[i].conjugate() * day.values[i];
  }
  normal *= independent / n;
  right *= independent / n;
  const auto penalty = [&](double sigma) { return noise_m_s / sigma * (noise_m_s / sigma); };
  normal(1, 1) += penalty(prior.slab_share);
  normal(2, 2) += penalty(prior.oscillation_m_s);

  InertialMemory memory;
  memory.has_motion = true;
  const Eigen::Matrix3cd inverse = normal.inverse();
  memory.coefficients = inverse * right;
  double squares = 0;
  for (std::size_t i = 0; i < day.values.size(); ++i)
    squares += std::norm(day.values[i] - memory.at(day.rows[i]));
  memory.left_over_m_s = std::sqrt(squares / (2.0 * n));
  memory.covariance = 2.0 * noise_m_s * noise_m_s * inverse;
  return memory;
}

}  // namespace

InertialBasis::InertialBasis(UtcTime end_of_day, Horizontal lambda_per_h)
    : end_of_day_(end_of_day), lambda_per_h_(lambda_per_h) {}

InertialBasis::InertialBasis(UtcTime end_of_day, Horizontal lambda_per_h, StressSeries series,
                             const HourlyStress& hourly)
    : end_of_day_(end_of_day),
      lambda_per_h_(lambda_per_h),
      series_(std::move(series)),
      memory_(StressMemory(hourly, lambda_per_h)) {}

Eigen::Vector3cd InertialBasis::over(const TimeCell& cell) const {
  Horizontal slab{};
  if (memory_) {
    const Horizontal per_pa =
        3600.0 / (constants::sea_water_density_kg_m3 * slab_depth_m * lambda_per_h_);
    slab = per_pa * (series_.over(cell).value_or(Horizontal{}) - memory_->over(cell));
  }
  return {1.0, slab, exponential_over(cell, end_of_day_, lambda_per_h_)};
}

double inertial_damping_per_h(const Calibration& calibration, double decay_h) {
  double damping_per_h = 1.0 / decay_h;
  if (calibration.form == SteadyForm::finite_depth) {
    damping_per_h +=
        3600.0 * steady_parameters(calibration).bottom_friction_m_s / calibration.water_depth_m;
  }
  return damping_per_h;
}

std::optional<InertialMemory> fit_inertial_memory(const VectorColumn& residual, std::size_t level,
                                                  const InertialBasis& basis,
                                                  const MemoryPrior& prior) {
  const LevelDay day = level_day(residual, level, basis);
  if (day.values.empty()) return std::nullopt;
  if (day.values.size() < least_values_of_a_motion) return mean_of(day);
  InertialMemory memory = ridge(day, prior, prior.unexplained_m_s);
  for (int i = 0; i < 3 && memory.left_over_m_s > prior.unexplained_m_s; ++i)
    memory = ridge(day, prior, memory.left_over_m_s);
  return memory;
}

}  // namespace slackwater::calibration

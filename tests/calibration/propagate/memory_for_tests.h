#pragma once
#include <cmath>

#include "calibration/propagate/gaussian_memory.h"

// Columns, kernels and forecasts that the tests of the memory share.

namespace slackwater::calibration {

inline constexpr UtcTime end_of_day{std::chrono::hours(24)};
inline constexpr double damping_per_h = 1.0 / 48;
inline constexpr double coriolis_rad_h = 0.39;
inline const Horizontal i_unit{0, 1};

inline UtcTime lead(double hour) { return add_hours(end_of_day, hour); }

/// A column at instants (hours after the end of D), without values yet.
inline VectorColumn column(const std::vector<double>& hour, const std::vector<double>& depth_m) {
  VectorColumn out;
  out.levels_m = depth_m;
  for (const double h : hour) out.time.push_back(TimeCell::instant(lead(h)));
  out.value.resize(hour.size() * depth_m.size());
  out.status.assign(out.value.size(), SampleStatus::ok);
  out.source.assign(hour.size(), DataStatus::analysis);
  return out;
}

inline std::vector<double> hourly(int from, int to) {
  std::vector<double> hour;
  for (int h = from; h <= to; ++h) hour.push_back(h);
  return hour;
}

inline std::vector<UtcTime> times(const std::vector<double>& hour) {
  std::vector<UtcTime> out;
  for (const double h : hour) out.push_back(lead(h));
  return out;
}

inline std::vector<Horizontal> random_vectors(std::size_t n, double size, Rng& random) {
  std::vector<Horizontal> out(n);
  for (Horizontal& value : out) value = {size * random.normal(), size * random.normal()};
  return out;
}

inline std::vector<Horizontal> times_factor(std::vector<Horizontal> values, Horizontal factor) {
  for (Horizontal& value : values) value *= factor;
  return values;
}

inline std::vector<Horizontal> conjugates(std::vector<Horizontal> values) {
  for (Horizontal& value : values) value = std::conj(value);
  return values;
}

struct Forecast {
  std::vector<Horizontal> mean;
  std::vector<double> variance;
};

inline Forecast forecast(const GaussianMemory& memory, const std::vector<double>& hour,
                         const std::vector<Horizontal>& answer) {
  Forecast out{std::vector<Horizontal>(answer.size()), std::vector<double>(answer.size())};
  memory.predict(times(hour), answer, out.mean, out.variance);
  return out;
}

/// The same at all depths, and sure of its own amplitudes.
inline MemoryKernel plain() {
  MemoryKernel kernel;
  kernel.deep_share = 1;
  kernel.surprise_weight = 0;
  return kernel;
}

inline MemoryKernel only_inertial() {
  MemoryKernel kernel = plain();
  kernel.constant_m_s = kernel.slow_m_s = kernel.recent_m_s = kernel.own_share = 0;
  return kernel;
}

}  // namespace slackwater::calibration

#include "calibration/propagate/memory_kernel.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/numbers/square.h"

namespace slackwater::calibration {
namespace {

/// k(d) = e^{-mu d} for d >= 0, and k(-d) = conj k(d).
Horizontal decay(double lag_h, Horizontal mu_per_h) {
  const Horizontal value = std::exp(-mu_per_h * std::abs(lag_h));
  return lag_h < 0 ? std::conj(value) : value;
}

/// Integral of k from 0 to d; odd but for the conjugate.
Horizontal integral(double lag_h, Horizontal mu_per_h) {
  const Horizontal value = (1.0 - std::exp(-mu_per_h * std::abs(lag_h))) / mu_per_h;
  return lag_h < 0 ? -std::conj(value) : value;
}

/// Integral of that from 0 to d; even but for the conjugate.
Horizontal double_integral(double lag_h, Horizontal mu_per_h) {
  const double d = std::abs(lag_h);
  const Horizontal value = (d - integral(d, mu_per_h)) / mu_per_h;
  return lag_h < 0 ? std::conj(value) : value;
}

/// Mean of k(t - t') over t in a and t' in b.
Horizontal mean_decay(const HourCell& a, const HourCell& b, Horizontal mu_per_h) {
  const auto once = [&](double lag_h) { return integral(lag_h, mu_per_h); };
  const auto twice = [&](double lag_h) { return double_integral(lag_h, mu_per_h); };
  if (a.is_instant() && b.is_instant()) return decay(a.from_h - b.from_h, mu_per_h);
  if (b.is_instant()) return (once(a.to_h - b.to_h) - once(a.from_h - b.to_h)) / a.length_h();
  if (a.is_instant()) return (once(a.to_h - b.from_h) - once(a.to_h - b.to_h)) / b.length_h();
  return (twice(a.to_h - b.from_h) - twice(a.from_h - b.from_h) - twice(a.to_h - b.to_h) +
          twice(a.from_h - b.to_h)) /
         (a.length_h() * b.length_h());
}

}  // namespace

double MemoryKernel::amplitude_at(double depth_m) const noexcept {
  return deep_share + (1.0 - deep_share) * std::exp(-std::max(depth_m, 0.0) / fading_depth_m);
}

HourCell HourCell::of(const TimeCell& cell, UtcTime end_of_day) noexcept {
  if (hours_between(cell.start, cell.end) <= longest_at_centre_h)
    return at(hours_between(end_of_day, cell.centre()));
  return {hours_between(end_of_day, cell.start), hours_between(end_of_day, cell.end)};
}

MemoryCovariance::MemoryCovariance(const MemoryKernel& kernel, double inertial_damping_per_h,
                                   double coriolis_rad_h)
    : kernel_(kernel),
      inertial_per_h_(inertial_damping_per_h, coriolis_rad_h),
      line_per_h_(0.0, -kernel.line_rad_h) {
  expects(inertial_damping_per_h > 0, "inertial motion decays");
  expects(kernel.line_m_s == 0 || kernel.line_rad_h != 0, "a line turns");
  expects(kernel.slow_h > 0 && kernel.recent_h > 0, "the memory's times are positive");
  // Without noise a motion of four terms cannot have made 24 values, and no fit exists.
  expects(kernel.noise_m_s > 0, "a value has noise");
  expects(kernel.vertical_scale_m > 0 && kernel.fading_depth_m > 0, "scales of depth are positive");
  expects(kernel.deep_share > 0 && kernel.deep_share <= 1, "the amplitudes fade, not to nothing");
  expects(kernel.surprise_weight >= 0, "a weight is not negative");
}

Horizontal MemoryCovariance::between(const HourCell& a, const HourCell& b) const {
  const double slow_m2_s2 = square(kernel_.slow_m_s);
  const double recent_m2_s2 = square(kernel_.recent_m_s);
  const double inertial_m2_s2 = square(kernel_.inertial_m_s);
  const Horizontal line = kernel_.line_m_s == 0
                              ? Horizontal{}
                              : square(kernel_.line_m_s) * mean_decay(a, b, line_per_h_);
  if (a.is_instant() && b.is_instant()) {  // the same as below, with real exponentials
    const double lag_h = a.from_h - b.from_h;
    const double apart_h = std::abs(lag_h);
    return square(kernel_.constant_m_s) + slow_m2_s2 * std::exp(-apart_h / kernel_.slow_h) +
           recent_m2_s2 * std::exp(-apart_h / kernel_.recent_h) +
           inertial_m2_s2 * decay(lag_h, inertial_per_h_) + line;
  }
  return square(kernel_.constant_m_s) + slow_m2_s2 * mean_decay(a, b, 1.0 / kernel_.slow_h) +
         recent_m2_s2 * mean_decay(a, b, 1.0 / kernel_.recent_h) +
         inertial_m2_s2 * mean_decay(a, b, inertial_per_h_) + line;
}

Eigen::MatrixXcd MemoryCovariance::between(std::span<const HourCell> a,
                                           std::span<const HourCell> b) const {
  Eigen::MatrixXcd covariance(static_cast<Eigen::Index>(a.size()),
                              static_cast<Eigen::Index>(b.size()));
  for (Eigen::Index j = 0; j < covariance.cols(); ++j) {
    for (Eigen::Index i = 0; i < covariance.rows(); ++i)
      covariance(i, j) = between(a[static_cast<std::size_t>(i)], b[static_cast<std::size_t>(j)]);
  }
  return covariance;
}

double MemoryCovariance::variance_m2_s2() const noexcept {
  return square(kernel_.constant_m_s) + square(kernel_.slow_m_s) + square(kernel_.inertial_m_s) +
         square(kernel_.recent_m_s) + square(kernel_.line_m_s);
}

}  // namespace slackwater::calibration

#pragma once
#include <Eigen/Core>
#include <span>

#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::calibration {

/// What is believed, before its day is seen, of the current at one level beside the tide and the
/// answer to the wind: a Gaussian process in time, the sum of independent terms of mean zero.
///
/// Standard deviations are of the VECTOR (root of the mean |W|^2, W = east + i north): a component
/// has 1/sqrt(2) of each. Covariance of a term at the lag d = t - t', hours:
///
///   constant  A^2                      slow    a^2 e^{-|d|/t_a}      recent  q^2 e^{-|d|/t_q}
///   inertial  c^2 e^{-r|d| - i f d}    own share  b^2 S(t) conj S(t')     noise  n^2 where t = t'
///
/// S is the answer of the level to the wind, as calibrated; r and f are of the place.
struct MemoryKernel {
  double constant_m_s = 0.30;
  double slow_m_s = 0.06;
  double slow_h = 96.0;
  double inertial_m_s = 0.10;
  double recent_m_s = 0.03;
  double recent_h = 18.0;
  double own_share = 0.25;
  double noise_m_s = 0.004;
  /// e-folding distance of the correlation between the departures of two levels, for members.
  double vertical_scale_m = 30.0;
};

/// When a value of a column holds, hours after the end of D. A mean over up to three hours stands at
/// its centre: over them an inertial motion of 14 h period loses 7 % of its height and none of its
/// phase. A longer one is averaged exactly.
struct HourCell {
  double from_h = 0;
  double to_h = 0;

  static constexpr double longest_at_centre_h = 3.0;

  [[nodiscard]] static HourCell at(double hour) noexcept { return {hour, hour}; }
  [[nodiscard]] static HourCell of(const TimeCell& cell, UtcTime end_of_day) noexcept;
  [[nodiscard]] bool is_instant() const noexcept { return from_h == to_h; }
  [[nodiscard]] double length_h() const noexcept { return to_h - from_h; }
};

/// The covariance of constant, slow, inertial and recent: what does not depend on the wind.
/// Stationary: a function of the lag; conj(K(t, t')) = K(t', t).
class MemoryCovariance {
 public:
  /// @param inertial_damping_per_h  r > 0
  /// @param coriolis_rad_h          f, positive in the north
  MemoryCovariance(const MemoryKernel& kernel, double inertial_damping_per_h,
                   double coriolis_rad_h);

  /// Between the vectors of two cells, m^2/s^2; exact for means.
  [[nodiscard]] Horizontal between(const HourCell& a, const HourCell& b) const;
  /// Rows a, columns b.
  [[nodiscard]] Eigen::MatrixXcd between(std::span<const HourCell> a,
                                         std::span<const HourCell> b) const;
  /// Of an instant with itself.
  [[nodiscard]] double variance_m2_s2() const noexcept;

 private:
  MemoryKernel kernel_;
  Horizontal inertial_per_h_;  ///< lambda = r + i f
};

}  // namespace slackwater::calibration

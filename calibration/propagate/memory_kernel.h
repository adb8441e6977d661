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
///   line      l^2 e^{i w d}            a tide that the record could not tell from inertial motion
///
/// S is the answer of the level to the wind, as calibrated; r and f are of the place. All
/// amplitudes but the own share fade with depth, and all grow with the surprise of the day:
///
///   times s(z) = s_d + (1 - s_d) e^{-z/Z}       and       kappa^2 = (1 + w chi^2)/(1 + w)
///
/// with chi^2 the day's own values under the kernel, per value and over all levels, 1 to be
/// expected. kappa is common to a column, and does not change a mean.
///
/// One set of figures for all places: round numbers near those that make D+1 likeliest on regional
/// analyses of Biscay, the Tyrrhenian Sea and the Strait of Otranto (8 pairs of days, the wind as
/// analysed, the three seas weighing the same). The optimum is flat: a quarter more or less of any
/// one figure moves the error of the mean by 2 % at most and its CRPS by 4 %.
struct MemoryKernel {
  /// Interior flow of the day and its shear: anything that occurs. Twice or half of it moves the
  /// error by 2 % at most.
  double constant_m_s = 0.40;
  /// Mesoscale change. At a fixed place it keeps its sense for about five days (Eulerian time scale
  /// of shelf currents, Davis 1985, J. Geophys. Res. 90, 4741): 0.06 m/s in the first day.
  double slow_m_s = 0.10;
  double slow_h = 120.0;
  /// Free inertial oscillation that neither tide nor wind explains. After a storm there is 0.1 to
  /// 0.3 m/s (D'Asaro 1985, J. Phys. Oceanogr. 15, 1043), most of it the wind's and counted there.
  double inertial_m_s = 0.08;
  /// A line that the harmonic tide has left to the memory, rotary, and its speed w in rad per hour,
  /// counter-clockwise positive: it keeps its phase, inertial motion loses it. As large as the
  /// whole record has it; what D shows near the inertial frequency is shared out between the two by
  /// their variances, and by the turn of phase within D where they are that far apart.
  double line_m_s = 0;
  double line_rad_h = 0;
  /// What the last hours know and the next day forgets: fronts, eddies smaller than the mesoscale.
  double recent_m_s = 0.02;
  double recent_h = 24.0;
  /// The answer of a level may be too strong or too weak by 0.4 of itself, or turned by 0.4 rad:
  /// drag laws and wind products differ by some tens of percent, viscosity turns the spiral.
  double own_share = 0.4;
  /// Of a value about the motion it stands for: representation and packing of an analysis.
  double noise_m_s = 0.004;
  /// s_d and Z: what a day leaves open of the next is strongest at the surface. Errors at 0, 10, 30
  /// and 120 m: 0.07, 0.04, 0.025, 0.01 m/s off Elba; 0.085, 0.08, 0.065, 0.025 at Otranto.
  double deep_share = 0.25;
  double fading_depth_m = 40.0;
  /// w: what the day tells of how rough its sea is, against what is believed of all seas. On the
  /// three regional analyses it matters little; on 30 days of a current meter off Washington (45 m,
  /// no wind), whose errors are thrice theirs, the 80 % band holds 77 % of the values; with w = 0,
  /// 31 %.
  double surprise_weight = 0.5;
  /// e-folding distance in depth of the correlation between what two levels depart from the
  /// forecast, for members. Measured on the same pairs: 0.9 at 5 m, 0.6 at 20 to 30 m, 0.3 at 60 m
  /// (Biscay, 24 levels); 0.9, 0.6 and 0.3 at 10, 20 and 90 m (Otranto, 4 levels); Elba's 4 levels
  /// scatter.
  double vertical_scale_m = 40.0;

  /// s(z), 1 at the surface.
  [[nodiscard]] double amplitude_at(double depth_m) const noexcept;
};

/// When a value of a column holds, hours after the end of D. A mean over up to three hours stands
/// at its centre: over them an inertial motion of 14 h period loses 7 % of its height and none of
/// its phase. A longer one is averaged exactly.
struct HourCell {
  double from_h = 0;
  double to_h = 0;

  static constexpr double longest_at_centre_h = 3.0;

  [[nodiscard]] static HourCell at(double hour) noexcept { return {hour, hour}; }
  [[nodiscard]] static HourCell of(const TimeCell& cell, UtcTime end_of_day) noexcept;
  [[nodiscard]] bool is_instant() const noexcept { return from_h == to_h; }
  [[nodiscard]] double length_h() const noexcept { return to_h - from_h; }
};

/// The covariance of constant, slow, inertial, line and recent: what does not depend on the wind.
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
  Horizontal line_per_h_;      ///< -i w
};

}  // namespace slackwater::calibration

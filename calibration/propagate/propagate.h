#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// How yesterday's knowledge ages.
struct PropagationSettings {
  /// The free inertial oscillation in the residual of D (inertial_memory.h) turns with f and decays
  /// with this e-folding time: two days, the middle of the damping times of mixed-layer inertial
  /// motion (1 to 4 days; D'Asaro 1985, J. Phys. Oceanogr. 15, 1043). Bed drag damps it further.
  double inertial_decay_h = 48.0;
  /// What the prior "no oscillation" is worth, in observations; nothing: no oscillation is carried.
  std::optional<double> inertial_prior_observations = 1.0;
  /// E-folding time of what the last hours of D showed beyond the day's mean misfit. Half a
  /// mid-latitude inertial period is 7 to 9 h, after which such a residual has turned against
  /// itself: a longer memory of the bare vector would carry it with the wrong sign, a shorter one
  /// would waste the first hours.
  double residual_decay_h = 12.0;
  /// E-folding time of the day's mean misfit of each depth: the vertical shear of the interior,
  /// which the steady model does not have. Mesoscale flow at a fixed place keeps its sense for
  /// about five days (Eulerian time scale of shelf currents, Davis 1985, J. Geophys. Res. 90,
  /// 4741).
  double bias_decay_h = 120.0;
  /// How far back from the last residual of D "the last hours" reach.
  double recent_h = 3.0;
  /// Standard deviation, per component, by which the interior leaves its value of D, and the time
  /// of the approach. The error of a day's mean as a forecast of the next day, less that of the
  /// next day's own mean, is 0.04 to 0.06 m/s per component on regional products of the Adriatic,
  /// the Tyrrhenian Sea and Biscay.
  double interior_drift_m_s = 0.05;
  double drift_time_h = 24.0;
  /// Stress that may be blowing where the wind is missing, Pa, per component: that of a wind of 7.5
  /// m/s.
  double unknown_stress_pa = 0.1;
};

/// The current after D. Arrays over times x depths, depth fastest, unless said.
struct Propagated {
  std::vector<Horizontal> mean_m_s;         ///< Eulerian, towards
  std::vector<double> sigma_m_s;            ///< standard deviation of each component
  std::vector<Horizontal> wind_driven_m_s;  ///< the part of the mean that today's wind makes
  std::vector<Horizontal> carried_m_s;      ///< the part of the mean that the residual of D makes
  std::vector<bool> has_wind;               ///< per time: the wind-driven part is in the mean
  std::size_t wind_missing = 0;  ///< times at which the model wants a wind and there is none
};

/// Carries a calibrated day forward: the same forward model with the wind of the asked times, plus
/// the residual of D decaying.
///
///   mean(z, lead) = W_interior A + T(t) B + b(z) e^{-lead/tau_b} + c(z) e^{-(1/tau_i + i f) lead}
///                   + r(z) e^{-(lead + age)/tau_r}
///   sigma^2       = J C J^T + m(z)^2 + drift^2 (1 - e^{-2 lead/tau_d})
///
/// with b the constant and c the inertial part of D's residual at that depth (inertial_memory.h), r
/// the mean of what they leave over in its last `recent_h` hours (counted back
/// from the last value, whose age at the end of D is `age`), C the posterior covariance, J the
/// model's Jacobian and m the misfit's standard deviation per component. At lead 0 sigma is
/// therefore not below the misfit. Between the levels of D b, r and m are linear in depth; beyond
/// the outermost they hold.
///
/// A time before the end of D has lead 0. Where the calibration used a wind and the time has none,
/// the mean is the interior alone, `has_wind` is false and sigma holds the wind that may blow. A
/// calibration without wind ignores the wind given here: its interior already holds what the wind
/// made.
///
/// @param times       instants, any order
/// @param depths_m    positive down, >= 0
/// @param wind        10 m, towards; empty: missing at all times
/// @param end_of_day  24:00 of D, where lead is counted from
/// Thread-safe.
[[nodiscard]] Propagated propagate(const Calibration& calibration, std::span<const UtcTime> times,
                                   std::span<const double> depths_m,
                                   const std::optional<VectorColumn>& wind, UtcTime end_of_day,
                                   const PropagationSettings& settings = {});

}  // namespace slackwater::calibration

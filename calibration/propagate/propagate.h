#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "calibration/propagate/inertial_memory.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// How yesterday's knowledge ages.
struct PropagationSettings {
  /// E-folding times of inertial motion, of which the one that leaves least of the residual of D
  /// unexplained is taken, the first where they do equally well: 1 to 4 days are the damping times of
  /// mixed-layer inertial motion (D'Asaro 1985, J. Phys. Oceanogr. 15, 1043). Bed drag damps it
  /// further.
  std::vector<double> inertial_decays_h{48.0, 24.0, 96.0};
  /// What is believed of the memory of a level before its day is seen.
  MemoryPrior memory_prior;
  /// How far back before D the changes of the wind still count: ten e-foldings of the quickest
  /// decay and more than one of the slowest.
  double stress_history_h = 72.0;
  /// E-folding time of what the last hours of D showed beyond the memory: half a mid-latitude
  /// inertial period is 7 to 9 h, after which a motion that the memory has missed has turned
  /// against itself.
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
  std::vector<Horizontal> mean_m_s;  ///< Eulerian, towards
  std::vector<double> sigma_m_s;     ///< standard deviation of each component
  std::vector<Horizontal>
      wind_driven_m_s;  ///< the part of the mean that the wind makes: T B + transient
  std::vector<Horizontal> carried_m_s;  ///< the part of the mean that the residual of D makes
  std::vector<bool> has_wind;           ///< per time: the wind-driven part is in the mean
  std::size_t wind_missing = 0;         ///< times at which the model wants a wind and there is none
};

/// Carries a calibrated day forward: the same forward model with the wind of the asked times, what
/// the unsteady column adds to it, and the memory of the residual of D.
///
///   mean(z, t) = W_interior A + T(t) B + transient(z, t)
///                + b e^{-lead/tau_b} + g s(t) + c e^{-lambda lead} + q e^{-(lead + age)/tau_r}
///   sigma^2    = J C J^T + x^H P x + m^2 + |b|^2/2 (1 - e^{-2 lead/tau_b})
///                + |c|^2/2 (1 - e^{-2 r lead}) + drift^2 (1 - e^{-2 lead/tau_d})
///
/// - transient: the steady answer to the wind of an instant has arrived at once, the sea's has not
///   (transient_column.h). It is 0 under a constant wind: the steady forecast.
/// - b, g, c with covariance P: constant, share of a slab s(t) and free inertial oscillation in the
///   residual of D less the transient, per level (inertial_memory.h); g in the three_layer form only.
///   x their functions of time, lambda = r + i f.
/// - q: mean of what they leave over in the last `recent_h` hours of D (counted back from the last
///   value, whose age at the end of D is `age`); m: the standard deviation of it over D.
/// - C: posterior covariance of the parameters, J the model's Jacobian. A level with values enough
///   for a motion knows its own mean: the doubt about the interior is then that of b, in P.
///
/// What a decay takes out of the mean goes to the spread. At lead 0 sigma is not below m. Between
/// the levels of D the memory is linear in depth, beyond the outermost it holds.
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

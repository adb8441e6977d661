#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "calibration/propagate/ensemble_wind.h"
#include "calibration/propagate/spread.h"
#include "calibration/propagate/wind_error.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// The current after D at the levels of the calibrated column. Arrays over times x levels, level
/// fastest, unless said.
struct Propagated {
  std::vector<Horizontal> mean_m_s;         ///< Eulerian, towards: member 0
  std::vector<double> sigma_m_s;            ///< standard deviation of each component
  std::vector<Horizontal> wind_driven_m_s;  ///< the part of the mean that the wind makes
  /// Departures of members 1..N from the mean, members x times x levels, scaled to sigma.
  std::vector<Horizontal> departure_m_s;
  /// Of the same members, members x times; empty where no wind is used.
  std::vector<Horizontal> wind_departure_m_s;
  /// Of the same members, whose wind they have: the number of a weather ensemble's member. Empty
  /// where none is known.
  std::vector<int> wind_member_number;
  std::vector<bool> has_wind;       ///< per time: the wind-driven part is in the mean
  std::size_t wind_missing = 0;     ///< times at which the model wants a wind and there is none
  std::vector<double> form_weight;  ///< of each form given
};

/// Carries a calibrated day forward: per form
///
///   mean(z, t) = F [T(t) B(z) - sum_n B_n(z) m_n(t)] + memory(z, t)
///
/// the same forward model with the wind of the asked times, and by level what D remembers: interior
/// and its shear, free inertial motion, slow and recent departures, a share of the wind's own
/// answer (gaussian_memory.h), under kernels of several livelinesses (Spread). Kernels are averaged
/// by their evidence on D, forms with their probabilities (`form_weights`); their disagreement
/// goes to the spread.
///
///   sigma^2 = posterior variance of the memory + variance of the wind-driven part, over
///             the first `Spread::set_of_members`, however many are asked for
///             + disagreement of the forms + the wind that may blow where none is known
///
/// Members come in pairs of opposite sign: parameters drawn from the posterior, wind departures
/// from the error of its source (wind_error.h), memory drawn from its posterior covariance in time.
/// They are scaled to sigma at every time and level, set by set: a member is the same whatever
/// their number. Where a weather ensemble is known its members
/// are their winds (ensemble_wind.h), and sigma is the mean square departure of the first set of
/// them from member 0:
/// neither winds nor currents are centred on it, so that each is the answer to its own wind, and a
/// centre that stands off the ensemble's mean is doubted for it.
///
/// Where the calibration used a wind and the time has none, the wind's instantaneous part is left
/// out and `has_wind` is false. A calibration without wind ignores the wind given here: its memory
/// already holds what the wind made.
///
/// @param forms       the same day under one or several forms, same levels
/// @param times       instants after the end of D or at it, ascending
/// @param wind        10 m, towards; empty: missing at all times
/// @param end_of_day  24:00 of D, where lead is counted from
/// @param wind_error  of that wind after D
/// @param ensemble    how a weather ensemble departs from that wind, members x times; empty: none
///                    is known
/// Deterministic in (arguments, seed). Thread-safe.
[[nodiscard]] Propagated propagate(std::span<const Calibration> forms,
                                   std::span<const UtcTime> times,
                                   const std::optional<VectorColumn>& wind, UtcTime end_of_day,
                                   const WindErrorGrowth& wind_error, const Spread& spread,
                                   std::uint64_t seed, const WindDepartures& ensemble = {});

}  // namespace slackwater::calibration

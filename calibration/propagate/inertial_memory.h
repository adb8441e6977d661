#pragma once
#include <optional>
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What a steady model leaves over on day D at one level, as far as it is memory of the wind that blew: a constant and
/// a free inertial oscillation,
///
///   R(t) = b + c e^{-(r + i f)(t - t_D)},   t_D = 24:00 of D.
///
/// The second term is the homogeneous solution of the unsteady column: it turns clockwise in the north and decays.
struct InertialMemory {
  Horizontal constant_m_s{};
  Horizontal oscillation_m_s{};  ///< c: its value at the end of D

  /// The oscillation `lead_h` hours after the end of D (negative: before).
  [[nodiscard]] Horizontal oscillation_at(double lead_h, double damping_per_h,
                                          double coriolis_rad_h) const noexcept;
};

/// Rate at which free inertial motion dies out, 1/h: that of the mixed layer (e-folding `decay_h`), and where the
/// column feels the bed (finite_depth) the spin-down r/H of its linear drag beside it: 20 h in 35 m of water.
[[nodiscard]] double inertial_damping_per_h(const Calibration& calibration, double decay_h);

/// Ridge least squares over the cells of D that have a value; means are fitted as means (exact average of the
/// exponential). The penalty is worth `prior_observations` observations of an oscillation at rest, so that a day with
/// one daily mean, or a handful of values, keeps c near zero.
///
/// @param residual   observation minus model, m/s; levels as in the calibration
/// @param level      index of the level
/// @return nothing where the level has no value, or in the equatorial band (f near zero turns nothing)
[[nodiscard]] std::optional<InertialMemory> fit_inertial_memory(
    const VectorColumn& residual, std::size_t level, UtcTime end_of_day, double damping_per_h,
    double coriolis_rad_h, double prior_observations);

}  // namespace slackwater::calibration

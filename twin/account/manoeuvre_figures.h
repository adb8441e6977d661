#pragma once
#include <optional>
#include <span>
#include <vector>

#include "twin/account/track_account.h"

namespace slackwater::twin {

// The standard figures of manoeuvres (IMO MSC.137(76) and MSC/Circ.1053; ITTC 7.5-02-06), of rows
// as logs, trials and simulations have them. Pure: the same for all of these.
//
// Between rows heading, rate and place are taken as straight lines. On a circle of radius R that is
// off by R (r dt)^2 / 8 at most, with r dt the turn from row to row: 0.1 % of R at 5 degrees.

/// The craft at one time.
struct ManoeuvreRow {
  double t_s = 0;
  double north_m = 0;
  double east_m = 0;
  double heading_rad = 0;    ///< clockwise from north; jumps of a whole turn are none
  double ahead_m_s = 0;      ///< u
  double starboard_m_s = 0;  ///< v
  double turn_rad_s = 0;     ///< r, to starboard
  double helm_rad = 0;       ///< asked for; positive: bow to starboard. Of shares: any unit
  bool operator==(const ManoeuvreRow&) const = default;
};

/// Of a log, at the times at which the vehicle was there: speeds over ground, the helm as the
/// rudder stands, 0 of what has none.
[[nodiscard]] std::vector<ManoeuvreRow> manoeuvre_rows(const VehicleRows& log);

/// A turn once nothing changes any more.
struct SteadyTurn {
  double turn_rad_s = 0;
  double speed_m_s = 0;
  double radius_m = 0;    ///< speed over rate of turn
  double drift_rad = 0;   ///< of the bow into the turn, atan(-v/u) to starboard
  double speed_kept = 0;  ///< share of the speed at the execute
  bool operator==(const SteadyTurn&) const = default;
};

/// Places are along and across the course at the execute, from the place there. A figure is absent
/// where the rows end before it.
struct TurningCircle {
  bool to_starboard = false;
  std::optional<double> advance_m;            ///< along, at 90 degrees
  std::optional<double> transfer_m;           ///< across, at 90 degrees
  std::optional<double> tactical_diameter_m;  ///< across, at 180 degrees
  std::optional<double> quarter_s;            ///< since the execute, at 90 degrees
  std::optional<double> half_s;               ///< at 180
  std::optional<double> three_quarters_s;     ///< at 270
  std::optional<double> full_s;               ///< at 360
  /// The mean of the last quarter of a turn, where its rate stays within 2 % there.
  std::optional<SteadyTurn> steady;
  bool operator==(const TurningCircle&) const = default;
};
/// @param execute_s  when the helm was put over; the execute is where the row before it goes on to,
///                   and the first row where none is before
[[nodiscard]] TurningCircle turning_circle(std::span<const ManoeuvreRow> rows, double execute_s);

/// A zig-zag delta/psi: the helm is put over to the other side each time that the heading has
/// changed by psi from the course at the first execute.
struct ZigZag {
  std::vector<double> execute_s;      ///< since the first one, without it
  std::vector<double> overshoot_rad;  ///< of each of those: how far the heading went beyond psi
  std::optional<double> period_s;     ///< from the last execute but two to the last
  std::optional<double> initial_turning_m;  ///< track from the first execute until psi
  bool operator==(const ZigZag&) const = default;
};
/// @param heading_rad  psi, above 0
[[nodiscard]] ZigZag zig_zag(std::span<const ManoeuvreRow> rows, double execute_s,
                             double heading_rad);

/// The rate of turn at one helm of a spiral, Dieudonne's or Bech's.
struct SpiralPoint {
  double helm_rad = 0;
  double turn_rad_s = 0;  ///< mean of the last fifth of the time at that helm
  /// It stays there within 1 % of the largest rate of the spiral, over five rows at least.
  bool is_steady = false;
  bool operator==(const SpiralPoint&) const = default;
};
struct Spiral {
  std::vector<SpiralPoint> points;  ///< in the order of their time
  /// Of the loop of a craft that is unstable on its course: between the helms at which it changes
  /// its side on the way down and on the way up. 0: it has none. Nothing: it does not change its
  /// side on both ways.
  std::optional<double> loop_width_rad;
  /// Between the rates at helm 0 on both ways; nothing: it is not at helm 0 on both.
  std::optional<double> loop_height_rad_s;
  bool operator==(const Spiral&) const = default;
};
[[nodiscard]] Spiral spiral(std::span<const ManoeuvreRow> rows);

/// The rate of turn that is left after a steady turn once the helm is amidships: mean of the last
/// fifth of the rows. About 0: stable on its course.
/// @param midships_s  when that was
[[nodiscard]] double residual_turn_rad_s(std::span<const ManoeuvreRow> rows, double midships_s);

/// What a step of something that is kept looks like: heading, speed or depth.
struct StepResponse {
  std::optional<double> rise_s;      ///< from 10 to 90 % of the step
  std::optional<double> time_63_s;   ///< to 1 - 1/e of it
  double overshoot = 0;              ///< share of the step beyond it
  std::optional<double> settling_s;  ///< from when on it is within 5 %
  double steady_error = 0;           ///< in its unit: mean of the last fifth from what was asked
  bool operator==(const StepResponse&) const = default;
};
/// @param t_s    rising, from the step on
/// @param value  at those times. Headings are unwrapped before
[[nodiscard]] StepResponse step_response(std::span<const double> t_s, std::span<const double> value,
                                         double from, double to);

}  // namespace slackwater::twin

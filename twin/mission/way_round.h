#pragma once
#include <span>
#include <vector>

#include "twin/control/route.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// A way between two places that keeps off what stands in the water or in the air.
///
/// Straight, but round each structure that it would come nearer to than `clear_m` (a box counts as
/// the circle about it), on the side that turns less; depth or height change evenly along it. A
/// place that is nearer itself, because the work is there, is left or entered straight away from
/// the axis.
/// @return waypoints after `from`, the last of which is `to`. Where structures stand so close that
///         there is no way between them, it is the straight one.
[[nodiscard]] std::vector<Waypoint> way_round(const Triple<double>& from, const Triple<double>& to,
                                              std::span<const Structure> structures, double clear_m,
                                              double speed_m_s = 0);

/// The way back of a vehicle on a line: it has gone round a structure by `wound_rad` (clockwise
/// from above) since it left its place, and goes back round it by as much, so that the line does
/// not lie about it, and then to `to`.
[[nodiscard]] std::vector<Waypoint> way_unwound(const Triple<double>& from,
                                                const Triple<double>& to,
                                                const Structure& structure, double wound_rad,
                                                double clear_m, double speed_m_s = 0);

/// Bearing of a place from a structure's axis, clockwise from north, and its distance from it.
struct FromAxis {
  double bearing_rad = 0;
  double distance_m = 0;
};
[[nodiscard]] FromAxis from_axis(const Structure& structure, const Triple<double>& at_m) noexcept;
/// Of the circle about it in the plane.
[[nodiscard]] double radius_of(const Structure& structure) noexcept;

}  // namespace slackwater::twin

#pragma once
#include <vector>

#include "twin/control/route.h"

namespace slackwater::twin {

/// Parallel lines over a rectangle, there and back: `lines` of `length_m` along `course_rad`,
/// `spacing_m` apart to the right, the first from `corner_m`, all at the corner's depth.
[[nodiscard]] std::vector<Waypoint> lawn_mower(const Triple<double>& corner_m, double course_rad,
                                               double length_m, double spacing_m, int lines,
                                               double speed_m_s);

/// Round a vertical axis: `turns` of a polygon whose corners lie on the circle and are at most
/// `chord_m` apart, from bearing `start_rad`, clockwise; from the depth of `centre_m` to
/// `end_depth_m` over the turns.
[[nodiscard]] std::vector<Waypoint> orbit(const Triple<double>& centre_m, double radius_m,
                                          double start_rad, double turns, double end_depth_m,
                                          double chord_m, double speed_m_s);

/// Straight along a course with a depth that swings once a `wavelength_m` about the middle of the
/// two depths, from the middle downwards; waypoints every `spacing_m`.
[[nodiscard]] std::vector<Waypoint> depth_sweep(const Triple<double>& start_m, double course_rad,
                                                double length_m, double shallow_m, double deep_m,
                                                double wavelength_m, double spacing_m,
                                                double speed_m_s);

/// The expanding square of a search for what is somewhere about a place: legs of one, one, two,
/// two, three, ... times `leg_m`, each turned 90 degrees to the right of the one before.
/// Source: IAMSAR manual, volume II, 5.
[[nodiscard]] std::vector<Waypoint> expanding_square(const Triple<double>& datum_m, double leg_m,
                                                     int legs, double course_rad, double speed_m_s);

}  // namespace slackwater::twin

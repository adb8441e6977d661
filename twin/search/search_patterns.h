#pragma once
#include <vector>

#include "twin/control/route.h"

namespace slackwater::twin {

// Patterns of the IAMSAR manual (volume II, chapter 5; volume III, section 3). The expanding square
// is in control/patterns.h.

/// A sector search about a place that is well known: triangles with equal sides that meet there,
/// every turn 120 degrees to the right, straight on over the datum. Three legs a sector; with three
/// sectors it comes back to where it began, on the course it began with.
/// @param leg_m  the radius of the circle that is searched
[[nodiscard]] std::vector<Waypoint> sector_search(const Triple<double>& datum_m, double leg_m,
                                                  int sectors, double course_rad, double speed_m_s);

/// A parallel sweep over a rectangle about `centre_m`, as few lines along `course_rad` as are no
/// more than `spacing_m` apart, the outer ones half of that from the edges; from the left edge to
/// the right one.
[[nodiscard]] std::vector<Waypoint> parallel_sweep(const Triple<double>& centre_m,
                                                   double course_rad, double length_m,
                                                   double width_m, double spacing_m,
                                                   double speed_m_s);

}  // namespace slackwater::twin

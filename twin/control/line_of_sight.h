#pragma once
#include "twin/control/route.h"

namespace slackwater::twin {

/// Where to head and how fast, for the autopilots of a vehicle.
struct Heading {
  double yaw_rad = 0;    ///< clockwise from north
  double speed_m_s = 0;  ///< through the water
  double depth_m = 0;
};

/// Line-of-sight guidance along a leg: the course points at the place on the leg a lookahead
/// distance ahead,
///
///   chi = course - atan(across/lookahead),
///
/// and the yaw leads it by the crab angle that cancels the part of the water's motion across that
/// course,
///
///   psi = chi - asin(U_c,across/U).
///
/// Water faster across the course than the vehicle's own speed cannot be held: the yaw then is
/// square to the course.
/// Source: Fossen (2011), 12.3; Borhaug, Pavlov and Pettersen (2008).
struct LineOfSight {
  double lookahead_m = 5;
  bool compensates_current = true;
};

/// @param water_m_s  the current as the vehicle knows it (north, east components of a NED vector);
///                   ignored without compensation
[[nodiscard]] Heading heading_along(const LineOfSight& guidance, const Triple<double>& from,
                                    const Waypoint& to, const Triple<double>& position_m,
                                    const Triple<double>& water_m_s, double speed_m_s) noexcept;

}  // namespace slackwater::twin

#pragma once
#include "twin/control/autopilot.h"
#include "twin/control/route.h"

namespace slackwater::twin {

/// How a route is followed.
struct Guidance {
  double speed_m_s = 0;         ///< where a waypoint says none
  bool is_over_ground = false;  ///< that speed; see `Reference`
  double tolerance_m = 0.5;     ///< a waypoint nearer than this is reached, or than 2.5 s where it
                                ///< slows at corners
  double depth_tolerance_m = 0.5;
  /// A waypoint that the vehicle comes past within this is left behind. At least the radius of the
  /// tightest turn at that speed, for craft that cannot stop on it: a waypoint inside their turn
  /// would be circled for ever.
  double passing_m = 2;
  bool slows_at_corners = false;  ///< craft that can push every way
  double braking_m_s2 = 0;
};

/// As suits a vehicle of its kind and limits.
/// @throws ContractViolation for a speed that is not positive
[[nodiscard]] Guidance guidance_for(const Autopilot& autopilot, double speed_m_s,
                                    bool is_over_ground = false);

/// The reference of a step on a route: takes the waypoints that are reached, then gives the place
/// beside the vehicle on the leg under way, moving along it. From beyond the end of a leg it leads
/// back to its waypoint by a straight way; at the end of the route it is a station there. Another
/// route may be put in its place at any step. Cost: 0.1 us, no allocation.
[[nodiscard]] Reference reference_along(const Guidance& guidance, Route& route,
                                        const Measured& measured);

}  // namespace slackwater::twin

#pragma once
#include <vector>

#include "twin/render/scene/render_scene.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::twin {

/// Another vessel as it looks: a boat as long and wide as it says of itself, else 20 m by 6, or a
/// fifth as wide as long; upright, its bow where it goes (north where it lies still), with a
/// twentieth of its length below the water and twice as much above it: estimates.
/// @param surface_m  z of the sea
[[nodiscard]] SeenThing seen_vessel(const TrafficVessel& vessel, const MovingPoint& motion,
                                    double surface_m);

/// Those that are within reach of a place at a time, by their tracks.
/// @param middle_m, reach_m  in the plane
[[nodiscard]] std::vector<SeenThing> vessels_in_reach(const std::vector<TrafficVessel>& vessels,
                                                      double t_s, const Triple<double>& middle_m,
                                                      double reach_m, double surface_m);

}  // namespace slackwater::twin

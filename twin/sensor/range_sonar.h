#pragma once
#include <optional>
#include <vector>

#include "twin/scene/structure.h"
#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// A sonar that measures ranges over a sector, one narrow beam beside the other, about the
/// vehicle's forward axis in its own plane: the nearest structure, bed or surface that the middle
/// of a beam meets, with white noise and a resolution. Nothing from nearer than `nearest_m`,
/// farther than `farthest_m`, or met more slantwise than `least_squareness`.
///
/// Defaults: the kind of a Ping360 (Blue Robotics: 0.75-50 m, beams of 2 degrees; unconfirmed);
/// noise, resolution and least squareness are estimates.
struct RangeSonar {
  double sector_rad = 2.0943951023931953;  ///< 120 degrees
  int beams = 60;
  double tilt_rad = 0;  ///< of the plane, downwards ahead
  double nearest_m = 0.75;
  double farthest_m = 50;
  double least_squareness = 0.2;
  double noise_sd_m = 0.02;
  double resolution_m = 0.01;
};

struct SonarEcho {
  double bearing_rad = 0;  ///< to the right of forward
  std::optional<double> range_m;
};

[[nodiscard]] std::vector<SonarEcho> measured(const RangeSonar& sonar, NoiseStream& noise,
                                              const Scene& scene, const Triple<double>& at_m,
                                              const Rotation<double>& r);

}  // namespace slackwater::twin

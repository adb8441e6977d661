#pragma once
#include <cmath>
#include <vector>

#include "twin/control/allocation.h"

/// Mounts and ranges of thrust of the vehicles of data/vehicles, from the same sources.
namespace slackwater::tests {

/// ArduSub's vectored frame, as in data/vehicles/bluerov2_heavy.yaml.
inline std::vector<twin::Mount> bluerov2_mounts() {
  const double s = std::sqrt(0.5);
  return {{{0.140, 0.092, 0}, {-s, s, 0}},      {{0.140, -0.092, 0}, {-s, -s, 0}},
          {{-0.150, 0.092, 0}, {s, s, 0}},      {{-0.150, -0.092, 0}, {s, -s, 0}},
          {{0.118, 0.215, -0.064}, {0, 0, 1}},  {{0.118, -0.215, -0.064}, {0, 0, 1}},
          {{-0.118, 0.215, -0.064}, {0, 0, 1}}, {{-0.118, -0.215, -0.064}, {0, 0, 1}}};
}
/// T200 at 16 V, manufacturer's table of September 2019.
inline std::vector<twin::ThrustRange> t200_ranges(std::size_t count) {
  return std::vector<twin::ThrustRange>(count, {-39.91, 51.44, 0});
}

/// osrf/lrauv: propeller, two pairs of fins alike, sliding battery, buoyancy engine. The rate of
/// the fins is an estimate.
inline std::vector<twin::Mount> lrauv_mounts() { return {{{-1.43162, 0, 0}, {1, 0, 0}, 1}}; }
inline std::vector<twin::ThrustRange> lrauv_ranges() { return {{-5, 10, 0}}; }
inline twin::FinPair lrauv_fins() { return {0.0244, -1.05, 4.13, 0.2, 0.17, 0.261799, 0.35}; }
inline twin::Trim lrauv_trim() { return {31.7307, 0.03, 0.0007, -420e-6, 455e-6, 3e-6}; }

/// PX4-gazebo-models, x500, turned from forward-left-up to forward-right-down; thrust is up, that
/// is along -z. Seen along the thrust (from below) counterclockwise from above is clockwise.
inline std::vector<twin::Mount> x500_mounts() {
  return {{{0.174, 0.174, -0.06}, {0, 0, -1}, 1},
          {{-0.174, -0.174, -0.06}, {0, 0, -1}, 1},
          {{0.174, -0.174, -0.06}, {0, 0, -1}, -1},
          {{-0.174, 0.174, -0.06}, {0, 0, -1}, -1}};
}
inline std::vector<twin::ThrustRange> x500_ranges() {
  return std::vector<twin::ThrustRange>(4, {0, 8.54858, 0.016});
}

/// VRX: two outboards, 250 N ahead and 100 N astern.
inline std::vector<twin::Mount> wamv_mounts() {
  return {{{-2.65, -1.027135, 0.19}, {1, 0, 0}}, {{-2.65, 1.027135, 0.19}, {1, 0, 0}}};
}
inline std::vector<twin::ThrustRange> outboard_ranges() { return {{-100, 250, 0}, {-100, 250, 0}}; }

inline std::vector<twin::WantedAxis> six_axes_levels() {
  using twin::Axis;
  return {{Axis::heave, 0}, {Axis::roll, 0},  {Axis::pitch, 0},
          {Axis::yaw, 1},   {Axis::surge, 2}, {Axis::sway, 2}};
}
inline std::vector<twin::WantedAxis> multirotor_axes() {
  using twin::Axis;
  return {{Axis::heave, 0}, {Axis::roll, 1}, {Axis::pitch, 1}, {Axis::yaw, 2}};
}
inline std::vector<twin::WantedAxis> surface_axes() {
  using twin::Axis;
  return {{Axis::yaw, 0}, {Axis::surge, 1}, {Axis::sway, 1}};
}

}  // namespace slackwater::tests

#pragma once
#include <cmath>

#include "fields/base/constants.h"
#include "twin/body/spatial.h"

namespace slackwater::twin {

/// A direction over the water as a vector of length one: no wrap at north, no trigonometry in a
/// step.
struct Course {
  double north = 1;
  double east = 0;
};
/// Clockwise from north.
[[nodiscard]] Course course_of(double bearing_rad) noexcept;
[[nodiscard]] double bearing_rad(const Course& course) noexcept;

enum class Target {
  cruise,   ///< a velocity, a heading and a depth
  station,  ///< a place and a heading
  path,     ///< a place that moves along a path
};
enum class Vertical { depth, altitude };

/// What an autopilot is to do. A value: another may be put in its place at any step.
struct Reference {
  Target target = Target::station;
  Vertical vertical = Vertical::depth;
  /// NED. Station: where to be. Path: the place on the path beside the vehicle. Cruise: only the
  /// depth, z, counts.
  Triple<double> position_m;
  /// Path: the velocity of that place over ground, NED. Cruise: ahead, to starboard of the heading,
  /// and down.
  Triple<double> velocity_m_s;
  /// Of the bow. Craft that cannot push sideways take their own on station and on a path.
  Course heading;
  /// Path, of craft that swim or float: the size of `velocity_m_s` is the speed over ground; else
  /// it is the one through the water, and the velocity only says the way. Others always go by the
  /// ground.
  bool is_over_ground = false;
  /// Cruise, of what goes by the ground: the stream that carries it, NED. `velocity_m_s` is then
  /// through that, and so are its limits.
  Triple<double> carried_m_s;
  double altitude_m =
      0;  ///< above the bed, with Vertical::altitude: z of `position_m` then counts for nothing
};

/// What the vehicle knows of itself. How well, is up to its sensors.
struct Measured {
  Triple<double> position_m;  ///< NED
  Attitude<double> attitude;
  Spatial<double> nu;        ///< over ground, body axes
  Triple<double> water_m_s;  ///< the current as the vehicle knows it, NED; zero where it does not
  double altitude_m = 0;     ///< above the bed
  /// Ahead through the water, as its speed log shows it; no number: it has none, or that gave
  /// nothing.
  double log_m_s = constants::nan;

  [[nodiscard]] bool has_log() const noexcept { return !std::isnan(log_m_s); }
};

}  // namespace slackwater::twin

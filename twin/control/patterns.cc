#include "twin/control/patterns.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

constexpr double turn = 2 * constants::pi;

Triple<double> moved(const Triple<double>& from, double course_rad, double ahead_m,
                     double right_m) {
  const double c = std::cos(course_rad), s = std::sin(course_rad);
  return {from.x + c * ahead_m - s * right_m, from.y + s * ahead_m + c * right_m, from.z};
}

}  // namespace

std::vector<Waypoint> lawn_mower(const Triple<double>& corner_m, double course_rad, double length_m,
                                 double spacing_m, int lines, double speed_m_s) {
  expects(lines > 0 && length_m > 0 && spacing_m > 0, "a lawn-mower pattern has lines");
  std::vector<Waypoint> points;
  for (int i = 0; i < lines; ++i) {
    const double right = i * spacing_m;
    const Triple<double> near = moved(corner_m, course_rad, 0, right);
    const Triple<double> far = moved(corner_m, course_rad, length_m, right);
    points.push_back({i % 2 == 0 ? near : far, speed_m_s});
    points.push_back({i % 2 == 0 ? far : near, speed_m_s});
  }
  return points;
}

std::vector<Waypoint> orbit(const Triple<double>& centre_m, double radius_m, double start_rad,
                            double turns, double end_depth_m, double chord_m, double speed_m_s) {
  expects(radius_m > 0 && turns > 0 && chord_m > 0, "an orbit has a radius, turns and chords");
  // chord = 2 r sin(angle/2)
  const double widest = chord_m < 2 * radius_m ? 2 * std::asin(chord_m / (2 * radius_m)) : turn / 3;
  const auto steps = static_cast<int>(std::ceil(turns * turn / std::min(widest, turn / 3)));
  std::vector<Waypoint> points;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double bearing = start_rad + share * turns * turn;
    points.push_back(
        {{centre_m.x + radius_m * std::cos(bearing), centre_m.y + radius_m * std::sin(bearing),
          centre_m.z + share * (end_depth_m - centre_m.z)},
         speed_m_s});
  }
  return points;
}

std::vector<Waypoint> depth_sweep(const Triple<double>& start_m, double course_rad, double length_m,
                                  double shallow_m, double deep_m, double wavelength_m,
                                  double spacing_m, double speed_m_s) {
  expects(length_m > 0 && wavelength_m > 0 && spacing_m > 0, "a sweep has a length");
  const auto steps = static_cast<int>(std::ceil(length_m / spacing_m));
  std::vector<Waypoint> points;
  for (int i = 1; i <= steps; ++i) {
    const double along = length_m * i / steps;
    Triple<double> at = moved(start_m, course_rad, along, 0);
    at.z = 0.5 * (shallow_m + deep_m) +
           0.5 * (deep_m - shallow_m) * std::sin(turn * along / wavelength_m);
    points.push_back({at, speed_m_s});
  }
  return points;
}

std::vector<Waypoint> expanding_square(const Triple<double>& datum_m, double leg_m, int legs,
                                       double course_rad, double speed_m_s) {
  expects(legs > 0 && leg_m > 0, "an expanding square has legs");
  std::vector<Waypoint> points{{datum_m, speed_m_s}};
  for (int i = 0; i < legs; ++i) {
    const double length_m = leg_m * static_cast<double>(1 + i / 2);
    points.push_back(
        {moved(points.back().position_m, course_rad + 0.25 * turn * i, length_m, 0), speed_m_s});
  }
  return points;
}

}  // namespace slackwater::twin

#include "twin/search/search_patterns.h"

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "twin/control/patterns.h"

namespace slackwater::twin {
namespace {

Triple<double> moved(const Triple<double>& from, double course_rad, double ahead_m,
                     double right_m) {
  const double c = std::cos(course_rad), s = std::sin(course_rad);
  return {from.x + c * ahead_m - s * right_m, from.y + s * ahead_m + c * right_m, from.z};
}

}  // namespace

std::vector<Waypoint> sector_search(const Triple<double>& datum_m, double leg_m, int sectors,
                                    double course_rad, double speed_m_s) {
  expects(sectors > 0 && leg_m > 0, "a sector search has legs");
  constexpr double turn_rad = 2 * constants::pi / 3;
  std::vector<Waypoint> points{{datum_m, speed_m_s}};
  for (int sector = 0; sector < sectors; ++sector) {
    // Out, across, and home: two turns of 120 degrees, and none over the datum.
    const double out_rad = course_rad + 2 * turn_rad * sector;
    const Triple<double> far_m = moved(datum_m, out_rad, leg_m, 0);
    points.push_back({far_m, speed_m_s});
    points.push_back({moved(far_m, out_rad + turn_rad, leg_m, 0), speed_m_s});
    points.push_back({datum_m, speed_m_s});
  }
  return points;
}

std::vector<Waypoint> parallel_sweep(const Triple<double>& centre_m, double course_rad,
                                     double length_m, double width_m, double spacing_m,
                                     double speed_m_s) {
  expects(length_m > 0 && width_m > 0 && spacing_m > 0, "a sweep has an area and a spacing");
  // Rounding must not make one line more of a width that is a multiple of the spacing.
  const int lines = std::max(1, static_cast<int>(std::ceil(width_m / spacing_m - 1e-9)));
  const double apart_m = width_m / lines;
  const Triple<double> corner_m =
      moved(centre_m, course_rad, -0.5 * length_m, 0.5 * (apart_m - width_m));
  return lawn_mower(corner_m, course_rad, length_m, apart_m, lines, speed_m_s);
}

}  // namespace slackwater::twin

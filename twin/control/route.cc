#include "twin/control/route.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

bool is_finite(const Triple<double>& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double distance_m(const Triple<double>& a, const Triple<double>& b) {
  const Triple<double> d = a - b;
  return std::sqrt(dot(d, d));
}

}  // namespace

Route::Route(const Triple<double>& start, std::span<const Waypoint> waypoints)
    : start_(start), points_(waypoints.begin(), waypoints.end()) {
  expects(is_finite(start), "a route starts at a finite place");
  for (const Waypoint& point : points_)
    expects(is_finite(point.position_m) && point.speed_m_s >= 0, "waypoints are finite");
}

const Triple<double>& Route::from() const noexcept {
  const std::size_t to = std::min(next_, points_.size() - 1);
  return points_.empty() || to == 0 ? start_ : points_[to - 1].position_m;
}

const Waypoint& Route::to() const noexcept {
  static const Waypoint nowhere;
  if (points_.empty()) return nowhere;
  return points_[std::min(next_, points_.size() - 1)];
}

const Waypoint* Route::after() const noexcept {
  return next_ + 1 < points_.size() ? &points_[next_ + 1] : nullptr;
}

double Route::remaining_m(const Triple<double>& position_m) const noexcept {
  if (is_done()) return 0;
  double sum = distance_m(position_m, points_[next_].position_m);
  for (std::size_t i = next_ + 1; i < points_.size(); ++i)
    sum += distance_m(points_[i - 1].position_m, points_[i].position_m);
  return sum;
}

std::size_t Route::advance(const Triple<double>& position_m, double tolerance_m,
                           double depth_tolerance_m, double passing_m) {
  std::size_t taken = 0;
  while (!is_done()) {
    const Triple<double>& target = points_[next_].position_m;
    const Triple<double> left = target - position_m;
    const double away = std::sqrt(left.x * left.x + left.y * left.y);
    const bool is_at = away <= tolerance_m && std::abs(left.z) <= depth_tolerance_m;
    const LegPlace place = place_on_leg(from(), target, position_m);
    const bool is_passed =
        place.length_m > 0 && place.along_m >= place.length_m && away <= passing_m;
    if (!is_at && !is_passed) break;
    ++next_;
    ++taken;
  }
  return taken;
}

LegPlace place_on_leg(const Triple<double>& from, const Triple<double>& to,
                      const Triple<double>& position_m) noexcept {
  const double north = to.x - from.x, east = to.y - from.y;
  LegPlace place;
  place.length_m = std::sqrt(north * north + east * east);
  if (place.length_m > 0) place.course = {north / place.length_m, east / place.length_m};
  const double dn = position_m.x - from.x, de = position_m.y - from.y;
  place.along_m = place.course.north * dn + place.course.east * de;
  place.across_m = place.course.north * de - place.course.east * dn;
  return place;
}

}  // namespace slackwater::twin

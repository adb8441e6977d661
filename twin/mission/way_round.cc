#include "twin/mission/way_round.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

/// Corners of the polygon about a circle are no more than this apart.
constexpr double widest_rad = constants::pi / 9;

struct Circle {
  double north_m = 0;
  double east_m = 0;
  double radius_m = 0;
  double top_m = 0;
  double bottom_m = 0;
};

/// Of a distance in the plane; std::hypot takes three times as long over lengths that no farm has.
double plane_m(double north_m, double east_m) noexcept {
  return std::sqrt(north_m * north_m + east_m * east_m);
}

Circle circle_of(const Structure& structure) noexcept {
  if (const auto* c = std::get_if<Cylinder>(&structure))
    return {c->north_m, c->east_m, c->radius_m, c->top_m, c->bottom_m};
  const Box& b = *std::get_if<Box>(&structure);
  return {b.centre_m.x, b.centre_m.y, plane_m(b.half_size_m.x, b.half_size_m.y),
          b.centre_m.z - b.half_size_m.z, b.centre_m.z + b.half_size_m.z};
}

Triple<double> on_circle(const Circle& c, double bearing_rad, double radius_m) noexcept {
  return {c.north_m + radius_m * std::cos(bearing_rad), c.east_m + radius_m * std::sin(bearing_rad),
          0};
}

/// Round a circle from one bearing on by an angle, corners outside of it.
void go_round(const Circle& c, double radius_m, double from_rad, double by_rad,
              std::vector<Triple<double>>& way) {
  const int corners = std::max(1, static_cast<int>(std::ceil(std::abs(by_rad) / widest_rad)));
  const double out_m = radius_m / std::cos(0.5 * std::abs(by_rad) / corners);
  for (int i = 0; i <= corners; ++i)
    way.push_back(on_circle(c, from_rad + by_rad * i / corners, out_m));
}

/// How near a straight way in the plane comes to the axis, and where on it, 0 to 1.
struct Pass {
  double distance_m = 0;
  double at = 0;
};
Pass pass_of(const Circle& c, const Triple<double>& from, const Triple<double>& to) noexcept {
  const double n = to.x - from.x, e = to.y - from.y, length2 = n * n + e * e;
  const double along = (c.north_m - from.x) * n + (c.east_m - from.y) * e;
  const double at = length2 > 0 ? std::clamp(along / length2, 0.0, 1.0) : 0;
  return {plane_m(from.x + at * n - c.north_m, from.y + at * e - c.east_m), at};
}

/// Places in the plane after `from`, up to `to`.
void find_way(const Triple<double>& from, const Triple<double>& to, std::span<const Circle> circles,
              int turns_left, std::vector<Triple<double>>& way) {
  const Circle* first = nullptr;
  double first_at = 2;
  for (const Circle& c : circles) {
    const Pass pass = pass_of(c, from, to);
    const bool only_leaves = pass.at <= 0, only_comes = pass.at >= 1;
    if (pass.distance_m >= c.radius_m * (1 - 1e-9) || only_leaves || only_comes) continue;
    if (pass.at < first_at) {
      first = &c;
      first_at = pass.at;
    }
  }
  if (first == nullptr || turns_left == 0) {
    way.push_back(to);
    return;
  }
  const Circle& c = *first;
  const double here_m = plane_m(from.x - c.north_m, from.y - c.east_m);
  const double there_m = plane_m(to.x - c.north_m, to.y - c.east_m);
  const double here = std::atan2(from.y - c.east_m, from.x - c.north_m);
  const double there = std::atan2(to.y - c.east_m, to.x - c.north_m);
  const double turn = short_way_rad(there - here), side = turn < 0 ? -1 : 1;
  // Tangents from outside; from within the circle straight out to it.
  const double out = here_m > c.radius_m ? std::acos(c.radius_m / here_m) : 0;
  const double in = there_m > c.radius_m ? std::acos(c.radius_m / there_m) : 0;
  go_round(c, c.radius_m, here + side * out, side * std::max(std::abs(turn) - out - in, 0.0), way);
  const Triple<double> behind = way.back();
  find_way(behind, to, circles, turns_left - 1, way);
}

/// Waypoints with the depth going evenly along.
std::vector<Waypoint> waypoints_of(const Triple<double>& from, const Triple<double>& to,
                                   std::span<const Triple<double>> way, double speed_m_s) {
  double length_m = 0;
  Triple<double> before = from;
  for (const Triple<double>& at : way) {
    length_m += plane_m(at.x - before.x, at.y - before.y);
    before = at;
  }
  std::vector<Waypoint> out;
  double gone_m = 0;
  before = from;
  for (const Triple<double>& at : way) {
    gone_m += plane_m(at.x - before.x, at.y - before.y);
    before = at;
    const double share = length_m > 0 ? gone_m / length_m : 1;
    out.push_back({{at.x, at.y, from.z + share * (to.z - from.z)}, speed_m_s});
  }
  out.back().position_m = to;
  return out;
}

}  // namespace

FromAxis from_axis(const Structure& structure, const Triple<double>& at_m) noexcept {
  const Circle c = circle_of(structure);
  return {std::atan2(at_m.y - c.east_m, at_m.x - c.north_m),
          plane_m(at_m.x - c.north_m, at_m.y - c.east_m)};
}

double radius_of(const Structure& structure) noexcept { return circle_of(structure).radius_m; }

std::vector<Waypoint> way_round(const Triple<double>& from, const Triple<double>& to,
                                std::span<const Structure> structures, double clear_m,
                                double speed_m_s) {
  const double highest_m = std::min(from.z, to.z), lowest_m = std::max(from.z, to.z);
  std::vector<Circle> circles;
  for (const Structure& structure : structures) {
    Circle c = circle_of(structure);
    if (c.top_m - clear_m > lowest_m || c.bottom_m + clear_m < highest_m) continue;
    c.radius_m += clear_m;
    circles.push_back(c);
  }
  std::vector<Triple<double>> way;
  find_way(from, to, circles, 2 * static_cast<int>(circles.size()) + 2, way);
  return waypoints_of(from, to, way, speed_m_s);
}

std::vector<Waypoint> way_unwound(const Triple<double>& from, const Triple<double>& to,
                                  const Structure& structure, double wound_rad, double clear_m,
                                  double speed_m_s) {
  const Circle c = circle_of(structure);
  const FromAxis here = from_axis(structure, from);
  std::vector<Triple<double>> way;
  go_round(c, std::max(c.radius_m + clear_m, here.distance_m), here.bearing_rad, -wound_rad, way);
  way.push_back(to);
  return waypoints_of(from, to, way, speed_m_s);
}

}  // namespace slackwater::twin

#include "twin/control/guidance.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

double speed_to(const Guidance& guidance, const Waypoint& to) {
  return to.speed_m_s > 0 ? to.speed_m_s : guidance.speed_m_s;
}

/// A waypoint is reached where the vehicle is nearer than what it goes in 2.5 seconds, 0.5 m at
/// most: the next leg begins at the waypoint, and whoever took it up from farther off would hurry
/// there, however slow the leg is to be gone.
double tolerance_to(const Guidance& guidance, const Waypoint& to) {
  constexpr double near_s = 2.5;
  if (!guidance.slows_at_corners) return guidance.tolerance_m;
  return std::min(guidance.tolerance_m, near_s * speed_to(guidance, to));
}

/// How fast to come to the end of a leg: as fast as its course goes on beyond.
double corner_speed_m_s(const Route& route, const Triple<double>& leg, double speed_m_s) {
  const Waypoint* next = route.after();
  if (next == nullptr) return 0;
  const Triple<double> on = next->position_m - route.to().position_m;
  const double size = std::sqrt(dot(leg, leg) * dot(on, on));
  return size > 0 ? speed_m_s * std::max(dot(leg, on) / size, 0.0) : 0.0;
}

Reference towards(const Triple<double>& place_m, const Triple<double>& velocity_m_s,
                  const Measured& measured, bool is_over_ground = false) {
  Reference reference;
  reference.is_over_ground = is_over_ground;
  reference.target = Target::path;
  reference.position_m = place_m;
  reference.velocity_m_s = velocity_m_s;
  const double flat = std::sqrt(velocity_m_s.x * velocity_m_s.x + velocity_m_s.y * velocity_m_s.y);
  reference.heading = flat > 1e-6 ? Course{velocity_m_s.x / flat, velocity_m_s.y / flat}
                                  : bow_of(rotation_of(measured.attitude));
  return reference;
}

/// At the end of a leg, with the bow as on it.
Reference station_after(const Triple<double>& leg, const Triple<double>& place_m,
                        const Measured& measured) {
  Reference reference = towards(place_m, leg, measured);
  reference.target = Target::station;
  reference.velocity_m_s = {};
  return reference;
}

}  // namespace

Guidance guidance_for(const Autopilot& autopilot, double speed_m_s, bool is_over_ground) {
  expects(speed_m_s > 0, "a route is followed at a speed");
  const AutopilotSettings& s = autopilot.settings;
  Guidance g;
  g.is_over_ground = is_over_ground;
  g.speed_m_s = std::min(speed_m_s, most_over_ground_m_s(autopilot, is_over_ground));
  g.braking_m_s2 = 0.5 * s.most_acceleration_m_s2;
  const double turn_m = g.speed_m_s / s.most_yaw_rate_rad_s;
  switch (autopilot.kind) {
    case VehicleKind::rov:
    case VehicleKind::uav:
      g.slows_at_corners = true;
      return g;
    case VehicleKind::auv:
      g.tolerance_m = 3;
      g.depth_tolerance_m = 2;
      break;
    case VehicleKind::usv:
      g.tolerance_m = 2;
      break;
    case VehicleKind::vessel:
      g.tolerance_m = 10;
      break;
  }
  g.passing_m = std::max(4 * g.tolerance_m, 1.5 * turn_m);
  if (autopilot.kind != VehicleKind::auv) {
    g.depth_tolerance_m = 1e3;  // it floats
    g.passing_m = std::max(g.passing_m, tightest_turn_m(autopilot, g.speed_m_s));
  }
  return g;
}

Reference reference_along(const Guidance& guidance, Route& route, const Measured& measured) {
  const Triple<double>& here = measured.position_m;
  route.advance(here, tolerance_to(guidance, route.to()), guidance.depth_tolerance_m,
                guidance.passing_m);
  const Triple<double>& from = route.from();
  const Waypoint& to = route.to();
  const Triple<double> leg = to.position_m - from;
  if (route.is_done()) return station_after(leg, to.position_m, measured);
  const double speed = speed_to(guidance, to);
  const bool is_over_ground = to.speed_m_s > 0 ? to.over_ground > 0 : guidance.is_over_ground;
  const double length2 = dot(leg, leg);
  const double share = length2 > 0 ? dot(here - from, leg) / length2 : 2.0;
  if (share >= 1) {
    // Past it and not near enough: back, or down a leg that is only that.
    if (guidance.slows_at_corners) return station_after(leg, to.position_m, measured);
    const Triple<double> back = to.position_m - here;
    const double away = std::sqrt(back.x * back.x + back.y * back.y);
    if (!(away > 1e-6)) return station_after(leg, to.position_m, measured);
    return towards({here.x, here.y, to.position_m.z},
                   {speed / away * back.x, speed / away * back.y, 0}, measured, is_over_ground);
  }
  const double along = std::max(share, 0.0);
  const double length = std::sqrt(length2);
  double pace = speed;
  if (guidance.slows_at_corners) {
    const double corner = corner_speed_m_s(route, leg, speed);
    const double left = (1 - along) * length;
    pace = std::min(speed, std::sqrt(corner * corner + 2 * guidance.braking_m_s2 * left) + 0.05);
  }
  return towards(from + along * leg, (pace / length) * leg, measured, is_over_ground);
}

}  // namespace slackwater::twin

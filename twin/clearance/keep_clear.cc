#include "twin/clearance/keep_clear.h"

#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

/// The distance of a place for which an autopilot goes at that speed: `approach_speed` the other
/// way round.
double distance_for_m(const Autopilot& a, double speed_m_s) noexcept {
  const double braking = 0.5 * a.settings.most_acceleration_m_s2, outer = a.station_per_s;
  const double bend_m_s = braking / outer;
  return speed_m_s <= bend_m_s
             ? speed_m_s / outer
             : 0.5 * (speed_m_s * speed_m_s / braking + braking / (outer * outer));
}

/// Of an AUV: the speed that the reference has it go at.
double speed_ahead_m_s(const Autopilot& a, const Reference& wanted) noexcept {
  const AutopilotSettings& s = a.settings;
  double speed = 0.6 * s.most_speed_m_s;
  if (wanted.target == Target::cruise) speed = wanted.velocity_m_s.x;
  if (wanted.target == Target::path)
    speed = std::hypot(wanted.velocity_m_s.x, wanted.velocity_m_s.y);
  return std::clamp(speed, s.least_speed_m_s, s.most_speed_m_s);
}

/// The heading that makes the vehicle turn to starboard along its circle: its loop asks for
/// outer 2 tan(e/2) per second of an angle e.
Planar circling_course(const Handling& h, const Autopilot& a, const OwnMotion& own,
                       double speed_m_s) noexcept {
  const double rate = speed_m_s / h.turning_radius_m;
  const double turn = 2 * std::atan(0.5 * rate / a.heading.outer_per_s);
  return std::cos(turn) * own.bow + std::sin(turn) * to_the_right(own.bow);
}

}  // namespace

Handling handling_of(const Autopilot& a, double radius_m, double above_m, double below_m,
                     bool is_afloat, double barrier_s) noexcept {
  const AutopilotSettings& s = a.settings;
  Handling h;
  if (a.kind == VehicleKind::auv)
    h.manner = Manner::circles;
  else if (a.kind != VehicleKind::uav && !a.allocation.commands(Axis::sway))
    h.manner = Manner::turns;
  const double lag_s = 1 / a.horizontal.inner_per_s + a.lag_s;
  h.acceleration_m_s2 = s.most_acceleration_m_s2;
  h.deceleration_m_s2 = 0.5 * s.most_acceleration_m_s2;
  h.reaction_s = 4 * lag_s + barrier_s;
  h.stray_m = h.acceleration_m_s2 * lag_s * lag_s;
  if (h.manner == Manner::turns) {
    const double astern_m_s2 = a.allocation.most_astern[0] / a.mass.entry[0][0];
    h.deceleration_m_s2 = std::min(s.most_acceleration_m_s2, 0.5 * astern_m_s2);
    h.reaction_s = 2 * lag_s + barrier_s;
    h.early = 1.25;
    h.stray_m = 0.5 * radius_m;
  }
  h.most_speed_m_s = s.most_speed_m_s;
  h.sure_speed_m_s = 0.5 * s.most_speed_m_s;
  h.most_yaw_rate_rad_s = s.most_yaw_rate_rad_s;
  if (h.manner == Manner::circles) {
    h.turning_radius_m = 1.25 * s.most_speed_m_s / s.most_yaw_rate_rad_s;
    h.reaction_s = 2 / a.heading.inner_per_s + a.lag_s + barrier_s;
    h.stray_m = radius_m;
  }
  h.vertical_deceleration_m_s2 = 0.5 * s.most_acceleration_m_s2;
  h.radius_m = radius_m;
  h.above_m = above_m;
  h.below_m = below_m;
  h.is_afloat = is_afloat;
  return h;
}

OwnMotion own_motion(const Triple<double>& position_m, const Rotation<double>& r,
                     const Triple<double>& velocity_ned_m_s) noexcept {
  OwnMotion own;
  own.position_m = planar(position_m);
  own.velocity_m_s = planar(velocity_ned_m_s);
  own.depth_m = position_m.z;
  own.down_m_s = velocity_ned_m_s.z;
  own.bow = planar(bow_of(r));
  return own;
}

Reference keep_clear(const Handling& handling, const StandOff& stand_off, const Lookout& lookout,
                     const Autopilot& a, const Measured& measured, const Reference& wanted,
                     double dt_s, ClearanceState& state) noexcept {
  Outset outset;
  outset.r = rotation_of(measured.attitude);
  outset.velocity_m_s = outset.r.to_ned(measured.nu.linear);
  outset.bow = bow_of(outset.r);
  outset.too_shallow_m = wanted.vertical == Vertical::altitude
                             ? measured.altitude_m - wanted.altitude_m
                             : wanted.position_m.z - measured.position_m.z;
  const OwnMotion own = own_motion(measured.position_m, outset.r, outset.velocity_m_s);
  const Triple<double> wish = wanted_velocity(a, measured, wanted, outset);
  Wish wished{planar(wish), wish.z};
  if (wanted.target != Target::cruise) wished.place_m = planar(wanted.position_m);
  if (wanted.target == Target::path) wished.place_m_s = planar(wanted.velocity_m_s);
  const ClearWay way = clear_way(handling, stand_off, lookout, own, wished, dt_s, state);
  if (way.is_as_wished_aside && way.is_as_wished_in_depth) return wanted;

  Reference clear = wanted;
  if (!way.is_as_wished_aside) {
    const double speed = size_of(way.velocity_m_s);
    const Planar course = unit_of(way.velocity_m_s, own.bow);
    const bool circles = handling.manner == Manner::circles;
    clear.vertical = Vertical::depth;
    clear.position_m.z = measured.position_m.z + outset.too_shallow_m;
    clear.velocity_m_s = {};
    if (circles || way.only_turns) {
      const double ahead = circles ? speed_ahead_m_s(a, wanted) : 0;
      const Planar bow =
          circles && !(speed > 0) ? circling_course(handling, a, own, ahead) : course;
      clear.target = Target::cruise;
      clear.heading = {bow.north, bow.east};
      clear.velocity_m_s.x = ahead;
    } else {
      const Planar place = own.position_m + distance_for_m(a, speed) * course;
      clear.target = Target::station;
      clear.position_m.x = place.north;
      clear.position_m.y = place.east;
    }
  }
  if (!way.is_as_wished_in_depth) {
    clear.vertical = Vertical::depth;
    const double depth_m = measured.position_m.z + outset.too_shallow_m;
    // Between two that leave no room, in the middle.
    clear.position_m.z = way.least_depth_m <= way.most_depth_m
                             ? std::clamp(depth_m, way.least_depth_m, way.most_depth_m)
                             : 0.5 * (way.least_depth_m + way.most_depth_m);
    clear.velocity_m_s.z = 0;
  }
  return clear;
}

}  // namespace slackwater::twin

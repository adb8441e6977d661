#include "twin/control/autopilot.h"

#include <algorithm>
#include <string>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "twin/body/lift_and_cross_flow.h"
#include "twin/body/mass_matrix.h"
#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

/// In the order of their importance.
std::vector<WantedAxis> axes_of(VehicleKind kind) {
  switch (kind) {
    case VehicleKind::rov:
      return {{Axis::heave, 0}, {Axis::roll, 0},  {Axis::pitch, 0},
              {Axis::yaw, 1},   {Axis::surge, 2}, {Axis::sway, 2}};
    case VehicleKind::auv:
      return {{Axis::surge, 0}};
    case VehicleKind::uav:
      return {{Axis::heave, 0}, {Axis::roll, 1}, {Axis::pitch, 1}, {Axis::yaw, 2}};
    case VehicleKind::usv:
    case VehicleKind::vessel:
      break;
  }
  return {{Axis::yaw, 0}, {Axis::surge, 1}, {Axis::sway, 1}};
}

void expect_axes(const Autopilot& a, std::initializer_list<Axis> needed, const char* why) {
  for (const Axis axis : needed)
    if (!a.allocation.commands(axis))
      throw Error(ErrorKind::invalid_input, std::string("mounts: ") + why);
}

void expect_steerable(const Autopilot& a) {
  switch (a.kind) {
    case VehicleKind::rov:
      expect_axes(a, {Axis::surge, Axis::sway, Axis::heave, Axis::yaw},
                  "the thrusters of an rov push it ahead, sideways and up and turn it; these do "
                  "not. Add thrusters or choose another kind");
      return;
    case VehicleKind::uav:
      expect_axes(a, {Axis::heave, Axis::roll, Axis::pitch, Axis::yaw},
                  "the rotors of a uav lift it, tilt it and turn it; these do not. Check their "
                  "directions ([0, 0, -1] is up) and that as many turn one way as the other");
      if (a.allocation.most_astern[2] < 1.2 * a.weight_n)
        throw Error(ErrorKind::invalid_input,
                    "mounts: the rotors lift " + std::to_string(a.allocation.most_astern[2]) +
                        " N of a weight of " + std::to_string(a.weight_n) +
                        " N; a multirotor that is to be steered lifts at least 1.2 times its own");
      return;
    case VehicleKind::auv:
      expect_axes(a, {Axis::surge}, "the propeller of an auv pushes it ahead; none does");
      for (const auto& [key, turns_n_m_s2_m2] :
           {std::pair{"rudder", a.rudder_n_m_s2_m2}, {"elevator", a.elevator_n_m_s2_m2}})
        if (!(turns_n_m_s2_m2 > 0))
          throw Error(ErrorKind::invalid_input,
                      std::string(key) +
                          ": an auv is steered by a rudder and an elevator aft of its origin; give "
                          "both, or `fins` for a pair of each, with a negative position_x_m");
      return;
    case VehicleKind::usv:
    case VehicleKind::vessel:
      expect_axes(a, {Axis::surge, Axis::yaw},
                  "the thrusters of a surface craft push it ahead and turn it; these do not. Two "
                  "side by side do both");
  }
}

/// Of the trailing edge, or of `lift` with the moment that the added mass has besides (C_A).
double straightening_kg_m(const Body& body) {
  const double of_edge = body.trailing_edge_kg_m * body.trailing_edge_x_m * body.trailing_edge_x_m;
  const SpeedLift& lift = body.speed_lift;
  if (!lift.is_there) return of_edge;
  const double of_added_mass = lift.without_munk ? 0 : body.added_mass.entry[1][5];
  return std::max(of_edge - lift.n_ur + of_added_mass, 0.0);
}

/// Where thrust and resistance meet.
double speed_of(const Autopilot& a, double thrust_n) {
  const double l = a.linear_damping.linear.x, q = a.quadratic_damping.linear.x;
  if (q > 0) return (std::sqrt(l * l + 4 * q * thrust_n) - l) / (2 * q);
  return l > 0 ? thrust_n / l : 1;
}

/// Nine tenths of what the weaker way of an axis gives.
double most_integral(const Autopilot& a, Axis axis) {
  const auto i = static_cast<std::size_t>(axis);
  return 0.9 * a.allocation.most_either_way(axis) / a.mass.entry[i][i];
}

void close_loops(Autopilot& a) {
  const AutopilotSettings& s = a.settings;
  const double ratio = s.damping_ratio;
  double sideways = most_integral(a, Axis::surge), down = most_integral(a, Axis::heave);
  double turning = most_integral(a, Axis::yaw);
  double tilting = 0;
  if (a.kind == VehicleKind::uav) {
    sideways = 0.9 * a.tan_most_tilt * constants::gravity_m_s2;
    down = 0.5 * constants::gravity_m_s2;
    // A tenth of the weight on the outermost rotor's arm.
    double arm = 0;
    for (std::size_t i = 0; i < a.allocation.mounts; ++i)
      arm = std::max(arm, std::abs(a.allocation.effect[3][i]));
    tilting = 0.1 * a.weight_n * arm / std::max(a.mass.entry[3][3], a.mass.entry[4][4]);
    turning = 2;
  } else if (a.kind == VehicleKind::auv) {
    const auto stalled_n_m = [&](double moment_n_m_s2_m2, const FinPair& fins) {
      return moment_n_m_s2_m2 * fins.stall_rad * s.most_speed_m_s * s.most_speed_m_s;
    };
    turning = stalled_n_m(a.rudder_n_m_s2_m2, a.rudder) / a.mass.entry[5][5];
    tilting = stalled_n_m(a.elevator_n_m_s2_m2, a.elevator) / a.mass.entry[4][4];
    down = 0;
  }
  a.horizontal = loop_of(s.horizontal_period_s, ratio, sideways);
  a.vertical = loop_of(s.vertical_period_s, ratio, down);
  a.heading = loop_of(s.heading_period_s, ratio, turning);
  a.tilt = loop_of(s.tilt_period_s, ratio, tilting);
  a.station_per_s = a.horizontal.outer_per_s;
  if (a.kind != VehicleKind::uav && !a.allocation.commands(Axis::sway))
    a.station_per_s = std::min(a.station_per_s, 0.2 * a.heading.outer_per_s);
}

double square_of(const Triple<double>& t) noexcept { return dot(t, t); }

/// Not the numbers of a broken sensor: any that is not one makes the sum so.
bool is_sound(const Measured& m, const Reference& reference, double dt_s) noexcept {
  const Attitude<double>& q = m.attitude;
  const double turn = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const Course& c = reference.heading;
  const double altitude =
      reference.vertical == Vertical::altitude
          ? m.altitude_m * m.altitude_m + reference.altitude_m * reference.altitude_m
          : 0.0;
  const double far = square_of(m.position_m) + square_of(reference.position_m) + altitude;
  const double fast = square_of(m.nu.linear) + square_of(m.nu.angular) + square_of(m.water_m_s) +
                      square_of(reference.velocity_m_s) + square_of(reference.carried_m_s) +
                      (m.has_log() ? m.log_m_s * m.log_m_s : 0.0);
  const double course = c.north * c.north + c.east * c.east;
  return std::abs(turn - 1) < 0.1 && std::abs(course - 1) < 0.1 && far < 1e14 && fast < 1e8 &&
         dt_s > 0;
}

/// A way through the water as one over ground, for a surface craft that can push every way: as much
/// faster as the water ahead is.
Reference carried(const Autopilot& a, const Measured& measured,
                  const Reference& reference) noexcept {
  if (a.kind == VehicleKind::rov || reference.target != Target::path || reference.is_over_ground ||
      !measured.has_log())
    return reference;
  const double speed = std::sqrt(square_of(reference.velocity_m_s));
  if (!(speed > 1e-6)) return reference;
  Reference over_ground = reference;
  const double share = std::max(1 + (measured.nu.linear.x - measured.log_m_s) / speed, 0.0);
  over_ground.velocity_m_s = share * reference.velocity_m_s;
  return over_ground;
}

Effort resting(const Autopilot& a, const ControlState& state) noexcept {
  Effort effort;
  if (a.kind == VehicleKind::uav)
    effort.thrust_n = allocate(a.allocation, {{0, 0, -a.weight_n}, {}}).thrust_n;
  if (a.kind == VehicleKind::auv) effort.volume_m3 = state.volume_m3;
  return effort;
}

}  // namespace

Course course_of(double bearing_rad) noexcept {
  return {std::cos(bearing_rad), std::sin(bearing_rad)};
}
double bearing_rad(const Course& course) noexcept { return std::atan2(course.east, course.north); }

double most_over_ground_m_s(const Autopilot& autopilot, bool is_over_ground) noexcept {
  const bool is_carried = autopilot.kind != VehicleKind::rov && autopilot.kind != VehicleKind::uav;
  return (is_over_ground && is_carried ? 2 : 1) * autopilot.settings.most_speed_m_s;
}

bool goes_by_ground(const Autopilot& autopilot) noexcept {
  return autopilot.kind == VehicleKind::uav ||
         (autopilot.kind != VehicleKind::auv && autopilot.allocation.commands(Axis::sway));
}

double tightest_turn_m(const Autopilot& a, double speed_m_s) noexcept {
  const double moment_n_m = a.allocation.most_either_way(Axis::yaw);
  Spatial<double> all_of_it;
  all_of_it.angular.z = moment_n_m;
  all_of_it.linear.x = a.allocation.most_ahead[0];
  const Thrusts turning = allocate(a.allocation, all_of_it);
  const double kept_n = turning.share[0] * all_of_it.linear.x;
  const double way_m_s = std::min(speed_m_s, speed_of(a, kept_n));
  const double linear = a.linear_damping.angular.z + a.straightening_kg_m * way_m_s;
  const double quadratic = a.quadratic_damping.angular.z;
  // The root of the smaller terms, that does without the quadratic one.
  const double rate =
      2 * moment_n_m / (linear + std::sqrt(linear * linear + 4 * quadratic * moment_n_m));
  return std::max(way_m_s / rate, speed_m_s / a.settings.most_yaw_rate_rad_s);
}

Autopilot plan_autopilot(const AutopilotSettings& settings, VehicleKind kind, const Body& body,
                         const Actuators& actuators) {
  Autopilot a;
  a.kind = kind;
  a.settings = settings;
  a.allocation = plan_allocation(actuators.mounts, actuators.ranges, axes_of(kind));
  a.mass = sum_of(body.rigid_mass, body.added_mass);
  const auto& added = body.added_mass.entry;
  a.added_mass = {added[0][0], added[1][1], added[2][2]};
  a.lag_s = actuators.lag_s;
  a.linear_damping = body.linear_damping;
  a.quadratic_damping = resistance_along_axes(body);
  a.straightening_kg_m = straightening_kg_m(body);
  a.weight_n = body.mass_kg * constants::gravity_m_s2;
  a.righting_n_m = a.weight_n * (body.centre_of_gravity_m.z - body.centre_of_buoyancy_m.z);
  a.tan_most_tilt = std::tan(settings.most_tilt_rad);
  a.rudder = actuators.rudder;
  a.elevator = actuators.elevator;
  a.trim = actuators.trim;
  const auto moment_n_m_s2_m2 = [&](const FinPair& fins) {
    return -0.5 * body.fluid_density_kg_m3 * fins.area_m2 * fins.lift_slope_per_rad *
           fins.position_x_m;
  };
  a.rudder_n_m_s2_m2 = moment_n_m_s2_m2(a.rudder);
  a.elevator_n_m_s2_m2 = moment_n_m_s2_m2(a.elevator);
  a.displacement_n_m3 = body.fluid_density_kg_m3 * constants::gravity_m_s2;
  expect_steerable(a);
  if (!(a.settings.most_speed_m_s > 0))
    a.settings.most_speed_m_s = 0.95 * speed_of(a, a.allocation.most_ahead[0]);
  close_loops(a);
  return a;
}

Effort effort_of(const Autopilot& a, const Measured& measured, const Reference& reference,
                 double dt_s, ControlState& state) noexcept {
  if (!is_sound(measured, reference, dt_s)) return resting(a, state);
  Outset outset;
  outset.r = rotation_of(measured.attitude);
  outset.velocity_m_s = outset.r.to_ned(measured.nu.linear);
  outset.bow = bow_of(outset.r);
  outset.too_shallow_m = reference.vertical == Vertical::altitude
                             ? measured.altitude_m - reference.altitude_m
                             : reference.position_m.z - measured.position_m.z;
  if (state.is_engaged == 0) {
    // Not astern, whatever the water does to a vehicle that is put in it at rest over ground.
    state.wanted_ahead_m_s =
        std::max(measured.has_log() ? measured.log_m_s : measured.nu.linear.x, 0.0);
    state.wanted_north_m_s = outset.velocity_m_s.x;
    state.wanted_east_m_s = outset.velocity_m_s.y;
    state.wanted_down_m_s = outset.velocity_m_s.z;
    state.is_engaged = 1;
  }
  switch (a.kind) {
    case VehicleKind::auv:
      return steer_by_fins(a, measured, reference, outset, dt_s, state);
    case VehicleKind::uav:
      return steer_by_tilt(a, measured, reference, outset, dt_s, state);
    case VehicleKind::rov:
    case VehicleKind::usv:
    case VehicleKind::vessel:
      break;
  }
  if (goes_by_ground(a))
    return steer_free(a, measured, carried(a, measured, reference), outset, dt_s, state);
  return steer_by_turning(a, measured, reference, outset, dt_s, state);
}

}  // namespace slackwater::twin

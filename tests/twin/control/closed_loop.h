#pragma once
#include <cmath>
#include <filesystem>

#include "tests/support/shared_data.h"
#include "tests/twin/control/craft_for_tests.h"
#include "twin/body/body_dynamics.h"
#include "twin/control/autopilot.h"
#include "twin/vehicle/read_body.h"

namespace slackwater::tests {

/// A vehicle of data/vehicles under its autopilot, with thrusters that give what they are asked for
/// behind a lag, and fins and trim that move as fast as theirs do. Not the simulator: the shortest
/// thing that closes the loop.
struct ClosedLoop {
  twin::Body body;
  twin::Autopilot autopilot;
  double dt_s = 0.05;
  double lag_s = 0.2;
  twin::BodyState<double> state;
  twin::ControlState control;
  twin::Effort effort;
  twin::Triple<double> fluid_m_s;  ///< the current; the wind for a multirotor
  twin::Triple<double> known_m_s;  ///< what the vehicle knows of it
  twin::Triple<double> push_n;     ///< NED, at the origin
  std::array<double, twin::most_mounts> thrust_n{};
  double rudder_rad = 0, elevator_rad = 0, moving_mass_m = 0, volume_m3 = 0;
  double t_s = 0;

  [[nodiscard]] twin::Measured measured() const {
    const twin::Rotation<double> r = twin::rotation_of(state.attitude);
    return {state.position_m, state.attitude,           state.nu,
            known_m_s,        100 - state.position_m.z, state.nu.linear.x - r.to_body(fluid_m_s).x};
  }
  [[nodiscard]] double yaw_rad() const { return twin::euler_angles(state.attitude).yaw_rad; }
  [[nodiscard]] twin::Triple<double> velocity_m_s() const {
    return twin::rotation_of(state.attitude).to_ned(state.nu.linear);
  }
  void step(const twin::Reference& reference) {
    effort = twin::effort_of(autopilot, measured(), reference, dt_s, control);
    actuate();
  }
  void run(const twin::Reference& reference, double time_s) {
    for (const double end_s = t_s + time_s - 1e-9; t_s < end_s;) step(reference);
  }
  void actuate();
};

inline double moved(double value, double wanted, double most) {
  return value + std::clamp(wanted - value, -most, most);
}

inline void ClosedLoop::actuate() {
  using twin::Triple;
  const twin::Rotation<double> r = twin::rotation_of(state.attitude);
  for (std::size_t i = 0; i < autopilot.allocation.mounts; ++i)
    thrust_n[i] += (1 - std::exp(-dt_s / lag_s)) * (effort.thrust_n[i] - thrust_n[i]);
  twin::Forcing<double> forcing;
  forcing.fluid.velocity_m_s = fluid_m_s;
  forcing.tau = twin::wrench_of(autopilot.allocation, thrust_n);
  forcing.tau.linear = forcing.tau.linear + r.to_body(push_n);
  const twin::FinPair& fins = autopilot.rudder;  // the elevator is alike
  if (fins.area_m2 > 0) {
    rudder_rad = moved(rudder_rad, effort.rudder_rad, fins.rate_rad_s * dt_s);
    elevator_rad = moved(elevator_rad, effort.elevator_rad, fins.rate_rad_s * dt_s);
    const Triple<double> flow = state.nu.linear - r.to_body(fluid_m_s);
    const double v = flow.y + fins.position_x_m * state.nu.angular.z;
    const double w = flow.z - fins.position_x_m * state.nu.angular.y;
    const double speed = std::sqrt(dot(flow, flow)) + 1e-9;
    const auto lift = [&](double angle_rad) {
      return 0.5 * body.fluid_density_kg_m3 * fins.area_m2 * speed * speed *
             fins.lift_slope_per_rad * std::clamp(angle_rad, -fins.stall_rad, fins.stall_rad);
    };
    forcing.tau = forcing.tau + twin::force_at(Triple<double>{fins.position_x_m, 0, 0},
                                               Triple<double>{0, -lift(rudder_rad + v / speed),
                                                              lift(elevator_rad - w / speed)});
    const twin::Trim& trim = autopilot.trim;
    moving_mass_m = moved(moving_mass_m, effort.moving_mass_m, trim.travel_rate_m_s * dt_s);
    volume_m3 = moved(volume_m3, effort.volume_m3, trim.volume_rate_m3_s * dt_s);
    forcing.gravity_shift_m = trim.moving_mass_kg / body.mass_kg * moving_mass_m;
    forcing.extra_volume_m3 = volume_m3;
  }
  state = twin::stepped(body, state, forcing, dt_s);
  t_s += dt_s;
}

inline twin::Body body_from_data(const char* id) {
  const Config config =
      Config::load(source_folder() / "data/vehicles" / (std::string(id) + ".yaml"));
  return twin::read_body(config);
}

/// Afloat at the origin, heading north.
inline ClosedLoop afloat(const char* id, twin::VehicleKind kind,
                         const std::vector<twin::Mount>& mounts,
                         const std::vector<twin::ThrustRange>& ranges, double lag_s) {
  ClosedLoop loop;
  loop.body = body_from_data(id);
  loop.lag_s = lag_s;
  loop.autopilot = twin::plan_autopilot(twin::default_autopilot(kind), kind, loop.body,
                                        {mounts, ranges, {}, {}, {}, lag_s});
  loop.state.position_m.z =
      twin::floating_depth_m(loop.body.hull, loop.body.mass_kg, loop.body.fluid_density_kg_m3);
  loop.state.attitude = {1, 0, 0, 0};
  return loop;
}
inline ClosedLoop usv() {
  return afloat("wamv16", twin::VehicleKind::usv, wamv_mounts(), outboard_ranges(), 0.3);
}
/// The waterjets' ranges are of the order of 2 x 1050 kW and the push of 60 kN against a landing.
inline ClosedLoop vessel() {
  return afloat("ctv24", twin::VehicleKind::vessel,
                {{{-11.5, -3.3, 0.5}, {1, 0, 0}}, {{-11.5, 3.3, 0.5}, {1, 0, 0}}},
                {{-30000, 60000, 0}, {-30000, 60000, 0}}, 1.0);
}

/// At a depth of 20 m, heading north, at rest.
inline ClosedLoop bluerov2() {
  ClosedLoop loop;
  loop.body = body_from_data("bluerov2_heavy");
  const auto mounts = bluerov2_mounts();
  const auto ranges = t200_ranges(8);
  loop.autopilot =
      twin::plan_autopilot(twin::default_autopilot(twin::VehicleKind::rov), twin::VehicleKind::rov,
                           loop.body, {mounts, ranges, {}, {}, {}, loop.lag_s});
  loop.state.position_m = {0, 0, 20};
  loop.state.attitude = {1, 0, 0, 0};
  return loop;
}

/// At a depth of 20 m, heading north, at rest; 0.3 s behind its shaft.
inline ClosedLoop lrauv() {
  ClosedLoop loop;
  loop.body = body_from_data("lrauv_tethys");
  loop.dt_s = 0.1;
  loop.lag_s = 0.3;
  const auto mounts = lrauv_mounts();
  const auto ranges = lrauv_ranges();
  loop.autopilot = twin::plan_autopilot(
      twin::default_autopilot(twin::VehicleKind::auv), twin::VehicleKind::auv, loop.body,
      {mounts, ranges, lrauv_fins(), lrauv_fins(), lrauv_trim(), loop.lag_s});
  loop.state.position_m = {0, 0, 20};
  loop.state.attitude = {1, 0, 0, 0};
  return loop;
}

/// Hovering 30 m up, heading north.
inline ClosedLoop x500() {
  ClosedLoop loop;
  loop.body = body_from_data("x500");
  loop.dt_s = 0.004;
  loop.lag_s = 0.02;  // between 12.5 ms up and 25 ms down
  const auto mounts = x500_mounts();
  const auto ranges = x500_ranges();
  loop.autopilot =
      twin::plan_autopilot(twin::default_autopilot(twin::VehicleKind::uav), twin::VehicleKind::uav,
                           loop.body, {mounts, ranges, {}, {}, {}, loop.lag_s});
  loop.state.position_m = {0, 0, -30};
  loop.state.attitude = {1, 0, 0, 0};
  for (std::size_t i = 0; i < 4; ++i) loop.thrust_n[i] = 5.061;
  return loop;
}

}  // namespace slackwater::tests

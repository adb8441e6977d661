#pragma once
#include "twin/body/body_dynamics.h"
#include "twin/step/vehicle_state.h"

namespace slackwater::twin {

template <typename Real>
[[nodiscard]] Real held_within(const Real& value, double low, double high) {
  return smaller_of(larger_of(value, Real{} + low), Real{} + high);
}

/// Moved towards what is wanted by a share of the way, and by at most `most`.
template <typename Real>
[[nodiscard]] Real approached(const Real& value, const Real& wanted, double most,
                              double share = 1) {
  return value + held_within(Real{share * (wanted - value)}, -most, most);
}

/// A force in body axes that a number of the vehicle times a fixed direction gives.
template <typename Real>
[[nodiscard]] Triple<Real> along(const Triple<double>& direction, const Real& size) {
  return {direction.x * size, direction.y * size, direction.z * size};
}

/// Force on a pair of fins in a flow that meets it at `angle_rad` off its chord, with `speed2` the
/// square of its speed: lift across, drag along, the lift held at what it is where the flow leaves
/// it (stall).
template <typename Real>
struct FinForce {
  Real lift_n{};
  Real drag_n{};
};
template <typename Real>
[[nodiscard]] FinForce<Real> fin_force(const FinPair& fins, double density_kg_m3,
                                       const Real& angle_rad, const Real& speed2) {
  const Real coefficient =
      fins.lift_slope_per_rad * held_within(angle_rad, -fins.stall_rad, fins.stall_rad);
  const Real pressure_n = (0.5 * density_kg_m3 * fins.area_m2) * speed2;
  return {pressure_n * coefficient, pressure_n * (fins.drag_factor * (coefficient * coefficient))};
}

/// Rudder (positive: bow to starboard) and elevator (positive: bow up), body axes about the origin,
/// each in the flow of its place along the hull; the angles of attack are small or stalled, so that
/// the sine of the drift stands for it. A fin turned in the wake of its hull may have another lift
/// slope than one that the flow meets aslant: the drift counts by `passive_share`.
template <typename Real>
[[nodiscard]] Spatial<Real> fins_force(const Vehicle& vehicle, const Spatial<Real>& nu_r,
                                       const Real& rudder_rad, const Real& elevator_rad) {
  const double density = vehicle.body.fluid_density_kg_m3;
  const Real u2 = nu_r.linear.x * nu_r.linear.x;
  const Real way = select(nu_r.linear.x < 0.0, Real{} - 1.0, Real{} + 1.0);
  const auto across_at = [&](double x) -> Real { return nu_r.linear.y + x * nu_r.angular.z; };
  const auto down_at = [&](double x) -> Real { return nu_r.linear.z - x * nu_r.angular.y; };
  const auto speed_of = [&](const Real& v, const Real& w) -> Real {
    return square_root(u2 + v * v + w * w) + 1e-9;
  };
  const auto at = [](double x) -> Triple<Real> { return {Real{} + x, Real{}, Real{}}; };

  const double rudder_x = vehicle.rudder.position_x_m;
  const Real v = across_at(rudder_x);
  const Real drift = v / speed_of(v, down_at(rudder_x));
  const FinForce<Real> rudder =
      fin_force(vehicle.rudder, density, Real{rudder_rad + vehicle.rudder.passive_share * drift},
                Real{u2 + v * v});

  const double elevator_x = vehicle.elevator.position_x_m;
  const Real w = down_at(elevator_x);
  const Real sinking = w / speed_of(across_at(elevator_x), w);
  const FinForce<Real> elevator =
      fin_force(vehicle.elevator, density,
                Real{elevator_rad - vehicle.elevator.passive_share * sinking}, Real{u2 + w * w});

  return force_at(at(rudder_x), Triple<Real>{-(way * rudder.drag_n), -rudder.lift_n, Real{}}) +
         force_at(at(elevator_x), Triple<Real>{-(way * elevator.drag_n), Real{}, elevator.lift_n});
}

/// What the thrusters did in a step.
template <typename Real>
struct Propulsion {
  Spatial<Real> force;
  Real power_w{};
  Real fuel_kg_s{};
};

template <typename Real>
[[nodiscard]] Propulsion<Real> propel(const Vehicle& vehicle, const StepPlan& plan,
                                      VehicleState<Real>& state,
                                      const VehicleCommand<Real>& command,
                                      const Spatial<Real>& nu_r, const Real& height_m) {
  Propulsion<Real> out;
  const Real is_on = 1.0 - state.battery.off;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const Mount& mount = vehicle.mount[i];
    const Triple<double>& at = mount.position_m;
    const Triple<Real>& rate = nu_r.angular;
    const Triple<Real> speed{nu_r.linear.x + (rate.y * at.z - rate.z * at.y),
                             nu_r.linear.y + (rate.z * at.x - rate.x * at.z),
                             nu_r.linear.z + (rate.x * at.y - rate.y * at.x)};
    const Triple<double>& axis = mount.direction;
    ThrusterSurroundings<Real> around;
    around.advance_m_s = axis.x * speed.x + axis.y * speed.y + axis.z * speed.z;
    const Triple<Real> across = speed - along(axis, around.advance_m_s);
    around.across_m_s = square_root(dot(across, across));
    around.voltage_v = plan.held_voltage_v > 0 ? Real{} + plan.held_voltage_v : state.bus_voltage_v;
    around.height_m = height_m;
    const Lagged<Real> lag =
        lagged(plan.thruster[mount.kind], state.thruster[i], Real{is_on * command.thruster[i]});
    state.thruster[i] = lag.end;
    ThrusterOutput<Real> thruster = run(thruster_of(vehicle, mount), lag.mean, around);
    // Without a battery behind it a shaft that still turns pushes nothing.
    thruster.thrust_n = is_on * thruster.thrust_n;
    state.thrust_n[i] = thruster.thrust_n;
    const Triple<Real> force = along(axis, thruster.thrust_n) - thruster.drag_n_s_m * across;
    const Triple<Real> lever{at.y * force.z - at.z * force.y, at.z * force.x - at.x * force.z,
                             at.x * force.y - at.y * force.x};
    out.force.linear = out.force.linear + force;
    out.force.angular =
        out.force.angular + lever - along(axis, Real{mount.spin * is_on * thruster.torque_n_m});
    out.power_w = out.power_w + is_on * thruster.power_w;
    out.fuel_kg_s = out.fuel_kg_s + thruster.fuel_kg_s;
  }
  return out;
}

/// Draws the step's power. @return the share of what the thrusters asked for that they had
template <typename Real>
[[nodiscard]] Real feed(const Vehicle& vehicle, const StepPlan& plan, VehicleState<Real>& state,
                        const Real& thrusters_w) {
  const Real one = Real{} + 1.0;
  const Real load_w = thrusters_w + vehicle.hotel_w;
  state.electrical_w = load_w;
  if (plan.held_voltage_v > 0 || !vehicle.battery) {
    state.bus_voltage_v = Real{} + plan.held_voltage_v;
    return one;
  }
  const BatteryOutput<Real> drawn =
      discharge(*vehicle.battery, plan.battery, state.battery, load_w);
  state.bus_voltage_v = drawn.terminal_voltage_v;
  state.current_a = drawn.current_a;
  state.electrical_w = drawn.power_w;
  // What there is goes to the hotel load first.
  const Real left_w = larger_of(drawn.power_w - vehicle.hotel_w, Real{} + 0.0);
  return select(drawn.curtailed > 0.5, left_w / (thrusters_w + 1e-9), one);
}

/// One step of a vehicle: thrusters behind their lag in the water (or air) of the start of the
/// step, the battery that feeds them, fins, wind and tether, then the body under these forces by a
/// Runge-Kutta step.
///
/// Fourth order in the motion of the body, first in what couples it to the rest. No allocation; the
/// same bits for one vehicle and for eight.
template <typename Real>
void step(const Vehicle& vehicle, const StepPlan& plan, VehicleState<Real>& state,
          const VehicleCommand<Real>& command, const Surroundings<Real>& around) {
  const Rotation<Real> r = rotation_of(state.body.attitude);
  const bool flies = vehicle.kind == VehicleKind::uav;
  Forcing<Real> forcing;
  forcing.fluid = around.water;
  const FloatingHull& hull = vehicle.body.hull;
  if (hull.strips > 0) forcing.waves = waves_met(hull, around.at_strips);
  if (flies) {
    forcing.fluid = {};
    forcing.fluid.velocity_m_s = around.wind_m_s;
  }
  const Spatial<Real> nu_r = state.body.nu - water_met(vehicle.body, r, forcing).velocity;
  const Propulsion<Real> pushed =
      propel(vehicle, plan, state, command, nu_r, around.height_above_m);
  const Real had = feed(vehicle, plan, state, pushed.power_w);
  state.drawn_j = state.drawn_j + plan.dt_s * state.electrical_w;
  state.fuel_kg = state.fuel_kg + plan.dt_s * pushed.fuel_kg_s;
  forcing.tau = had * pushed.force;
  forcing.tau.linear = forcing.tau.linear + r.to_body(around.pull_n);
  if (hull.strips > 0) forcing.tau.angular = forcing.tau.angular + r.to_body(around.turn_n_m);
  // Without a battery behind them fins, mass and bladder stay as they are.
  const auto led = [&](const Real& now, const Real& wanted) -> Real {
    return select(state.battery.off > 0.5, now, wanted);
  };
  if (has_fins(vehicle)) {
    const auto turned = [&](const FinPair& fins, double share, const Real& now,
                            const Real& wanted) -> Real {
      return led(now, approached(now, held_within(wanted, -fins.limit_rad, fins.limit_rad),
                                 fins.rate_rad_s * plan.dt_s, share));
    };
    state.rudder_rad =
        turned(vehicle.rudder, plan.rudder_step, state.rudder_rad, command.rudder_rad);
    state.elevator_rad =
        turned(vehicle.elevator, plan.elevator_step, state.elevator_rad, command.elevator_rad);
    forcing.tau = forcing.tau + fins_force(vehicle, nu_r, state.rudder_rad, state.elevator_rad);
  }
  const Trim& trim = vehicle.trim;
  state.moving_mass_m =
      led(state.moving_mass_m,
          approached(state.moving_mass_m,
                     held_within(command.moving_mass_m, -trim.travel_m, trim.travel_m),
                     trim.travel_rate_m_s * plan.dt_s));
  state.volume_m3 =
      led(state.volume_m3,
          approached(state.volume_m3,
                     held_within(command.volume_m3, trim.least_volume_m3, trim.most_volume_m3),
                     trim.volume_rate_m3_s * plan.dt_s));
  forcing.gravity_shift_m = (trim.moving_mass_kg / vehicle.body.mass_kg) * state.moving_mass_m;
  forcing.extra_volume_m3 = state.volume_m3;
  if (!flies) {
    const Triple<Real> wind = r.to_body(around.wind_m_s) - state.body.nu.linear;
    const Triple<double>& c = vehicle.wind_force_n_s2_m2;
    forcing.tau.linear =
        forcing.tau.linear +
        Triple<Real>{c.x * (absolute(wind.x) * wind.x), c.y * (absolute(wind.y) * wind.y), Real{}};
    forcing.tau.angular.z = forcing.tau.angular.z - vehicle.wind_yaw_n_m_s2_m2 * (wind.x * wind.y);
  }
  state.body = stepped(vehicle.body, state.body, forcing, plan.dt_s);
}

}  // namespace slackwater::twin

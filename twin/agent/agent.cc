#include "twin/agent/agent.h"

#include <algorithm>
#include <cmath>

#include "fields/wind/gust.h"
#include "twin/agent/conduct.h"
#include "twin/agent/follow_datum.h"
#include "twin/agent/helm.h"
#include "twin/agent/steer_by_helm.h"
#include "twin/body/body_dynamics.h"
#include "twin/body/frame.h"
#include "twin/body/waves_at_strips.h"
#include "twin/inspection/inspection.h"
#include "twin/tether/tether_dynamics.h"

namespace slackwater::twin {
namespace {

Halt halt_of(SampleStatus status) {
  switch (status) {
    case SampleStatus::outside_area:
      return Halt::outside_area;
    case SampleStatus::outside_time:
      return Halt::outside_time;
    case SampleStatus::land:
    case SampleStatus::below_bed:
      return Halt::aground;
    default:
      return Halt::no_data;
  }
}

bool is_inside_a_structure(const Agent& agent, const Triple<double>& position_m) {
  for (const Structure& structure : agent.water->environment().structures)
    if (signed_distance_m(structure, position_m) < 0) return true;
  return false;
}

Triple<double> at_point(const BodyState<double>& body, const Rotation<double>& r,
                        const Triple<double>& point_m) {
  return body.position_m + r.to_ned(point_m);
}

/// The mean wind at the vehicle with the gusts of its own filter: wakes slow the one and strengthen
/// the other.
bool feel_wind(const Agent& agent, double t_s, AgentState& state, Surroundings<double>& around) {
  const Triple<double> at_m = wind_place_m(*agent.vehicle, state.vehicle.body.position_m);
  const auto wind = agent.water->wind(at_m, t_s);
  if (!has_value(wind.status)) {
    // Forecasts without wind have vehicles in the water all the same.
    if (agent.vehicle->kind != VehicleKind::uav && wind.status == SampleStatus::missing)
      return true;
    halt(state, halt_of(wind.status), t_s);
    return false;
  }
  around.wind_m_s = wind.velocity_m_s;
  if (agent.gusts) {
    const Gust gust = agent.gusts->step(state.gust, state.gust_rng);
    const Vector3<Enu> enu = gust_in_enu(gust, horizontal_of(wind.velocity_m_s));
    const double ratio = agent.water->gust_ratio(at_m, t_s);
    around.wind_m_s = around.wind_m_s + ratio * ned_of(enu);
  }
  return true;
}

bool feel_water(const Agent& agent, double t_s, AgentState& state, const Rotation<double>& r,
                Surroundings<double>& around, Triple<double>& current_m_s) {
  const Vehicle& vehicle = *agent.vehicle;
  const BodyState<double>& body = state.vehicle.body;
  const FloatingHull& hull = vehicle.body.hull;
  const Triple<double> at = at_point(body, r, vehicle.body.centre_of_buoyancy_m);
  // A craft that floats has the current of the water that its hulls are in, and the waves at its
  // strips.
  const CarriedWater& carried = state.coarse.water;
  const WaterSample water =
      agent.coarse && carried.holds > 0.5 ? vehicle_water(carried, t_s)
      : hull.strips > 0
          ? agent.water->current({at.x, at.y, std::max(at.z, 0.0)}, vehicle.body.height_m, t_s)
          : agent.water->water(at, vehicle.body.height_m, t_s);
  if (!has_value(water.status)) {
    // A foundation has no water within: that is what it met, however deep the bed lies.
    const bool is_in_a_pile =
        water.status == SampleStatus::land && is_inside_a_structure(agent, at);
    halt(state, is_in_a_pile ? Halt::struck : halt_of(water.status), t_s);
    return false;
  }
  around.water = water.motion;
  current_m_s = water.current_m_s;
  const SeaRealisation* sea = agent.water->waves();
  if (sea != nullptr && hull.strips > 0) around.at_strips = waves_at_strips(*sea, t_s, hull, body);
  return true;
}

void pull_tether(const Agent& agent, double t_s, const Rotation<double>& r, AgentState& state,
                 Surroundings<double>& around) {
  if (agent.coarse) {  // It has pulled already, see coarse_step.h.
    around.pull_n = state.coarse.pull_n;
    return;
  }
  const BodyState<double>& body = state.vehicle.body;
  const Tether& tether = *agent.tether;
  TetherEnds<double> ends;
  ends.top_m = state.top.at(t_s);
  ends.top_velocity_m_s = state.top.velocity_m_s;
  ends.vehicle_m = at_point(body, r, tether.attachment_m);
  ends.vehicle_velocity_m_s =
      r.to_ned(body.nu.linear + cross(body.nu.angular, tether.attachment_m));
  WaterAtNodes<double> water;
  water.elevation_m = around.water.elevation_m;
  for (std::size_t i = 0; i < tether_nodes; ++i) {
    const Triple<double>& at = i == 0                  ? ends.top_m
                               : i == tether_nodes - 1 ? ends.vehicle_m
                                                       : state.tether.node_m[i - 1];
    const WaterSample sample = agent.water->water(at, 0, t_s);
    // Line that touches the bed has the water of the bed's edge: none.
    if (has_value(sample.status)) water.velocity_m_s[i] = sample.motion.velocity_m_s;
  }
  const TetherPull<double> felt = pull(tether, state.tether, ends, water, agent.plan.dt_s);
  around.pull_n = felt.on_vehicle_n;
  state.top.pull_n = felt.on_top_n;
  state.tether_n = felt.vehicle_tension_n;
  note_line(state.milestones, state.tether.whole, felt.vehicle_tension_n, t_s + agent.plan.dt_s);
  hold_snag(state);
}

/// The stream that carries a vehicle in the water, as well as it knows it: all of it, or what its
/// log shows ahead.
Triple<double> known_stream(const Agent& agent, const Measured& measured,
                            const Triple<double>& current_m_s) {
  if (!agent.navigation || !agent.navigation->steers) return current_m_s;
  if (!measured.has_log()) return {};
  const double ahead_m_s = measured.nu.linear.x - measured.log_m_s;
  return rotation_of(measured.attitude).to_ned({ahead_m_s, 0, 0});
}

/// Whether it swims and has come out of the water altogether, where its propellers push nothing.
bool is_in_the_air(const Agent& agent, const BodyState<double>& body, double elevation_m) {
  return agent.vehicle->kind != VehicleKind::uav && agent.vehicle->body.hull.strips == 0 &&
         !(immersed_share(agent.vehicle->body, body.position_m.z, elevation_m) > 0);
}

/// For the account: what each thruster does at its command. What swims and has come out of the
/// water pushes nothing.
void note_commanded(const Agent& agent, const Surroundings<double>& around, AgentState& state,
                    VehicleCommand<double>& command) {
  if (is_in_the_air(agent, state.vehicle.body, around.water.elevation_m)) command.thruster = {};
  ThrusterSurroundings<double> at_rest;
  at_rest.voltage_v = state.vehicle.bus_voltage_v;
  at_rest.height_m = around.height_above_m;
  Effort effort;
  for (std::size_t i = 0; i < agent.vehicle->mounts; ++i)
    effort.thrust_n[i] = run(thruster_of(*agent.vehicle, i), command.thruster[i], at_rest).thrust_n;
  note_thrust(agent.autopilot->allocation, effort, agent.plan.dt_s, state.thrust);
}

/// By hand: what is not asked for is at rest, but for mass and bladder, which are as they are.
void command_by_hand(const Agent& agent, const Surroundings<double>& around, AgentState& state,
                     VehicleCommand<double>& command) {
  put_asked({}, state.helm.by_hand, state.vehicle, command);
  note_commanded(agent, around, state, command);
}

/// What a table in time has in the place of the autopilot's. @return whether there is one
bool command_by_table(const Agent& agent, const Surroundings<double>& around, AgentState& state,
                      VehicleCommand<double>& command) {
  if (state.helm.is_helmed() || state.conduct.doing != Doing::task) return false;
  const ActuatorsAsked by_table = actuators_asked(agent.mission, state.mission);
  if (by_table.plan == nullptr) return false;
  put_asked(*by_table.plan, *by_table.asked, state.vehicle, command);
  note_commanded(agent, around, state, command);
  if (!by_table.plan->keeps_any()) {
    // What the autopilot asked for meanwhile is nothing that it learned from.
    state.control.is_engaged = 0;
    state.control.kept_north = state.control.kept_east = 0;
  }
  return true;
}

/// Of what swims, while it has power: whether it leaves its depth. Where a table has its actuators
/// and keeps none, that is where it was.
void watch_depth(const Agent& agent, const Reference& reference, double t_s, AgentState& state) {
  if (!(agent.depth_bound_m > 0) || reference.vertical != Vertical::depth) return;
  const bool is_helmed = state.helm.is_helmed() || state.conduct.doing != Doing::task;
  const ActuatorPlan* const table =
      is_helmed ? nullptr : actuators_asked(agent.mission, state.mission).plan;
  const double wanted_m =
      table == nullptr || table->keeps_depth ? reference.position_m.z : Milestones::never;
  note_depth(state.milestones, agent.depth_bound_m, wanted_m, state.vehicle.body.position_m.z, t_s);
}

/// One whose tasks have manoeuvres: while a helm is put over, the autopilot has it no more. Never
/// made part of its caller: of all others the step stays as short as it is.
[[gnu::noinline]] void command_manoeuvring(const Agent& agent, const Measured& measured,
                                           const Reference& reference, const ThrustersMeet& meet,
                                           const Surroundings<double>& around, AgentState& state,
                                           VehicleCommand<double>& command) {
  const ControlState before = state.control;
  const Effort effort =
      effort_of(*agent.autopilot, measured, reference, agent.plan.dt_s, state.control);
  command_effort(*agent.vehicle, effort, meet, command);
  if (command_by_table(agent, around, state, command)) return;
  const auto by_helm = command_by_helm(agent, effort, before, meet, state, command);
  note_thrust(agent.autopilot->allocation, by_helm ? *by_helm : effort, agent.plan.dt_s,
              state.thrust);
}

/// Asks helm or mission, the watch for headway and the autopilot.
/// @return false where the agent halts
bool command_by_autopilot(const Agent& agent, const Lookout& seen, const Measured& measured,
                          const Triple<double>& stream_m_s, double t_s,
                          const Surroundings<double>& around, AgentState& state,
                          VehicleCommand<double>& command) {
  const Asked asked = asked_of(agent, seen, measured, stream_m_s, t_s, state);
  const Reference& reference = asked.reference;
  const bool has_power = std::isnan(state.milestones.power_lost_s);
  if (agent.headway && has_power &&
      has_lost_headway(*agent.headway, reference, way_of(state).route, asked.position_m, t_s,
                       state.headway)) {
    halt(state, Halt::no_headway, t_s);
    return false;
  }
  if (has_power) watch_depth(agent, reference, t_s, state);
  const Rotation<double> r = rotation_of(state.vehicle.body.attitude);
  const ThrustersMeet meet{measured.nu.linear - r.to_body(measured.water_m_s),
                           state.vehicle.bus_voltage_v, around.height_above_m};
  if (!agent.mission.manoeuvres.empty()) {
    command_manoeuvring(agent, asked.measured, reference, meet, around, state, command);
    return true;
  }
  const Effort effort =
      effort_of(*agent.autopilot, asked.measured, reference, agent.plan.dt_s, state.control);
  command_effort(*agent.vehicle, effort, meet, command);
  if (!command_by_table(agent, around, state, command))
    note_thrust(agent.autopilot->allocation, effort, agent.plan.dt_s, state.thrust);
  return true;
}

/// What a fault leaves of the commands.
void lose_thruster(const Agent& agent, double t_s, VehicleCommand<double>& command) {
  if (!agent.conduct) return;
  for (const Fault& fault : agent.conduct->plan.faults)
    if (fault.kind == FaultKind::lost_thruster && fault.is_on(t_s))
      command.thruster[fault.thruster] = 0;
}

/// Its tool works where it is, whatever it knows of that, and its instruments also while somebody
/// else has the helm.
void work_on_surface(const Agent& agent, double t_s, const Rotation<double>& r, AgentState& state) {
  if (!agent.conduct || (!agent.conduct->cleaning && !agent.inspection)) return;
  ConductState& own = state.conduct;
  const bool has_power = std::isnan(state.milestones.power_lost_s);
  const bool is_at_work = own.phase == Phase::work && own.doing == Doing::task && !own.has_ended &&
                          !state.helm.is_helmed() && has_power;
  const BodyState<double>& body = state.vehicle.body;
  if (agent.conduct->cleaning)
    clean(*agent.conduct->cleaning, is_at_work, body.position_m, agent.plan.dt_s, own.cleaning);
  if (agent.inspection)
    inspect(*agent.inspection, is_at_work || (state.helm.is_helmed() && has_power),
            {body.position_m, r, r.to_ned(body.nu.linear), body.nu.angular},
            known_of(agent, state).position_m, t_s, agent.plan.dt_s, state.inspection,
            {agent.water->water_visibility_m(), agent.water->visibility_m(), state.helm.camera});
}

}  // namespace

std::string_view name_of(Halt halt) noexcept {
  switch (halt) {
    case Halt::none:
      return "none";
    case Halt::diverged:
      return "diverged";
    case Halt::outside_area:
      return "outside_area";
    case Halt::outside_time:
      return "outside_time";
    case Halt::aground:
      return "aground";
    case Halt::no_data:
      return "no_data";
    case Halt::struck:
      return "struck";
    case Halt::capsized:
      return "capsized";
    case Halt::no_headway:
      return "no_headway";
  }
  return "unknown";
}

Triple<double> wind_place_m(const Vehicle& vehicle, const Triple<double>& at_m) noexcept {
  if (vehicle.body.hull.strips == 0) return at_m;
  return {at_m.x, at_m.y, -vehicle.wind_height_m};
}

Measured known_of(const Agent& agent, const AgentState& state) {
  if (agent.navigation && agent.navigation->steers) return measured_of(state.navigation.navigator);
  const BodyState<double>& body = state.vehicle.body;
  Measured measured;
  measured.position_m = body.position_m;
  measured.attitude = body.attitude;
  measured.nu = body.nu;
  return measured;
}

bool prepare(const Agent& agent, double t_s, const Lookout& seen, AgentState& state,
             StepInput& input) {
  const Vehicle& vehicle = *agent.vehicle;
  const BodyState<double>& body = state.vehicle.body;
  const Rotation<double> r = rotation_of(body.attitude);
  const bool flies = vehicle.kind == VehicleKind::uav;
  const bool is_blown = flies || vehicle.body.hull.strips > 0;
  // What somebody put there between two steps.
  if (!is_sound(body, state.vehicle.battery.charge)) {
    halt(state, Halt::diverged, t_s);
    return false;
  }
  note_attitude(state.milestones, r, t_s);
  // What swims rights itself, what flies falls on: both go on to what they meet.
  if (vehicle.body.hull.strips > 0 && is_capsized(r)) {
    halt(state, Halt::capsized, t_s);
    return false;
  }
  if ((flies && body.position_m.z > 0) || is_inside_a_structure(agent, body.position_m)) {
    halt(state, Halt::struck, t_s);
    return false;
  }
  work_on_surface(agent, t_s, r, state);
  Surroundings<double>& around = input.around;
  around.water = {};
  around.wind_m_s = {};
  around.pull_n = {};
  around.turn_n_m = state.borne.moment_n_m;
  Triple<double> current_m_s;
  if (!flies && !feel_water(agent, t_s, state, r, around, current_m_s)) return false;
  if (is_blown && !feel_wind(agent, t_s, state, around)) return false;
  around.height_above_m = height_of(body.position_m);
  if (agent.tether) pull_tether(agent, t_s, r, state, around);
  around.pull_n = around.pull_n + state.borne.force_n;
  Measured measured;
  measured.position_m = body.position_m;
  measured.attitude = body.attitude;
  measured.nu = body.nu;
  // As a log that means the waves out.
  if (!flies) measured.log_m_s = body.nu.linear.x - r.to_body(current_m_s).x;
  if (agent.navigation) {
    SensedWater sensed{*agent.water, around.water.elevation_m, t_s};
    sensed.has_gnss = !agent.conduct ||
                      fault_at(agent.conduct->plan.faults, FaultKind::lost_gnss, t_s) == nullptr;
    const Measured taken_for = sense(*agent.navigation, sensed, body, state.navigation);
    if (agent.navigation->steers) measured = taken_for;
  }
  if (agent.autopilot->settings.current_feed_forward) {
    measured.water_m_s = flies ? around.wind_m_s : current_m_s;
    if (!flies && !measured.has_log())
      measured.log_m_s = measured.nu.linear.x - r.to_body(current_m_s).x;
  }
  if (is_by_hand(state.helm.mode)) {
    command_by_hand(agent, around, state, input.command);
  } else if (!command_by_autopilot(agent, seen, measured,
                                   known_stream(agent, measured, current_m_s), t_s, around, state,
                                   input.command)) {
    return false;
  }
  lose_thruster(agent, t_s, input.command);
  state.water_m_s = around.water.velocity_m_s;
  state.elevation_m = around.water.elevation_m;
  state.wind_m_s = around.wind_m_s;
  return true;
}

void halt(AgentState& state, Halt why, double t_s) noexcept {
  state.halt = why;
  state.halted_at_s = t_s;
}

}  // namespace slackwater::twin

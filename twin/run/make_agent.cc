#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/coarse_step.h"
#include "twin/agent/conduct.h"
#include "twin/agent/line_on_deck.h"
#include "twin/body/frame.h"
#include "twin/inspection/inspection.h"
#include "twin/run/set_up.h"
#include "twin/vehicle/hover.h"
#include "twin/vehicle/own_autopilot.h"
#include "twin/vehicle/top_speed.h"

namespace slackwater::twin {
namespace {

Mission mission_of(const Vehicle& vehicle, const Autopilot& autopilot, const ScenarioVehicle& entry,
                   double voltage_v) {
  Mission mission;
  mission.tasks = entry.tasks;
  mission.guidance = guidance_for(autopilot, entry.speed_m_s.value_or(vehicle.cruise_speed_m_s),
                                  entry.is_speed_over_ground);
  for (std::size_t i = 0; i < entry.tasks.size(); ++i) {
    const ScenarioTask& task = entry.tasks[i];
    if (task.table) {
      mission.actuators.resize(entry.tasks.size());
      mission.actuators[i] = plan_actuators(*task.table, vehicle, mission.guidance.speed_m_s);
    }
    if (task.manoeuvre) {
      mission.manoeuvres.resize(entry.tasks.size());
      mission.manoeuvres[i] = plan_manoeuvre(*task.manoeuvre, vehicle, autopilot,
                                             mission.guidance.speed_m_s, voltage_v);
    }
  }
  mission.pursuit.gain_per_s = std::min(mission.pursuit.gain_per_s, autopilot.station_per_s);
  mission.pursuit.most_speed_m_s =
      top_speed_m_s(vehicle, autopilot, voltage_v, !(entry.held_voltage_v > 0));
  mission.has_follower =
      entry.follower == FollowerChoice::paper || entry.follower == FollowerChoice::published_code;
  if (mission.has_follower) {
    mission.follower =
        entry.follower == FollowerChoice::paper ? paper_follower() : public_follower();
  }
  return mission;
}

}  // namespace

Agent make_agent(std::shared_ptr<const Vehicle> vehicle,
                 std::shared_ptr<const EnvironmentSampler> water, const ScenarioVehicle& entry,
                 double barrier_s) {
  Agent agent;
  agent.name = entry.name;
  const double largest_s = std::min(vehicle->largest_step_s, entry.step_s.value_or(1e9));
  agent.steps_per_barrier =
      static_cast<std::size_t>(std::max(1.0, std::ceil(barrier_s / largest_s - 1e-9)));
  agent.plan = plan_step(*vehicle, barrier_s / static_cast<double>(agent.steps_per_barrier),
                         entry.held_voltage_v);
  AutopilotSettings settings = vehicle->autopilot;
  if (entry.follower == FollowerChoice::no_feed_forward) settings.current_feed_forward = false;
  const double voltage_v =
      entry.held_voltage_v > 0 ? entry.held_voltage_v : usual_voltage_v(*vehicle);
  if (!(entry.held_voltage_v > 0) && !vehicle->battery && voltage_v > 0)
    throw Error(
        ErrorKind::invalid_input,
        formatted("hold_bus_v: missing; the {} has no battery, and its thrusters run on {:g} "
                  "V: give the one in its file, or the other here",
                  vehicle->name, voltage_v));
  agent.autopilot = std::make_shared<const Autopilot>(own_autopilot(*vehicle, settings, voltage_v));
  agent.mission = mission_of(*vehicle, *agent.autopilot, entry, voltage_v);
  // What circles for ever by design, or hangs on a tether, is not what water carries off.
  if (!agent.mission.has_follower && !entry.tether)
    agent.headway = headway_watch_of(agent.mission, *agent.autopilot);
  if (entry.tether) {
    if (!vehicle->tether) {
      throw Error(ErrorKind::invalid_input,
                  "a " + vehicle->name + " has no tether; leave `tether` out");
    }
    agent.tether = vehicle->tether;
    if (entry.tether->top_m) agent.tether_top_m = *entry.tether->top_m;
  }
  if (entry.navigates_by_sensors || entry.logs_sensors) {
    const Sensors& sensors = vehicle->sensors;
    // Only looked at, a vehicle without the instruments for it has nothing to show.
    if (entry.navigates_by_sensors || (sensors.imu && sensors.compass))
      agent.navigation = plan_navigation(*vehicle, agent.plan.dt_s, entry.navigates_by_sensors);
  }
  const bool swims = vehicle->kind != VehicleKind::uav && vehicle->body.hull.strips == 0;
  if (entry.depth_bound_m > 0 && !swims)
    throw Error(ErrorKind::invalid_input,
                "depth_bound_m: a " + vehicle->name + " keeps no depth; leave it out");
  agent.depth_bound_m = entry.depth_bound_m;
  if (entry.detail == StepDetail::coarse) {
    if (!swims) {
      throw Error(ErrorKind::invalid_input,
                  "detail: coarse is for what swims under water; a " + vehicle->name +
                      " meets wind or waves at each step: leave `detail` out");
    }
    agent.coarse =
        plan_coarse(agent.plan.dt_s, water->waves(), entry.tether ? entry.tether->length_m : 0);
  }
  agent.vehicle = std::move(vehicle);
  agent.water = std::move(water);
  if (entry.carrier) agent.deck_m = entry.carrier->deck_m;
  if (entry.conduct) {
    agent.conduct = std::make_shared<const ReadyConduct>(
        ready_conduct(*entry.conduct, agent, entry.start_m, barrier_s, voltage_v));
  }
  return agent;
}

AgentState first_state(const Agent& agent, const ScenarioVehicle& entry, std::uint64_t seed) {
  const Vehicle& vehicle = *agent.vehicle;
  AgentState state;
  Triple<double> start_m = entry.start_m;
  if (vehicle.body.hull.strips > 0) {
    // Afloat, whatever the file says of its height.
    start_m.z =
        floating_depth_m(vehicle.body.hull, vehicle.body.mass_kg, vehicle.body.fluid_density_kg_m3);
  }
  state.vehicle = placed(vehicle, start_m, entry.heading_rad, entry.state_of_charge);
  state.vehicle.body.nu.linear.x =
      std::min(entry.start_speed_m_s, agent.mission.pursuit.most_speed_m_s);
  if (agent.plan.held_voltage_v > 0) state.vehicle.bus_voltage_v = agent.plan.held_voltage_v;
  // In the air, its rotors turn.
  if (vehicle.kind == VehicleKind::uav)
    state.vehicle.thruster =
        hovering_thrusters(vehicle, state.vehicle.bus_voltage_v, height_of(start_m));
  state.gust_rng = Rng(seed, "twin/gust/" + agent.name);
  if (agent.gusts) state.gust = agent.gusts->stationary_state(state.gust_rng);
  Measured measured;
  measured.position_m = start_m;
  measured.attitude = state.vehicle.body.attitude;
  if (agent.navigation) {
    state.navigation = begun(*agent.navigation, seed, agent.name, state.vehicle.body);
    if (agent.navigation->steers) measured = measured_of(state.navigation.navigator);
  }
  state.mission = begun(measured);
  state.helm.start_m = start_m;
  if (agent.tether) {
    state.top.place_m = agent.tether_top_m;
    state.tether.length_m = entry.tether->length_m;
    // From a deck it hangs as soon as that is known.
    if (entry.tether->top_m) hang_line(agent, 0, state);
  }
  if (agent.inspection) state.inspection = begin_inspection(*agent.inspection, seed);
  if (agent.conduct) state.conduct = begun(*agent.conduct, agent, state, seed);
  return state;
}

}  // namespace slackwater::twin

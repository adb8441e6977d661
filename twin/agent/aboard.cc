#include "twin/agent/aboard.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "twin/agent/line_on_deck.h"

namespace slackwater::twin {
namespace {

/// As slow as a crane's hook or a landing pad takes it: an estimate.
constexpr double boarding_speed_m_s = 1;

Triple<double> velocity_of(const BodyState<double>& body) {
  return rotation_of(body.attitude).to_ned(body.nu.linear);
}

Triple<double> deck_velocity(const AgentState* carrier) {
  return carrier == nullptr ? Triple<double>{} : velocity_of(carrier->vehicle.body);
}

/// Its home where it has no carrier.
Triple<double> boarding_place_by(const Agent& agent, const AgentState* carrier) {
  if (carrier == nullptr) return agent.conduct->home_m;
  return boarding_place(agent, deck_place(agent, *carrier));
}

void stand(const Triple<double>& place_m, AgentState& state) {
  BodyState<double>& body = state.vehicle.body;
  const EulerAngles angles = euler_angles(body.attitude);
  body.position_m = place_m;
  body.attitude = attitude_of({0, 0, angles.yaw_rad});
  body.nu = {};
  state.vehicle.thrust_n = {};
  state.vehicle.electrical_w = 0;
  state.vehicle.current_a = 0;
}

void tell(ConductEventKind kind, double t_s, AgentState& state) {
  state.conduct.events.push_back({t_s, kind, Cause::none, 0, 0});
}

void charge(const Battery& battery, double energy_j, double full_j, AgentState& state) {
  const double charge = std::min(state.vehicle.battery.charge + energy_j / full_j, 1.0);
  state.vehicle.battery = rested(battery, charge);
  state.vehicle.bus_voltage_v = rest_voltage_v(battery, state.vehicle.battery);
}

/// Off the deck with the carrier's way on, its controller as new.
void launch(const Agent& agent, const AgentState* carrier, double t_s, AgentState& state) {
  ConductState& own = state.conduct;
  own.is_aboard = false;
  state.control = {};
  BodyState<double>& body = state.vehicle.body;
  if (carrier != nullptr)
    body.nu.linear = rotation_of(body.attitude).to_body(velocity_of(carrier->vehicle.body));
  // What hangs in the air has its rotors turning.
  state.vehicle.thruster = agent.conduct->idle_thruster;
  state.mission.kept_m = body.position_m;
  if (agent.tether && carrier != nullptr) {
    begin_winding(agent, structure_at(agent, body.position_m), body.position_m, own);
    state.top = top_on_deck(agent, *carrier, t_s);
    hang_line(agent, t_s, state);
  }
  tell(ConductEventKind::launched, t_s, state);
}

/// By its way home, by a recovery, or since its work ended there.
bool came_home(const Agent& agent, const AgentState& state) {
  const ConductState& own = state.conduct;
  const auto& tasks = agent.mission.tasks;
  if (own.doing == Doing::way_home) return !own.way.is_rerouted;
  if (state.mission.is_done && !tasks.empty() && tasks.back().phase == Phase::recovery) return true;
  const auto is_there = [&](const Triple<double>& place_m) {
    return length_of(place_m - agent.conduct->home_m) <= boarding_reach_m;
  };
  return is_there(state.vehicle.body.position_m) ||
         (state.mission.is_done && is_there(state.mission.kept_m));
}

}  // namespace

Triple<double> boarding_place(const Agent& agent, const Triple<double>& deck_m) {
  Triple<double> place_m = agent.conduct->home_m;
  place_m.x = deck_m.x;
  place_m.y = deck_m.y;
  if (agent.vehicle->kind == VehicleKind::uav) place_m.z = std::min(deck_m.z, place_m.z);
  return place_m;
}

bool goes_aboard(const Agent& agent) noexcept {
  return agent.carrier ||
         std::any_of(agent.mission.tasks.begin(), agent.mission.tasks.end(),
                     [](const auto& task) { return task.kind == ScenarioTask::Kind::aboard; });
}

bool is_alongside(const Agent& agent, const AgentState* carrier, const AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  if (agent.tether && carrier != nullptr &&
      (state.conduct.is_snagged || carrier->halt != Halt::none))
    return false;
  return length_of(body.position_m - boarding_place_by(agent, carrier)) <= boarding_reach_m &&
         length_of(velocity_of(body) - deck_velocity(carrier)) <= boarding_speed_m_s;
}

void come_aboard(const Agent& agent, double t_s, const AgentState* carrier, AgentState& state) {
  state.conduct.is_aboard = true;
  state.mission.is_rerouted = false;
  state.mission.held_s = 0;
  stand(boarding_place_by(agent, carrier), state);
  if (agent.tether && carrier != nullptr) stow_line(deck_place(agent, *carrier), state);
  tell(ConductEventKind::came_aboard, t_s, state);
}

bool recover(const Agent& agent, double t_s, const AgentState* carrier, AgentState& state) {
  ConductState& own = state.conduct;
  if (own.is_aboard) return false;
  if (goes_aboard(agent)) {
    // What stands on a deck by rights does not hang in the air beside it.
    if (!is_alongside(agent, carrier, state)) return false;
    come_aboard(agent, t_s, carrier, state);
    return true;
  }
  if (!came_home(agent, state)) return false;
  own.is_aboard = true;
  stand(state.vehicle.body.position_m, state);
  if (agent.vehicle->kind != VehicleKind::vessel) tell(ConductEventKind::came_aboard, t_s, state);
  return true;
}

bool is_recovered(const Agent& agent, const ConductState& own) noexcept {
  return own.is_aboard && own.has_ended && !goes_aboard(agent);
}

void put_out(const Agent& agent, double t_s, AgentState& state) {
  launch(agent, nullptr, t_s, state);
}

void keep_boarding_place(const Agent& agent, const AgentState* carrier, AgentState& state) {
  state.conduct.boarding_m = boarding_place_by(agent, carrier);
}

bool carry(const Agent& agent, const AgentState* carrier, AgentState& state) {
  if (carrier == nullptr) return false;
  stand(boarding_place_by(agent, carrier), state);
  return true;
}

bool come_and_go(const Agent& agent, double t_s, const Company& company, AgentState& state) {
  const AgentState* const carrier = company.carrier;
  ConductState& own = state.conduct;
  MissionState& mission = state.mission;
  keep_boarding_place(agent, carrier, state);
  const bool is_moved = own.is_aboard && carry(agent, carrier, state);
  if (own.doing != Doing::task || mission.task >= agent.mission.tasks.size()) return is_moved;
  const ScenarioTask& task = agent.mission.tasks[mission.task];
  if (task.kind != ScenarioTask::Kind::aboard) return is_moved;
  const double tick_s = agent.conduct->plan.tick_s;
  if (!own.is_aboard) {
    if (is_alongside(agent, carrier, state)) {
      come_aboard(agent, t_s, carrier, state);
      return true;
    }
    const BodyState<double>& body = state.vehicle.body;
    const Triple<double> there_m_s = deck_velocity(carrier);
    // Where the carrier will be when the vehicle is there, or nearly.
    const double away_m = length_of(body.position_m - own.boarding_m);
    const double lead_s = std::min(away_m / std::max(agent.mission.guidance.speed_m_s, 0.1), 10.0);
    const Triple<double> meet_m = own.boarding_m + lead_s * there_m_s;
    replace_waypoints(mission, known_of(agent, state),
                      std::vector<Waypoint>{{{meet_m.x, meet_m.y, own.boarding_m.z}, 0, 0}});
    return false;
  }
  mission.has_begun = true;
  mission.held_s += tick_s;
  bool is_filled = false;
  if (task.charger_w > 0 && std::isfinite(task.charger_w) && agent.conduct->full_j > 0) {
    charge(*agent.vehicle->battery, task.charger_w * tick_s, agent.conduct->full_j, state);
    is_filled = true;
  }
  if (mission.held_s < task.hold_s || (task.until_stand_by && !company.carrier_stands_by))
    return is_moved || is_filled;
  if (std::isinf(task.charger_w) && agent.vehicle->battery)
    charge(*agent.vehicle->battery, agent.conduct->full_j, agent.conduct->full_j, state);
  end_task(agent.mission, mission);
  mission.held_s = 0;  // it may stay aboard for its next task, unstepped
  const bool stays =
      mission.is_done || agent.mission.tasks[mission.task].kind == ScenarioTask::Kind::aboard;
  if (!stays) launch(agent, carrier, t_s, state);
  return true;
}

}  // namespace slackwater::twin

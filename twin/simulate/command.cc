#include "twin/simulate/command.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

void apply(const Reroute& reroute, const Agent& agent, AgentState& state) {
  // One that was put where no vehicle can be halts in its next step.
  if (!is_sound(state.vehicle.body, state.vehicle.battery.charge)) return;
  replace_waypoints(state.mission, known_of(agent, state), reroute.waypoints);
}

void apply(const PutVehicle& put, const Agent&, AgentState& state) {
  state.vehicle = put.vehicle;
  state.coarse = {};  // of the water where it was
}

}  // namespace

void expect_sound(const Command& command) {
  const auto* reroute = std::get_if<Reroute>(&command.what);
  if (reroute == nullptr) return;
  for (const auto& [to, speed_m_s, over_ground] : reroute->waypoints)
    expects(std::isfinite(to.x + to.y + to.z + speed_m_s + over_ground),
            "waypoints of a command are finite");
}

void apply(const Command& command, const Agent& agent, AgentState& state) {
  if (state.halt != Halt::none) return;
  std::visit([&](const auto& what) { apply(what, agent, state); }, command.what);
}

}  // namespace slackwater::twin

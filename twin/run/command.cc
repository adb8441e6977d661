#include "twin/run/command.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "twin/agent/aboard.h"
#include "twin/agent/helm.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::twin {
namespace {

constexpr std::array<std::string_view, std::variant_size_v<CommandWhat>> names{
    "waypoints", "put",  "velocity", "thrusters", "hold",    "home",
    "resume",    "host", "spawn",    "camera",    "weather", "actuators"};

/// What is done, with whom and when.
struct Doer {
  double t_s;
  const Agent& agent;
  AgentState& state;

  void operator()(const Reroute& reroute) const {
    take({HelmMode::waypoints, HelmCause::asked});
    replace_waypoints(state.helm.way, known_of(agent, state), reroute.waypoints);
    state.helm.is_loop = reroute.loop && reroute.waypoints.size() > 1;
  }
  void operator()(const SetVelocity& set) const {
    take({HelmMode::velocity, HelmCause::asked});
    state.helm.velocity = set.velocity;
  }
  void operator()(const SetThrusters& set) const {
    take({HelmMode::thrusters, HelmCause::asked});
    ActuatorValues given;
    for (std::size_t i = 0; i < set.share.size(); ++i) given.give(i, set.share[i]);
    state.helm.by_hand = in_units(*agent.vehicle, given, false);
  }
  void operator()(const SetActuators& set) const {
    take({HelmMode::actuators, HelmCause::asked});
    state.helm.by_hand = in_units(*agent.vehicle, set.given, set.is_physical);
  }
  void operator()(const HoldHere& hold) const {
    if (!hold.is_client_lost) return take({HelmMode::hold, HelmCause::asked});
    // Whoever flies its own mission, or is on its way home, needs nobody.
    HelmState& helm = state.helm;
    if (!helm.is_helmed() || helm.mode == HelmMode::home) return;
    if (helm.mode != HelmMode::hold) return take({HelmMode::hold, HelmCause::client_lost});
    helm.cause = HelmCause::client_lost;
    helm.since_s = helm.renewed_s = t_s;
  }
  void operator()(const GoHome&) const { take({HelmMode::home, HelmCause::asked}); }
  void operator()(const Resume&) const {
    state.helm.camera = {};
    give_back(HelmCause::asked, t_s, agent, state);
  }
  void operator()(const PutVehicle& put) const {
    state.vehicle = put.vehicle;
    state.coarse = {};  // of the water where it was
  }
  void operator()(const HostPhysics& host) const {
    state.is_hosted = host.is_hosted;
    state.coarse = {};
  }

  void operator()(const PointCamera& camera) const { state.helm.camera = camera.pointing; }
  // Nothing that is done to one vehicle that is there.
  void operator()(const Spawn&) const {}
  void operator()(const SetWeather&) const {}

  void take(const HelmDue& due) const { take_helm(due, t_s, agent, state); }
};

std::string_view unsoundness_of_actuators(const SetActuators& set, const Vehicle& vehicle) {
  bool has_any = false;
  for (std::size_t i = 0; i < most_channels; ++i) {
    if (!set.given.has(i)) continue;
    has_any = true;
    const auto channel = channel_of(vehicle, i);
    if (!channel) return "actuators of a command are of the vehicle";
    const double value = set.given.value[i];
    if (!std::isfinite(value)) return "an actuator's value is finite";
    if (set.is_physical && !channel->reaches(value))
      return "an actuator's value is within its range";
    if (!set.is_physical && !(std::abs(value) <= 1))
      return "shares of actuators are within -1 and 1";
  }
  return has_any ? "" : "a command of actuators names one at least";
}

bool moves_vehicle(const CommandWhat& what) {
  return std::holds_alternative<PutVehicle>(what) || std::holds_alternative<HostPhysics>(what);
}

}  // namespace

std::string_view name_of(const CommandWhat& what) noexcept { return names[what.index()]; }

bool leads_elsewhere(const CommandWhat& what) noexcept {
  return std::holds_alternative<Reroute>(what) || must_be_renewed(what) ||
         std::holds_alternative<HoldHere>(what);
}

bool must_be_renewed(const CommandWhat& what) noexcept {
  return std::holds_alternative<SetVelocity>(what) || std::holds_alternative<SetThrusters>(what) ||
         std::holds_alternative<SetActuators>(what);
}

std::string_view unsoundness_of(const Command& command, const Agent& agent) noexcept {
  if (const auto* reroute = std::get_if<Reroute>(&command.what)) {
    for (const auto& [to, speed_m_s, over_ground] : reroute->waypoints)
      if (!std::isfinite(to.x + to.y + to.z + speed_m_s + over_ground))
        return "waypoints of a command are finite";
  } else if (const auto* set = std::get_if<SetVelocity>(&command.what)) {
    const auto& [surge, sway, heave, yaw_rate] = set->velocity;
    if (!std::isfinite(surge + sway + heave + yaw_rate)) return "a velocity asked for is finite";
  } else if (const auto* by_hand = std::get_if<SetThrusters>(&command.what)) {
    if (by_hand->share.size() != agent.vehicle->mounts) return "thrusters have a share each";
    for (const double share : by_hand->share)
      if (!(std::abs(share) <= 1)) return "thrusters are within -1 and 1";
  } else if (const auto* set_actuators = std::get_if<SetActuators>(&command.what)) {
    return unsoundness_of_actuators(*set_actuators, *agent.vehicle);
  } else if (const auto* camera = std::get_if<PointCamera>(&command.what)) {
    const auto& [pan_rad, tilt_rad, zoom] = camera->pointing;
    if (!(std::abs(pan_rad) <= most_pan_rad)) return "a camera pans within -180 and 180 degrees";
    if (!(std::abs(tilt_rad) <= most_tilt_rad)) return "a camera tilts within -90 and 90 degrees";
    if (!(zoom >= 1 && zoom <= most_zoom)) return "a camera zooms from 1 to 10";
  }
  return {};
}

void apply(const Command& command, double t_s, const Agent& agent, AgentState& state) {
  if (state.halt != Halt::none) return;
  if (is_recovered(agent, state.conduct)) put_out(agent, t_s, state);
  if (state.conduct.is_aboard) return;
  const bool is_moved = moves_vehicle(command.what);
  // One that was put where no vehicle can be halts in its next step.
  if (!is_moved && !is_sound(state.vehicle.body, state.vehicle.battery.charge)) return;
  if (leads_elsewhere(command.what) && must_come_home(agent, state)) return;
  std::visit(Doer{t_s, agent, state}, command.what);
}

}  // namespace slackwater::twin

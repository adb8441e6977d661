#include "twin/agent/steer_by_helm.h"

#include "twin/state/follow_manoeuvre.h"

namespace slackwater::twin {
namespace {

void forget_turn_and_speed(const ControlState& before, ControlState& control) {
  control.yaw_rad_s2 = before.yaw_rad_s2;
  control.surge_m_s2 = before.surge_m_s2;
  control.north_m_s2 = before.north_m_s2;
  control.east_m_s2 = before.east_m_s2;
}

}  // namespace

std::optional<Effort> command_by_helm(const Agent& agent, const Effort& effort,
                                      const ControlState& before, const ThrustersMeet& meet,
                                      AgentState& state, VehicleCommand<double>& command) {
  if (state.helm.is_helmed() || state.conduct.doing != Doing::task) return std::nullopt;
  const ManoeuvrePlan* const plan = manoeuvre_under_way(agent.mission, state.mission);
  if (plan == nullptr || plan->kind == ManoeuvreKind::steps) return std::nullopt;
  const Allocation& allocation = agent.autopilot->allocation;
  const ManoeuvreState& own = state.mission.manoeuvre;
  Spatial<double> wrench = wrench_of(allocation, effort.thrust_n);
  if (own.leg == 0) {
    note_propulsion(*plan, wrench.linear.x, meet.through_m_s.x, meet.voltage_v, agent.plan.dt_s,
                    state.mission);
    return std::nullopt;
  }
  const double helm = plan->legs[static_cast<std::size_t>(own.leg) - 1].helm;
  wrench.linear.x = own.push_n;
  wrench.linear.y = 0;
  wrench.angular.z = plan->by_rudder ? 0 : helm * plan->most_yaw_n_m;
  Effort held = effort;
  held.thrust_n = allocate(allocation, wrench).thrust_n;
  command_thrusters(*agent.vehicle, held.thrust_n,
                    {{own.advance_m_s, 0, 0}, own.voltage_v, meet.height_m}, command);
  if (plan->by_rudder) command.rudder_rad = helm;
  forget_turn_and_speed(before, state.control);
  return held;
}

}  // namespace slackwater::twin

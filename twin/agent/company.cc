#include "twin/agent/company.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/hung_line.h"

namespace slackwater::twin {
namespace {

/// A vessel that has come to its place and lies there, as it swings in wind and waves: estimates.
constexpr double standing_reach_m = 10;
constexpr double standing_speed_m_s = 0.6;

template <typename Counts>
std::size_t count_to(const Mission& mission, const MissionState& state, const Counts& counts) {
  const std::size_t end = std::min(state.task + 1, mission.tasks.size());
  return static_cast<std::size_t>(std::count_if(
      mission.tasks.begin(), mission.tasks.begin() + static_cast<std::ptrdiff_t>(end), counts));
}

bool begins_a_sortie(const ScenarioTask& task) { return task.until_stand_by; }
bool is_stand_by(const ScenarioTask& task) { return task.kind == ScenarioTask::Kind::stand_by; }

/// Whether a carrier lies at the place of its `stand_by`.
bool stands_by(const Agent& carrier, const AgentState& state) {
  const MissionState& mission = state.mission;
  if (mission.task >= carrier.mission.tasks.size() || !mission.has_begun ||
      !is_stand_by(carrier.mission.tasks[mission.task]) || !moves(state) ||
      state.conduct.doing != Doing::task || state.helm.is_helmed())
    return false;
  const BodyState<double>& body = state.vehicle.body;
  const Triple<double> off_m = body.position_m - mission.kept_m;
  return std::hypot(off_m.x, off_m.y) <= standing_reach_m &&
         std::hypot(body.nu.linear.x, body.nu.linear.y) <= standing_speed_m_s;
}

bool is_back(const Agent& agent, const AgentState& state, std::size_t stand) {
  const auto& tasks = agent.mission.tasks;
  if (!std::any_of(tasks.begin(), tasks.end(), begins_a_sortie)) return true;
  return state.halt != Halt::none || state.conduct.has_ended ||
         (state.conduct.is_aboard && sortie_of(agent.mission, state.mission) > stand);
}

}  // namespace

std::size_t sortie_of(const Mission& mission, const MissionState& state) noexcept {
  return count_to(mission, state, begins_a_sortie);
}

std::size_t stand_of(const Mission& mission, const MissionState& state) noexcept {
  return count_to(mission, state, is_stand_by);
}

Company company_of(std::span<const Agent> agents, std::span<const AgentState> states,
                   std::size_t own, std::span<const std::size_t> carried) {
  Company company;
  if (const auto& by = agents[own].carrier) {
    const Agent& carrier = agents[*by];
    const AgentState& state = states[*by];
    company.carrier = &state;
    company.carrier_is_gone = state.conduct.has_turned || state.halt != Halt::none;
    company.carrier_stands_by =
        stands_by(carrier, state) && stand_of(carrier.mission, state.mission) ==
                                         sortie_of(agents[own].mission, states[own].mission);
  }
  if (carried.empty()) return company;
  const std::size_t stand = stand_of(agents[own].mission, states[own].mission);
  for (const std::size_t i : carried) {
    company.has_line_out = company.has_line_out || has_line_out(agents[i], states[i]);
    company.are_back = company.are_back && is_back(agents[i], states[i], stand);
  }
  return company;
}

}  // namespace slackwater::twin

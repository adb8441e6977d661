#include "twin/run/ready_company.h"

#include <algorithm>

#include "fields/base/error.h"
#include "twin/agent/conduct.h"
#include "twin/agent/line_on_deck.h"
#include "twin/tether/lay_tether.h"

namespace slackwater::twin {
namespace {

std::size_t count_of(const ScenarioVehicle& entry, bool (*counts)(const ScenarioTask&)) {
  return static_cast<std::size_t>(std::count_if(entry.tasks.begin(), entry.tasks.end(), counts));
}

/// That carriers stand by as often as those that they carry wait for it.
void expect_stands(const Scenario& scenario, std::span<const Agent> agents) {
  const auto stands = [](const ScenarioTask& task) {
    return task.kind == ScenarioTask::Kind::stand_by;
  };
  const auto waits = [](const ScenarioTask& task) { return task.until_stand_by; };
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const ScenarioVehicle& entry = scenario.vehicles[i];
    const std::size_t times = count_of(entry, waits);
    if (times == 0) continue;
    const ScenarioVehicle& carrier = scenario.vehicles[*agents[i].carrier];
    const std::size_t found = count_of(carrier, stands);
    if (found < times)
      refuse("vehicle " + entry.name + ": waits " + std::to_string(times) + " times for " +
             carrier.name + " to stand by, which does so " + std::to_string(found) +
             " times; give that as many tasks stand_by");
  }
}

/// Lines that hang from decks: only now it is known where these are.
void hang_from_decks(const Scenario& scenario, std::span<const Agent> agents,
                     std::span<AgentState> states) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const Agent& agent = agents[i];
    if (!agent.tether || !agent.carrier) continue;
    const Agent& carrier = agents[*agent.carrier];
    if (carrier.vehicle->body.hull.strips == 0)
      refuse("vehicle " + agent.name + ": its tether hangs from " + carrier.name + ", a " +
             carrier.vehicle->name + "; let it hang from a craft that floats");
    with_context("vehicle " + agent.name, [&] {
      AgentState& state = states[i];
      state.top = top_on_deck(agent, states[*agent.carrier], 0);
      const double length_m = scenario.vehicles[i].tether->length_m;
      if (!state.conduct.is_aboard) {
        hang_line(agent, 0, state);
        return;
      }
      // As it will be laid when it is launched: what does not reach is refused now.
      Triple<double> beside_m = state.top.place_m;
      beside_m.z = agent.conduct->home_m.z;
      (void)laid_out(*agent.tether, state.top.place_m, beside_m, length_m, {});
      stow_line(state.top.place_m, state);
    });
  }
}

}  // namespace

void ready_company(const Scenario& scenario, std::span<const Agent> agents,
                   std::span<AgentState> states) {
  expect_stands(scenario, agents);
  hang_from_decks(scenario, agents, states);
}

}  // namespace slackwater::twin

#include "twin/rehearse/by_the_limits.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/simulate/conduct.h"

namespace slackwater::twin {
namespace {

constexpr double look_every_s = 600;

bool is_of_the_run(LimitVariable variable) {
  return variable == LimitVariable::deck_motion || variable == LimitVariable::fender_force;
}

/// The middle of what a vehicle does in a phase; nothing where it does nothing.
std::optional<Triple<double>> middle_of(const Mission& mission, Phase phase) {
  Triple<double> sum_m;
  double count = 0;
  for (const ScenarioTask& task : mission.tasks) {
    if (task.phase != phase) continue;
    for (const Waypoint& at : task.waypoints) {
      sum_m = sum_m + at.position_m;
      ++count;
    }
  }
  if (!(count > 0)) return std::nullopt;
  return (1 / count) * sum_m;
}

}  // namespace

LimitsSay by_the_limits(const Scenario& mission, const Surround& surround, UtcTime start,
                        std::span<const std::string> workers) {
  Scenario central = mission;
  central.start = start;
  central.member = 0;
  const ReadyRun ready = set_up(central, surround);
  LimitsSay say;
  for (std::size_t i = 0; i < ready.agents.size(); ++i) {
    const Agent& agent = ready.agents[i];
    const bool counts =
        workers.empty() || std::find(workers.begin(), workers.end(), agent.name) != workers.end();
    if (!agent.conduct || !counts) continue;
    for (const Limit& limit : agent.conduct->plan.limits) {
      if (is_of_the_run(limit.variable)) continue;
      for (std::size_t p = 0; p < phase_count; ++p) {
        const auto phase = static_cast<Phase>(p);
        const auto middle_m = middle_of(agent.mission, phase);
        if (!limit.phases.has(phase) || !middle_m) continue;
        AgentState there = ready.states[i];
        there.vehicle.body.position_m = *middle_m;
        for (double t_s = 0; t_s <= mission.duration_s; t_s += look_every_s) {
          const double value = value_of(limit, agent, t_s, there);
          if (std::isnan(value)) continue;
          const double share = limit.share(value);
          if (!limit.holds(value)) say.allows = false;
          if (!(share > say.share)) continue;
          say.share = share;
          say.binding = agent.name + ": " + text_of(limit) +
                        formatted(", forecast {:.3g} {}", value, word_of(limit.variable).unit);
        }
      }
    }
  }
  return say;
}

}  // namespace slackwater::twin

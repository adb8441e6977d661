#include "twin/rehearse/by_the_limits.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/rehearse/limit_ahead.h"
#include "twin/rehearse/planned_work.h"

namespace slackwater::twin {
namespace {

constexpr double look_every_s = 600;

/// " at 3 m of depth", " at 80 m of height".
std::string height_text(double down_m) {
  return down_m >= 0 ? formatted(" at {:.0f} m of depth", down_m)
                     : formatted(" at {:.0f} m of height", -down_m);
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
    const Triple<double>& agent_start_m = ready.states[i].vehicle.body.position_m;
    for (const Limit& limit : agent.conduct->plan.limits) {
      if (only_a_run_shows(limit.variable)) continue;
      for (std::size_t p = 0; p < phase_count; ++p) {
        const auto phase = static_cast<Phase>(p);
        if (!limit.phases.has(phase)) continue;
        const auto reach = reach_in(agent_start_m, agent.mission, phase);
        if (!reach) continue;
        const auto places_m = places_of(limit, *reach, surround.field->snapshot().depth_m);
        const auto bows = bows_of(limit, *reach);
        AgentState there = ready.states[i];
        for (double t_s = 0; t_s <= mission.duration_s; t_s += look_every_s) {
          const WorstValue worst = worst_at(limit, agent, places_m, bows, t_s, there);
          const double value = worst.value, bound = worst.bound_of(limit);
          if (std::isnan(value)) continue;
          const double share = limit.share(value, bound);
          if (!limit.holds(value, bound)) say.allows = false;
          if (!(share > say.share)) continue;
          say.share = share;
          say.binding = text_of(limit) + " (" + agent.name + ")" +
                        formatted(", forecast {:.3g} {}", value, word_of(limit.variable).unit) +
                        (places_m.size() > 1 ? height_text(worst.place_m.z) : "") +
                        (limit.table ? ", the limit " + text_of(*limit.table, *worst.by_sea) : "");
        }
      }
    }
  }
  return say;
}

}  // namespace slackwater::twin

#include "twin/agent/line_on_deck.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "twin/agent/hung_line.h"
#include "twin/tether/lay_tether.h"

namespace slackwater::twin {
namespace {

/// Steady water looked up each half metre down and taken in a straight line between: a line is
/// moved hundreds of times before it is at rest.
SteadyWater tabulated(const SteadyWater& water, double deepest_m) {
  constexpr double step_m = 0.5;
  std::vector<Triple<double>> at;
  for (double depth_m = 0; depth_m < deepest_m + step_m; depth_m += step_m)
    at.push_back(water(depth_m));
  return [at = std::move(at)](double depth_m) {
    const double last = static_cast<double>(at.size() - 1);
    const double place = std::clamp(depth_m / step_m, 0.0, last);
    const auto above = std::min(static_cast<std::size_t>(place), at.size() - 2);
    const double share = place - static_cast<double>(above);
    return (1 - share) * at[above] + share * at[above + 1];
  };
}

}  // namespace

TetherState<double> hung_out(const Agent& agent, const Triple<double>& top_m,
                             const Triple<double>& end_m, double length_m, double t_s) {
  const SteadyWater found_m_s = [&](double depth_m) {
    // No water at the bed and beyond: the line lies still there.
    return agent.water->current({end_m.x, end_m.y, depth_m}, 0, t_s).current_m_s;
  };
  const TetherState<double> laid =
      laid_out(*agent.tether, top_m, end_m, length_m, found_m_s(end_m.z));
  if (!agent.coarse) return hung(*agent.tether, laid, top_m, end_m, found_m_s);
  // No node hangs deeper.
  const double deepest_m = std::max({top_m.z, end_m.z, 0.0}) + 0.5 * length_m;
  return hung_roughly(*agent.tether, laid, top_m, end_m, tabulated(found_m_s, deepest_m));
}

Triple<double> deck_place(const Agent& agent, const AgentState& carrier) {
  const BodyState<double>& body = carrier.vehicle.body;
  return body.position_m + rotation_of(body.attitude).to_ned(agent.deck_m);
}

LineTop top_on_deck(const Agent& agent, const AgentState& carrier, double t_s) {
  LineTop top;
  top.place_m = deck_place(agent, carrier);
  top.since_s = t_s;
  const BodyState<double>& body = carrier.vehicle.body;
  if (moves(carrier))
    top.velocity_m_s =
        rotation_of(body.attitude).to_ned(body.nu.linear + cross(body.nu.angular, agent.deck_m));
  return top;
}

void move_tops(std::span<const Agent> agents, std::span<AgentState> states, double t_s) {
  for (std::size_t i = 0; i < agents.size(); ++i)
    if (agents[i].tether && agents[i].carrier) states[*agents[i].carrier].borne = {};
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const Agent& agent = agents[i];
    if (!agent.tether || !agent.carrier) continue;
    AgentState& carrier = states[*agent.carrier];
    const Triple<double> pull_n = states[i].top.pull_n;
    states[i].top = top_on_deck(agent, carrier, t_s);
    states[i].top.pull_n = pull_n;
    if (!has_line_out(agent, states[i])) continue;
    const Triple<double> lever_m = states[i].top.place_m - carrier.vehicle.body.position_m;
    carrier.borne.force_n = carrier.borne.force_n + pull_n;
    carrier.borne.moment_n_m = carrier.borne.moment_n_m + cross(lever_m, pull_n);
  }
}

void hang_line(const Agent& agent, double t_s, AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  const Triple<double> end_m =
      body.position_m + rotation_of(body.attitude).to_ned(agent.tether->attachment_m);
  const double whole = state.tether.whole;
  state.tether = hung_out(agent, state.top.at(t_s), end_m, state.tether.length_m, t_s);
  state.tether.whole = whole;
}

void stow_line(const Triple<double>& deck_m, AgentState& state) {
  state.tether.node_m.fill(deck_m);
  state.tether.velocity_m_s = {};
  state.tether.tension_n = {};
  state.tether_n = 0;
  state.top.pull_n = {};
  state.coarse = {};
}

}  // namespace slackwater::twin

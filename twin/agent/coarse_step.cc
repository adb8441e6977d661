#include "twin/agent/coarse_step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "twin/tether/long_step.h"

namespace slackwater::twin {
namespace {

constexpr double longest_pull_s = 0.1;
constexpr double longest_look_s = 0.5;
constexpr double looks_in_period = 10;
constexpr double pulls_in_period = 20;
/// A node that goes a metre a second turns its segment by 0.04 rad in a pull, not more.
constexpr double fastest_turn_m_s = 25;
constexpr double longest_period_s = 30;  ///< beyond, the period asks for nothing

double mean_period_s(const SeaRealisation& sea) {
  double variance = 0, curvature = 0;
  for (const WaveComponent& wave : sea.waves()) {
    const double share = wave.amplitude_m * wave.amplitude_m;
    variance += share;
    curvature += share * wave.absolute_rad_s * wave.absolute_rad_s;
  }
  // A calm sea, or one that stands still.
  if (!(curvature > 0)) return longest_period_s;
  return 2 * constants::pi * std::sqrt(variance / curvature);
}

/// The largest whole number of parts within a whole, at least one.
double parts_within(double whole, double part) {
  return std::max(1.0, std::floor(whole / part + 1e-9));
}

TetherEnds<double> ends_of(const Agent& agent, const AgentState& state, double t_s) {
  const BodyState<double>& body = state.vehicle.body;
  const Rotation<double> r = rotation_of(body.attitude);
  const Triple<double>& at = agent.tether->attachment_m;
  TetherEnds<double> ends;
  ends.top_m = state.top.at(t_s);
  ends.top_velocity_m_s = state.top.velocity_m_s;
  ends.vehicle_m = body.position_m + r.to_ned(at);
  ends.vehicle_velocity_m_s = r.to_ned(body.nu.linear + cross(body.nu.angular, at));
  return ends;
}

MovingPlaces places_of(const Agent& agent, const AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  const Rotation<double> r = rotation_of(body.attitude);
  MovingPlaces places;
  places.vehicle_height_m = agent.vehicle->body.height_m;
  places.at_m[0] = body.position_m + r.to_ned(agent.vehicle->body.centre_of_buoyancy_m);
  places.velocity_m_s[0] = r.to_ned(body.nu.linear);
  if (!agent.tether) return places;
  places.count = carried_places;
  for (std::size_t i = 0; i < tether_inner_nodes; ++i) {
    places.at_m[i + 1] = state.tether.node_m[i];
    places.velocity_m_s[i + 1] = state.tether.velocity_m_s[i];
  }
  return places;
}

void note_pull(const Triple<double>& on_vehicle_n, const Triple<double>& on_top_n,
               double vehicle_tension_n, double t_s, double pull_s, AgentState& state) {
  state.coarse.pull_n = on_vehicle_n;
  state.top.pull_n = on_top_n;
  state.coarse.pulled_to_s = t_s + pull_s;
  state.tether_n = vehicle_tension_n;
  note_line(state.milestones, state.tether.whole, vehicle_tension_n, t_s + pull_s);
  hold_snag(state);
}

void pull_one(const Agent& agent, double t_s, AgentState& state) {
  const double step_s = agent.coarse->pull_s;
  const TetherPull<double> felt = pull_long(*agent.tether, state.tether, ends_of(agent, state, t_s),
                                            node_water(state.coarse.water, t_s),
                                            node_water(state.coarse.water, t_s + step_s), step_s);
  note_pull(felt.on_vehicle_n, felt.on_top_n, felt.vehicle_tension_n, t_s, step_s, state);
}

/// Lanes without a tether go along with the numbers of the first.
void pull_eight(std::span<const Agent> agents, std::span<AgentState> states,
                std::span<const std::size_t> due, double t_s, PullBlock block) {
  const Agent& first = agents[due.front()];
  const double step_s = first.coarse->pull_s;
  TetherBlock tethers;
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    const std::size_t index = due[lane < due.size() ? lane : 0];
    const AgentState& state = states[index];
    put(tethers.state.value, lane, state.tether);
    put(tethers.ends.value, lane, ends_of(agents[index], state, t_s));
    put(tethers.before.value, lane, node_water(state.coarse.water, t_s));
    put(tethers.after.value, lane, node_water(state.coarse.water, t_s + step_s));
  }
  block(*first.tether, tethers, step_s);
  for (std::size_t lane = 0; lane < due.size(); ++lane) {
    AgentState& state = states[due[lane]];
    state.tether = taken(tethers.state.value, lane);
    note_pull(taken(tethers.felt.value.on_vehicle_n, lane),
              taken(tethers.felt.value.on_top_n, lane),
              tethers.felt.value.vehicle_tension_n.lane[lane], t_s, step_s, state);
  }
}

}  // namespace

CoarsePlan plan_coarse(double dt_s, const SeaRealisation* sea, double line_m) noexcept {
  const double period_s = sea == nullptr ? longest_period_s : mean_period_s(*sea);
  const double look_s = std::min(longest_look_s, period_s / looks_in_period);
  const double turned_s = line_m > 0 ? line_m / tether_segments / fastest_turn_m_s : longest_pull_s;
  const double pull_s = std::min({longest_pull_s, period_s / pulls_in_period, turned_s});
  CoarsePlan plan;
  plan.pull_s = dt_s * parts_within(pull_s, dt_s);
  plan.look_s = plan.pull_s * parts_within(look_s, plan.pull_s);
  plan.late_s = 0.5 * dt_s;
  return plan;
}

void make_coarse_step(std::span<const Agent> agents, std::span<AgentState> states,
                      std::span<const std::size_t> which, double t_s, PullBlock block) {
  std::array<std::size_t, block_lanes> due{};
  std::size_t count = 0;
  for (const std::size_t index : which) {
    const Agent& agent = agents[index];
    AgentState& state = states[index];
    if (!agent.coarse || !moves(state)) continue;
    // What is no number is told by `prepare`.
    if (!is_sound(state.vehicle.body, state.vehicle.battery.charge)) continue;
    CarriedWater& water = state.coarse.water;
    // Aboard meanwhile, it comes into other water.
    if (t_s > water.to_s + agent.coarse->late_s) water.looks = 0;
    if (water.looks < 0.5 || t_s > water.to_s - agent.coarse->late_s)
      look_ahead(*agent.water, places_of(agent, state), t_s, agent.coarse->look_s, water);
    if (agent.tether && t_s > state.coarse.pulled_to_s - agent.coarse->late_s) due[count++] = index;
  }
  const std::span<const std::size_t> pulled = std::span(due).first(count);
  if (block != nullptr && count > 1) {
    pull_eight(agents, states, pulled, t_s, block);
  } else {
    for (const std::size_t index : pulled) pull_one(agents[index], t_s, states[index]);
  }
}

}  // namespace slackwater::twin

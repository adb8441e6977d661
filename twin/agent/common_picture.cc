#include "twin/agent/common_picture.h"

#include "twin/agent/agent.h"
#include "twin/agent/hung_line.h"

namespace slackwater::twin {
namespace {

void publish_traffic(const std::vector<TrafficVessel>& vessels, double t_s,
                     std::vector<Passer>& passers) {
  for (const TrafficVessel& vessel : vessels) {
    if (!vessel.is_around) continue;
    const TrackState now = vessel.track.at(t_s);
    if (!now.is_known()) continue;
    const double length_m = vessel.length_m.value_or(50);
    const double beam_m = vessel.beam_m.value_or(0.16 * length_m);
    passers.push_back({planar(now.position_m), planar(now.velocity_m_s), 0.5 * length_m,
                       0.5 * beam_m, -std::min(0.5 * length_m, 60.0), 0.4 * beam_m, vessel.id});
  }
}

}  // namespace

Clearance clearance_of(const Agent& agent, const StandOff& stand_off, const ScenarioVehicle& entry,
                       double barrier_s) {
  const Body& body = agent.vehicle->body;
  const bool floats = body.hull.strips > 0;
  double above_m = 0.5 * body.height_m, below_m = above_m;
  if (floats) {
    double keel_m = 0;
    for (std::size_t i = 0; i < body.hull.strips; ++i)
      keel_m = std::max(keel_m, body.hull.keel_m[i].z);
    above_m = 0.6 * body.radius_m;
    below_m = keel_m + floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3);
  }
  Clearance clearance;
  clearance.handling =
      handling_of(*agent.autopilot, body.radius_m, above_m, below_m, floats, barrier_s);
  clearance.stand_off = stand_off;
  for (const ScenarioTask& task : entry.tasks)
    if (task.follow) clearance.not_of_concern.push_back(task.follow->mmsi);
  return clearance;
}

CommonPicture::CommonPicture(std::span<const Agent> agents) : place_(agents.size()) {
  const auto world_of = [&](const Agent& agent) {
    return std::find_if(worlds_.begin(), worlds_.end(),
                        [&](const World& world) { return world.water == agent.water.get(); });
  };
  for (const Agent& agent : agents) {
    if (!agent.clearance || world_of(agent) != worlds_.end()) continue;
    World& world = worlds_.emplace_back();
    world.water = agent.water.get();
    world.vessels = agent.vessels;
  }
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const auto world = world_of(agents[i]);
    if (world == worlds_.end()) continue;
    place_[i] = {static_cast<std::size_t>(world - worlds_.begin()), world->agents.size()};
    world->agents.push_back(i);
    world->handling.push_back(agents[i].clearance ? agents[i].clearance->handling
                                                  : clearance_of(agents[i], {}, {}, 0).handling);
  }
  for (World& world : worlds_) {
    const std::size_t size = world.agents.size();
    world.craft.resize(size);
    world.nodes.resize(size);
    world.lines.reserve(size);
    world.passers.reserve(size + (world.vessels ? world.vessels->size() : 0));
  }
}

void CommonPicture::publish_craft(std::span<const Agent> agents, std::span<const AgentState> states,
                                  World& world) {
  for (std::size_t i = 0; i < world.agents.size(); ++i) {
    const Agent& agent = agents[world.agents[i]];
    const AgentState& state = states[world.agents[i]];
    const BodyState<double>& body = state.vehicle.body;
    const Rotation<double> r = rotation_of(body.attitude);
    const bool is_halted = state.halt != Halt::none, is_aboard = state.conduct.is_aboard;
    OwnMotion motion = own_motion(body.position_m, r, r.to_ned(body.nu.linear));
    if (is_halted) {
      motion.velocity_m_s = {};
      motion.down_m_s = 0;
    }
    Craft& craft = world.craft[i];
    craft = craft_of(world.handling[i], motion, state.clearance);
    if (agent.carrier) craft.carrier = static_cast<std::ptrdiff_t>(place_[*agent.carrier].in_it);
    craft.obeys = agent.clearance && !is_halted;
    craft.is_there = !is_aboard && (agent.clearance || is_halted);
    if (!agent.clearance && !is_halted && !is_aboard)
      world.passers.push_back({motion.position_m, motion.velocity_m_s, craft.radius_m,
                               craft.radius_m, craft.claim.top_m, craft.claim.bottom_m, 0, true});
    if (!agent.tether || is_aboard) continue;
    world.nodes[i] = hung_line(agent, state);
    world.lines.push_back({world.nodes[i], i, state.tether.whole > 0.5, craft.carrier});
  }
}

void CommonPicture::publish(std::span<const Agent> agents, std::span<const AgentState> states,
                            double t_s) {
  for (World& world : worlds_) {
    world.lines.clear();
    world.passers.clear();
    publish_craft(agents, states, world);
    if (world.vessels) publish_traffic(*world.vessels, t_s, world.passers);
  }
}

Lookout CommonPicture::seen_by(const Agent& agent, std::size_t place) const noexcept {
  if (!agent.clearance) return {};
  const Place& at = place_[place];
  const World& world = worlds_[at.world];
  if (agent.clearance->only_structures)
    return {std::span(world.craft).subspan(at.in_it, 1),
            0,
            agent.water->environment().structures,
            {},
            {}};
  return {world.craft, at.in_it,      agent.water->environment().structures,
          world.lines, world.passers, agent.clearance->not_of_concern};
}

Reference cleared(const Agent& agent, const Lookout& around, const Measured& measured,
                  const Reference& wanted, AgentState& state) noexcept {
  if (!agent.clearance) return wanted;
  const double before_s = state.clearance.changed_s;
  const Reference clear =
      keep_clear(agent.clearance->handling, agent.clearance->stand_off, around, *agent.autopilot,
                 measured, wanted, agent.plan.dt_s, state.clearance);
  if (state.clearance.changed_s != before_s) state.headway = {};
  return clear;
}

}  // namespace slackwater::twin

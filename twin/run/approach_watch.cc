#include "twin/run/approach_watch.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/follow_tracks.h"
#include "twin/agent/hung_line.h"

namespace slackwater::twin {
namespace {

/// What rounding may make of a distance that is left out for being too long.
constexpr double rounding_m = 1e-6;

bool are_joined(std::span<const Agent> agents, std::size_t a, std::size_t b) noexcept {
  return agents[a].carrier == b || agents[b].carrier == a;
}

/// Somebody may have put a vehicle where there is no place.
bool is_place(const Triple<double>& at_m) noexcept {
  return std::isfinite(at_m.x + at_m.y + at_m.z);
}
Triple<double> sound_place(const AgentState& state, const Triple<double>& otherwise_m) noexcept {
  const Triple<double>& at_m = state.vehicle.body.position_m;
  return is_place(at_m) ? at_m : otherwise_m;
}

Triple<double> in_the_plane(const Triple<double>& at_m) noexcept { return {at_m.x, at_m.y, 0}; }

/// From a place to a box: never more than to what is in it.
double distance_to_box_m(const Triple<double>& at, const Triple<double>& low,
                         const Triple<double>& high) noexcept {
  return length_of(Triple<double>{std::max({low.x - at.x, at.x - high.x, 0.0}),
                                  std::max({low.y - at.y, at.y - high.y, 0.0}),
                                  std::max({low.z - at.z, at.z - high.z, 0.0})});
}

}  // namespace

ApproachWatch::ApproachWatch(std::span<const Agent> agents) : going_(agents.size()) {
  for (std::size_t i = 0; i < agents.size(); ++i) {
    const Agent& agent = agents[i];
    auto world = std::find_if(worlds_.begin(), worlds_.end(),
                              [&](const World& w) { return w.water == agent.water.get(); });
    if (world == worlds_.end()) {
      world = worlds_.emplace(worlds_.end());
      world->water = agent.water.get();
    }
    if (!world->vessels) world->vessels = agent.vessels;
    world->by_north.push_back(world->agents.size());
    world->agents.push_back(i);
    followed_.push_back(followed_by(agent));
  }
  for (World& world : worlds_) {
    if (world.vessels) world.passing.resize(world.vessels->size());
    std::size_t lines = 0;
    for (const std::size_t agent : world.agents) lines += agents[agent].tether ? 1 : 0;
    world.lines.reserve(lines);
  }
}

void ApproachWatch::begin(std::span<const AgentState> states, double t_s) {
  from_s_ = t_s;
  for (std::size_t i = 0; i < states.size(); ++i) put(i, states[i]);
  for (World& world : worlds_) {
    std::sort(world.by_north.begin(), world.by_north.end(), [&](std::size_t a, std::size_t b) {
      return going_[world.agents[a]].to_m.x < going_[world.agents[b]].to_m.x;
    });
    for (std::size_t i = 0; i < world.passing.size(); ++i) {
      const TrafficVessel& vessel = (*world.vessels)[i];
      const TrackState at = vessel.track.at(t_s);
      const bool is_known = vessel.is_around && at.is_known();
      world.passing[i] = {at.position_m, at.position_m, vessel.id, is_known, is_known};
    }
  }
}

void ApproachWatch::put(std::size_t agent, const AgentState& state) noexcept {
  Going& going = going_[agent];
  going.from_m = going.to_m = sound_place(state, going.to_m);
  going.spare_m = 0;
}

void ApproachWatch::move(const Look& look, World& world) {
  world.most_way_m = 0;
  for (const std::size_t agent : world.agents) {
    const AgentState& state = look.states[agent];
    Going& going = going_[agent];
    going.from_m = going.to_m;
    going.to_m = sound_place(state, going.from_m);
    going.way_m = length_of(going.to_m - going.from_m);
    going.spare_m -= going.way_m;
    going.is_out = !state.conduct.is_aboard && is_place(state.vehicle.body.position_m);
    // One that halts has come to where it did.
    going.is_going = going.is_out && (state.halt == Halt::none || state.halted_at_s > look.from_s);
    if (going.is_out) world.most_way_m = std::max(world.most_way_m, going.way_m);
  }
  for (std::size_t i = 0; i < world.passing.size(); ++i) {
    Passing& passing = world.passing[i];
    const TrafficVessel& vessel = (*world.vessels)[i];
    if (!vessel.is_around) continue;
    passing.from_m = passing.to_m;
    passing.was_known = passing.is_known;
    const TrackState at = vessel.track.at(look.to_s);
    passing.to_m = at.position_m;
    passing.is_known = at.is_known();
  }
}

/// By insertion: from one barrier to the next few change places.
void ApproachWatch::sort_by_north(World& world) const {
  const auto north = [&](std::size_t place) { return going_[world.agents[place]].to_m.x; };
  for (std::size_t i = 1; i < world.by_north.size(); ++i)
    for (std::size_t j = i; j > 0 && north(world.by_north[j]) < north(world.by_north[j - 1]); --j)
      std::swap(world.by_north[j], world.by_north[j - 1]);
}

void ApproachWatch::meet_one(const Look& look, const World& world, std::size_t place,
                             std::size_t other_place) {
  const std::size_t own_index = world.agents[place], other_index = world.agents[other_place];
  const Going &own = going_[own_index], &other = going_[other_index];
  if (!other.is_out || are_joined(look.agents, own_index, other_index)) return;
  NearestPass& nearest = look.states[own_index].nearest.vehicle;
  const Triple<double> between = other.to_m - own.to_m;
  const double within_m = nearest.distance_m + own.way_m + other.way_m + rounding_m;
  if (dot(between, between) > within_m * within_m) return;
  const LeastOnWay least = least_between(other.from_m - own.from_m, between);
  nearest.take(least.distance_m, look.at_s(least.share), static_cast<double>(other_place));
}

void ApproachWatch::meet_vehicles(const Look& look, const World& world) {
  const std::size_t size = world.by_north.size();
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t place = world.by_north[i];
    const std::size_t agent = world.agents[place];
    const Going& own = going_[agent];
    if (!own.is_going) continue;
    const NearestPass& nearest = look.states[agent].nearest.vehicle;
    const auto is_beyond = [&](std::size_t at) {
      const double apart_m = std::abs(going_[world.agents[world.by_north[at]]].to_m.x - own.to_m.x);
      return apart_m > nearest.distance_m + own.way_m + world.most_way_m + rounding_m;
    };
    for (std::size_t j = i + 1; j < size && !is_beyond(j); ++j)
      meet_one(look, world, place, world.by_north[j]);
    for (std::size_t j = i; j > 0 && !is_beyond(j - 1); --j)
      meet_one(look, world, place, world.by_north[j - 1]);
  }
}

void ApproachWatch::meet_structures(const Look& look, std::size_t agent) {
  Going& own = going_[agent];
  const auto& structures = look.agents[agent].water->environment().structures;
  if (!own.is_going || structures.empty() || own.spare_m > rounding_m) return;
  NearestPass& nearest = look.states[agent].nearest.structure;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const double after_m = signed_distance_m(structures[i], own.to_m);
    least_m = std::min(least_m, after_m);
    if (after_m - own.way_m > nearest.distance_m) continue;
    nearest.take(least_distance_m(structures[i], own.from_m, own.to_m), look.to_s,
                 static_cast<double>(i));
  }
  own.spare_m = least_m - nearest.distance_m;
}

void ApproachWatch::meet_vessels(const Look& look, const World& world) {
  for (const Passing& passing : world.passing) {
    if (!passing.is_known) continue;
    for (const std::size_t agent : world.agents) {
      const Going& own = going_[agent];
      const auto& followed = followed_[agent];
      if (!own.is_going ||
          std::find(followed.begin(), followed.end(), passing.mmsi) != followed.end())
        continue;
      const Triple<double> after_m = in_the_plane(passing.to_m - own.to_m);
      const Triple<double> before_m =
          passing.was_known ? in_the_plane(passing.from_m - own.from_m) : after_m;
      const LeastOnWay least = least_between(before_m, after_m);
      const double share = passing.was_known ? least.share : 1;
      look.states[agent].nearest.vessel.take(least.distance_m, look.at_s(share),
                                             static_cast<double>(passing.mmsi));
    }
  }
}

void ApproachWatch::meet_lines(const Look& look, World& world) {
  world.lines.clear();
  for (std::size_t place = 0; place < world.agents.size(); ++place) {
    const std::size_t agent = world.agents[place];
    if (!has_line_out(look.agents[agent], look.states[agent])) continue;
    Hanging& line = world.lines.emplace_back();
    line.node_m = hung_line(look.agents[agent], look.states[agent]);
    line.owner = agent;
    line.place = place;
    line.low_m = line.high_m = line.node_m.front();
    for (const Triple<double>& node : line.node_m) {
      line.low_m = {std::min(line.low_m.x, node.x), std::min(line.low_m.y, node.y),
                    std::min(line.low_m.z, node.z)};
      line.high_m = {std::max(line.high_m.x, node.x), std::max(line.high_m.y, node.y),
                     std::max(line.high_m.z, node.z)};
    }
  }
  for (const Hanging& line : world.lines)
    for (const std::size_t agent : world.agents) {
      const Going& own = going_[agent];
      if (!own.is_going || agent == line.owner || look.agents[line.owner].carrier == agent)
        continue;
      NearestPass& nearest = look.states[agent].nearest.line;
      if (distance_to_box_m(own.to_m, line.low_m, line.high_m) - own.way_m > nearest.distance_m)
        continue;
      for (std::size_t k = 1; k < tether_nodes; ++k) {
        const LeastOnWay least =
            least_to_piece(own.from_m, own.to_m, line.node_m[k - 1], line.node_m[k]);
        nearest.take(least.distance_m, look.at_s(least.share), static_cast<double>(line.place));
      }
    }
}

void ApproachWatch::look(std::span<const Agent> agents, std::span<AgentState> states, double t_s) {
  const Look look{agents, states, from_s_, t_s};
  for (World& world : worlds_) {
    move(look, world);
    sort_by_north(world);
    meet_vehicles(look, world);
    for (const std::size_t agent : world.agents) meet_structures(look, agent);
    meet_vessels(look, world);
    meet_lines(look, world);
  }
  from_s_ = t_s;
}

}  // namespace slackwater::twin

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/agent/follow_datum.h"
#include "twin/agent/keep_lookout.h"
#include "twin/body/frame.h"
#include "twin/mission/way_round.h"
#include "twin/vehicle/cruise_power.h"
#include "twin/vehicle/hover.h"

namespace slackwater::twin {
namespace {

constexpr double never_s = -std::numeric_limits<double>::infinity();

void expect_faults(const Conduct& plan, const Agent& agent) {
  for (const Fault& fault : plan.faults) {
    if (fault.kind == FaultKind::fouled_tether && !agent.tether)
      refuse("faults: a fouled tether, and the vehicle has none; leave the fault out");
    if (fault.kind == FaultKind::lost_thruster && fault.thruster >= agent.vehicle->mounts)
      refuse(formatted("faults: thruster {} is lost, expected 0 to {}, the vehicle's own",
                       fault.thruster, agent.vehicle->mounts - 1));
    if (fault.kind == FaultKind::lost_gnss && !agent.vehicle->sensors.gnss)
      refuse("faults: lost_gnss, and the vehicle has no receiver; leave the fault out");
  }
}

/// Where its work leads, with the speed on the way to each place; of work that only stays, where it
/// was brought before.
std::vector<Waypoint> way_of_work(const Agent& agent) {
  std::vector<Waypoint> way;
  std::optional<Waypoint> last;
  for (const ScenarioTask& task : agent.mission.tasks) {
    std::vector<Waypoint> places = task.waypoints;
    if (places.empty() && last) places.push_back(*last);
    if (!places.empty()) last = places.back();
    if (task.phase != Phase::work) continue;
    for (Waypoint at : places) {
      if (!(at.speed_m_s > 0)) at.speed_m_s = agent.mission.guidance.speed_m_s;
      way.push_back(at);
    }
  }
  return way;
}

/// Of the hull with the water that moves along: its mass matrix, heave and pitch.
double bow_mass_of(const Agent& agent, const Triple<double>& deck_point_m) {
  const Body& body = agent.vehicle->body;
  const auto at = [&](std::size_t i) {
    return body.rigid_mass.entry[i][i] + body.added_mass.entry[i][i];
  };
  return bow_mass_kg(at(2), at(4), deck_point_m.x);
}

}  // namespace

std::optional<std::size_t> structure_at(const Agent& agent, const Triple<double>& place_m) {
  const auto& structures = agent.water->environment().structures;
  std::optional<std::size_t> nearest;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < structures.size(); ++i) {
    const double distance_m = from_axis(structures[i], place_m).distance_m;
    if (distance_m >= least_m) continue;
    least_m = distance_m;
    nearest = i;
  }
  return nearest;
}

void begin_winding(const Agent& agent, std::optional<std::size_t> worked_at,
                   const Triple<double>& place_m, ConductState& own) {
  own.wound_rad = 0;
  own.worked_at = worked_at.value_or(ConductState::no_structure);
  if (worked_at)
    own.bearing_rad =
        from_axis(agent.water->environment().structures[*worked_at], place_m).bearing_rad;
}

namespace {

bool asks(const BehaviourTree& tree, ConductCondition condition) {
  const auto leaf = static_cast<std::size_t>(condition);
  return std::any_of(tree.nodes().begin(), tree.nodes().end(), [&](const BehaviourNode& node) {
    return (node.kind == NodeKind::condition || node.kind == NodeKind::guard) && node.leaf == leaf;
  });
}

}  // namespace

ReadyConduct ready_conduct(const Conduct& plan, const Agent& agent, const Triple<double>& start_m,
                           double barrier_s, double voltage_v) {
  expect_faults(plan, agent);
  ReadyConduct ready;
  ready.plan = plan;
  ready.home_m = plan.home_m.value_or(start_m);
  ready.steps_per_tick =
      static_cast<std::uint64_t>(std::max(1.0, std::round(plan.tick_s / barrier_s)));
  ready.plan.tick_s = static_cast<double>(ready.steps_per_tick) * barrier_s;
  ready.top_speed_m_s = agent.mission.pursuit.most_speed_m_s;
  constexpr std::size_t speeds = 17;
  ready.speed_step_m_s = ready.top_speed_m_s / (speeds - 1);
  for (std::size_t i = 0; i < speeds; ++i)
    ready.cruise_w.push_back(cruise_power_w(*agent.vehicle, *agent.autopilot, voltage_v,
                                            ready.speed_step_m_s * static_cast<double>(i)));
  if (agent.vehicle->battery && !(agent.plan.held_voltage_v > 0))
    ready.full_j = open_circuit_energy_j(*agent.vehicle->battery, 1, 0);
  ready.idle_thruster = hovering_thrusters(*agent.vehicle, voltage_v, height_of(ready.home_m));
  if (plan.deck_point_m && agent.vehicle->body.hull.strips > 0)
    ready.bow_mass_kg = bow_mass_of(agent, *plan.deck_point_m);
  ready.worked_at = structure_at(agent, start_m);
  ready.datum = datum_source(agent, plan, start_m);
  ready.minds_reserve = asks(plan.behaviour, ConductCondition::reserve_holds);
  if (plan.cleaning)
    ready.cleaning =
        ready_cleaning(*plan.cleaning, agent.water->environment().structures, way_of_work(agent));
  return ready;
}

ConductState begun(const ReadyConduct& conduct, const Agent& agent, const AgentState& state,
                   std::uint64_t seed) {
  ConductState out;
  out.tree = idle_state(conduct.plan.behaviour);
  out.way = state.mission;
  out.left_m = state.vehicle.body.position_m;
  out.exceeded_s.assign(conduct.plan.limits.size(), never_s);
  out.faults.assign(conduct.plan.faults.size(), 0);
  begin_winding(agent, conduct.worked_at, out.left_m, out);
  out.boarding_m = conduct.home_m;
  out.is_aboard = !agent.mission.tasks.empty() &&
                  agent.mission.tasks.front().kind == ScenarioTask::Kind::aboard;
  out.pilot_rng = Rng(seed, "twin/pilot/" + agent.name);
  out.phase = agent.mission.tasks.empty() ? Phase::work : agent.mission.tasks.front().phase;
  // What nobody knows at the start cannot be kept to.
  AgentState at_start = state;
  at_start.conduct = out;
  for (const Limit& limit : conduct.plan.limits) {
    if (limit.may_be_missing || !std::isnan(value_of(limit, agent, 0, at_start))) continue;
    refuse("limits: " + text_of(limit) + ", and " +
           (limit.variable == LimitVariable::deck_motion ||
                    limit.variable == LimitVariable::fender_force
                ? std::string("no deck_point says where; give one to a craft that floats")
                : std::string("the forecast does not serve it there; say if_missing: not_checked "
                              "in the limit") +
                      (!word_of(limit.variable).may_be_assumed
                           ? ""
                           : formatted(", or assume a value, as in --assume {}=...",
                                       word_of(limit.variable).key))));
  }
  begin_look_outs(agent, conduct, seed, out);
  if (conduct.datum) out.datum = begin_datum(*conduct.datum, *conduct.plan.search);
  // What begins in the frame of its datum has learned nothing in another.
  if (drifts(agent.mission, state.mission)) out.frame_m_s = out.datum.velocity_m_s;
  if (conduct.cleaning) out.cleaning = begin_cleaning(*conduct.cleaning);
  out.noisy.noisy_s.reserve(32);
  out.events.reserve(32);
  return out;
}

}  // namespace slackwater::twin

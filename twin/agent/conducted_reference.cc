#include <algorithm>
#include <cmath>

#include "twin/agent/conduct.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

/// The part of it across the way. On a path the place beside the vehicle goes along with it: what
/// one aims ahead of that would only make it faster.
Triple<double> across(const Triple<double>& aim_m, const Reference& reference) {
  const Triple<double>& way = reference.velocity_m_s;
  const double squared = dot(way, way);
  if (reference.target != Target::path || !(squared > 0)) return aim_m;
  return aim_m - (dot(aim_m, way) / squared) * way;
}

/// Where the pilot aims instead of where the plan says.
void let_pilot_aim(const PilotHand& pilot, const Agent& agent, Reference& reference,
                   ConductState& state) {
  const double keep = std::exp(-agent.plan.dt_s / pilot.memory_s);
  const double stir_m = pilot.wander_m * std::sqrt(1 - keep * keep);
  const auto wander = [&](double& aim_m) {
    aim_m = keep * aim_m + stir_m * state.pilot_rng.normal();
  };
  wander(state.aim_m.x);
  wander(state.aim_m.y);
  // What floats has no depth to aim at.
  if (agent.vehicle->body.hull.strips == 0) wander(state.aim_m.z);
  reference.position_m = reference.position_m + across(state.aim_m, reference);
  reference.velocity_m_s = pilot.haste * reference.velocity_m_s;
}

void keep_off_structures(double stand_off_m, const Agent& agent, Reference& reference) {
  for (const Structure& structure : agent.water->environment().structures) {
    const double short_m = stand_off_m - signed_distance_m(structure, reference.position_m);
    if (!(short_m > 0)) continue;
    const FromAxis from = from_axis(structure, reference.position_m);
    reference.position_m.x += short_m * std::cos(from.bearing_rad);
    reference.position_m.y += short_m * std::sin(from.bearing_rad);
  }
}

void keep_in_fence(double fence_m, const Triple<double>& home_m, Reference& reference) {
  const double north = reference.position_m.x - home_m.x, east = reference.position_m.y - home_m.y;
  const double out_m = std::hypot(north, east);
  if (out_m <= fence_m) return;
  reference.position_m.x = home_m.x + fence_m / out_m * north;
  reference.position_m.y = home_m.y + fence_m / out_m * east;
}

/// Shared autonomy: the pilot's motion, kept inside limits.
void keep_inside(const Agent& agent, const ConductState& state, Reference& reference) {
  const ReadyConduct& conduct = *agent.conduct;
  const Envelope& envelope = conduct.plan.envelope;
  const double speed_m_s = length_of(reference.velocity_m_s);
  if (envelope.most_speed_m_s > 0 && speed_m_s > envelope.most_speed_m_s)
    reference.velocity_m_s = (envelope.most_speed_m_s / speed_m_s) * reference.velocity_m_s;
  if (reference.target == Target::cruise) return;
  if (envelope.stand_off_m > 0) keep_off_structures(envelope.stand_off_m, agent, reference);
  // Home is its carrier.
  const Triple<double>& home_m = agent.carrier ? state.boarding_m : conduct.home_m;
  if (envelope.fence_m) keep_in_fence(*envelope.fence_m, home_m, reference);
}

}  // namespace

const MissionState& way_of(const AgentState& state) noexcept {
  if (state.helm.is_helmed()) return state.helm.way;
  return state.conduct.doing == Doing::task ? state.mission : state.conduct.way;
}

Reference conducted_reference(const Agent& agent, const Measured& measured,
                              const MovingFrame& datum, double t_s, AgentState& state) {
  const bool is_at_task = state.conduct.doing == Doing::task;
  Reference reference = next_reference(agent.mission, measured, datum, t_s, agent.plan.dt_s,
                                       is_at_task ? state.mission : state.conduct.way);
  // Whoever holds or comes home does so by itself.
  if (!agent.conduct || !is_at_task) return reference;
  const Conduct& plan = agent.conduct->plan;
  const bool comes_aboard =
      state.mission.task < agent.mission.tasks.size() &&
      agent.mission.tasks[state.mission.task].kind == ScenarioTask::Kind::aboard;
  if (plan.autonomy == Autonomy::automatic || comes_aboard) return reference;
  let_pilot_aim(plan.pilot, agent, reference, state.conduct);
  if (plan.autonomy != Autonomy::shared) return reference;
  // Structures and fences are of the ground.
  const Triple<double> offset_m = state.mission.offset_m;
  reference.position_m = reference.position_m + offset_m;
  keep_inside(agent, state.conduct, reference);
  reference.position_m = reference.position_m - offset_m;
  return reference;
}

}  // namespace slackwater::twin

#include "twin/agent/follow_datum.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/helm.h"
#include "twin/agent/keep_lookout.h"
#include "twin/body/frame.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

constexpr double wind_up_m = 10;

bool has_drifting_task(const Agent& agent) {
  return std::any_of(agent.mission.tasks.begin(), agent.mission.tasks.end(),
                     [](const ScenarioTask& task) { return task.drifts; });
}

/// The same water as its central member has it.
std::shared_ptr<const EnvironmentSampler> central_of(
    const std::shared_ptr<const EnvironmentSampler>& water) {
  if (water->environment().member == 0) return water;
  Environment central = water->environment();
  central.member = 0;
  return sampler_of(std::make_shared<const Environment>(std::move(central)));
}

/// What is forecast where the datum is; as before where nothing is.
Triple<double> drift_at(const DatumSource& source, const LeewayObject& object,
                        const DatumState& state, double t_s) {
  const Triple<double> at_m = source.last_known_m + state.drifted_at(t_s);
  const CurrentSample current = source.water->forecast_current({at_m.x, at_m.y, 0}, t_s);
  const auto wind = source.water->wind({at_m.x, at_m.y, -wind_up_m}, t_s);
  if (!has_value(current.status) || !has_value(wind.status)) return state.velocity_m_s;
  return expected_drift(object, ned_of(current.velocity_m_s), wind.velocity_m_s);
}

/// How near to a structure it may be, from its face.
double keep_off_m(const Agent& agent) {
  return agent.clearance->stand_off.structure_m + agent.vehicle->body.radius_m;
}

void leave_out_what_is_built_over(const Agent& agent, double t_s, AgentState& state) {
  if (!agent.clearance || !goes_with_datum(agent, state)) return;
  Route& route = state.mission.route;
  const Triple<double> offset_m = datum_frame(agent, state, t_s).offset_m;
  while (state.mission.has_begun && !route.is_done()) {
    const Triple<double> to_m = route.to().position_m + offset_m;
    const Triple<double> away = to_m - state.vehicle.body.position_m;
    const bool is_built_over =
        std::any_of(agent.water->environment().structures.begin(),
                    agent.water->environment().structures.end(), [&](const Structure& structure) {
                      const double near_m = 2 * (keep_off_m(agent) + radius_of(structure));
                      return signed_distance_m(structure, to_m) < keep_off_m(agent) &&
                             std::hypot(away.x, away.y) < near_m;
                    });
    if (!is_built_over) return;
    route.skip();
  }
}

}  // namespace

std::optional<DatumSource> datum_source(const Agent& agent, const Conduct& plan,
                                        const Triple<double>& start_m) {
  if (!plan.search || !has_drifting_task(agent)) return std::nullopt;
  return DatumSource{last_known_m(*plan.search, agent, start_m), central_of(agent.water)};
}

DatumState begin_datum(const DatumSource& source, const PersonSearch& search) {
  DatumState state;
  state.velocity_m_s = drift_at(source, search.drifts, state, 0);
  state.drifted_m = search.elapsed_s * state.velocity_m_s;
  return state;
}

void follow_datum(const Agent& agent, double t_s, AgentState& state) {
  const auto& source = agent.conduct->datum;
  if (!source) return;
  DatumState& datum = state.conduct.datum;
  turn_datum(drift_at(*source, agent.conduct->plan.search->drifts, datum, t_s), t_s, datum);
  leave_out_what_is_built_over(agent, t_s, state);
}

MovingFrame datum_frame(const Agent& agent, const AgentState& state, double t_s) noexcept {
  if (!agent.conduct || !agent.conduct->datum) return {};
  const DatumState& datum = state.conduct.datum;
  return {datum.drifted_at(t_s), datum.velocity_m_s};
}

bool goes_with_datum(const Agent& agent, const AgentState& state) noexcept {
  return !state.helm.is_helmed() && state.conduct.doing == Doing::task &&
         drifts(agent.mission, state.mission);
}

Asked asked_of(const Agent& agent, const Lookout& around, const Measured& measured,
               const Triple<double>& stream_m_s, double t_s, AgentState& state) {
  const MovingFrame datum = datum_frame(agent, state, t_s);
  const Reference wanted = state.helm.is_helmed()
                               ? helm_reference(agent, measured, stream_m_s, state)
                               : conducted_reference(agent, measured, datum, t_s, state);
  const Triple<double>& here_m = state.vehicle.body.position_m;
  Asked asked;
  MovingFrame frame;
  const bool knows_water = agent.autopilot->settings.current_feed_forward;
  if (!goes_with_datum(agent, state)) {
    asked = {measured, cleared(agent, around, measured, wanted, state), here_m};
  } else {
    const double before_s = state.clearance.changed_s;
    asked = {measured, cleared(agent, around, measured, over_ground(datum, wanted), state),
             here_m - datum.offset_m};
    if (state.clearance.changed_s == before_s) {
      frame = datum;
      asked.measured = seen_from(datum, measured, knows_water);
      asked.reference = wanted;
    }
  }
  Triple<double>& before_m_s = state.conduct.frame_m_s;
  if (frame.velocity_m_s.x != before_m_s.x || frame.velocity_m_s.y != before_m_s.y) {
    change_frame(frame.velocity_m_s - before_m_s, knows_water, state.control);
    before_m_s = frame.velocity_m_s;
  }
  return asked;
}

}  // namespace slackwater::twin

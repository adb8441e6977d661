#include "twin/agent/keep_lookout.h"

#include <cmath>
#include <optional>

#include "fields/base/error.h"
#include "twin/agent/conduct.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

constexpr double wind_height_m = 10;

/// Nothing where the forecast does not say it.
std::optional<SearchWater> water_at(const EnvironmentSampler& environment,
                                    const Triple<double>& at_m, double t_s) {
  const WaterSample water = environment.current({at_m.x, at_m.y, 0}, 0, t_s);
  const auto wind = environment.wind({at_m.x, at_m.y, -wind_height_m}, t_s);
  const SeaSample sea = environment.sea({at_m.x, at_m.y, 0}, t_s);
  if (!has_value(water.status) || !has_value(wind.status) || !has_value(sea.status))
    return std::nullopt;
  return SearchWater{water.current_m_s, wind.velocity_m_s, sea.sea.significant_height_m,
                     environment.visibility_m()};
}

Triple<double> noise_m(const MammalDuty& duty, const Agent& agent, const ReadyConduct& conduct,
                       const Triple<double>& start_m) {
  if (duty.noise_m) return *duty.noise_m;
  if (!conduct.worked_at) return start_m;
  const Structure& structure = agent.water->environment().structures[*conduct.worked_at];
  const FromAxis place = from_axis(structure, start_m);
  return {start_m.x - place.distance_m * std::cos(place.bearing_rad),
          start_m.y - place.distance_m * std::sin(place.bearing_rad), 0};
}

void search(const Agent& agent, const PersonSearch& plan, double t_s, AgentState& state) {
  SearchState& own = state.conduct.search;
  if (own.is_lost) return;
  const auto water = water_at(*agent.water, own.person.position_m, t_s);
  if (!water) {
    own.is_lost = true;
    return;
  }
  if (search_on(plan, *water, state.vehicle.body.position_m, moves(state), t_s,
                agent.conduct->plan.tick_s, own))
    state.conduct.events.push_back({t_s, ConductEventKind::found, Cause::none, 0, own.found_at_m});
}

void watch(const Agent& agent, const MammalDuty& duty, double t_s, AgentState& state) {
  const Triple<double>& at_m = state.vehicle.body.position_m;
  const auto wind = agent.water->wind({at_m.x, at_m.y, -wind_height_m}, t_s);
  // Where nobody knows the wind nobody knows how far one sees.
  const bool is_out = moves(state) && has_value(wind.status);
  watch_on(duty, std::hypot(wind.velocity_m_s.x, wind.velocity_m_s.y), at_m, is_out, t_s,
           agent.conduct->plan.tick_s, state.conduct.mammals);
}

}  // namespace

void load_look_outs(Conduct& plan, const std::filesystem::path& data_folder) {
  if (plan.search) load(*plan.search, data_folder);
  if (plan.mammals) load(*plan.mammals, data_folder);
}

Triple<double> last_known_m(const PersonSearch& search, const Agent& agent,
                            const Triple<double>& start_m) {
  if (search.last_known_m) return *search.last_known_m;
  for (const ScenarioTask& task : agent.mission.tasks)
    if (task.phase == Phase::work && !task.waypoints.empty())
      return task.waypoints.front().position_m;
  return start_m;
}

void begin_look_outs(const Agent& agent, const ReadyConduct& conduct, std::uint64_t seed,
                     ConductState& begun) {
  const Triple<double>& start_m = begun.left_m;
  if (const auto& plan = conduct.plan.search) {
    const Triple<double> known_m = last_known_m(*plan, agent, start_m);
    const auto water = water_at(*agent.water, known_m, 0);
    if (!water)
      throw Error(ErrorKind::invalid_input,
                  "search: the forecast has no current, wind or waves at the last known position; "
                  "move it into the water of the forecast");
    begun.search = begin_search(*plan, known_m, *water, seed, agent.name);
  }
  if (const auto& duty = conduct.plan.mammals)
    begun.mammals = begin_duty(*duty, noise_m(*duty, agent, conduct, start_m), seed, agent.name);
}

void keep_lookout(const Agent& agent, double t_s, AgentState& state) {
  const Conduct& plan = agent.conduct->plan;
  if (!(t_s > 0)) return;
  if (plan.search) search(agent, *plan.search, t_s, state);
  if (plan.mammals) watch(agent, *plan.mammals, t_s, state);
}

}  // namespace slackwater::twin

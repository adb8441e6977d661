#include "twin/rehearse/limit_ahead.h"

#include <algorithm>
#include <cmath>

#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

/// Waves of the forecast, and what is assumed, are the same in all members.
bool has_members(LimitVariable variable, const WaveFutures* waves) {
  if (variable == LimitVariable::significant_wave_height) return waves != nullptr;
  return variable != LimitVariable::wave_peak_period && word_of(variable).is_served;
}

/// The water of each member, as the run has that of its own.
std::vector<std::shared_ptr<const EnvironmentSampler>> waters_of(const ReadyRun& ready,
                                                                 std::size_t members) {
  std::vector<std::shared_ptr<const EnvironmentSampler>> waters;
  for (std::size_t m = 0; m < members; ++m) {
    Environment environment = *ready.environment;
    environment.member = m;
    environment.waves = nullptr;  // heights get their error once, in `limits_ahead`
    waters.push_back(sampler_of(std::make_shared<const Environment>(std::move(environment))));
  }
  return waters;
}

/// The worse of two; what nobody knows is the worst.
double worse_of(const Limit& limit, double a, double b) {
  if (std::isnan(a) || std::isnan(b)) return std::nan("");
  return limit.is_least ? std::min(a, b) : std::max(a, b);
}

}  // namespace

bool only_a_run_shows(LimitVariable variable) noexcept {
  return variable == LimitVariable::deck_motion || variable == LimitVariable::fender_force;
}

double value_at(const Limit& limit, const Agent& agent, const Triple<double>& place_m, double t_s,
                AgentState& there) {
  there.vehicle.body.position_m = place_m;
  return value_of(limit, agent, t_s, there);
}

std::vector<Triple<double>> places_of(const Limit& limit, const PhaseReach& reach,
                                      std::span<const double> depth_m) {
  const bool changes_with_height = limit.variable == LimitVariable::wind_speed ||
                                   limit.variable == LimitVariable::gust_speed ||
                                   limit.variable == LimitVariable::current_speed;
  if (limit.down_m || !changes_with_height) return {reach.middle_m};
  if (reach.highest_m.z == reach.lowest_m.z) return {reach.middle_m};
  std::vector<Triple<double>> places_m{reach.highest_m};
  if (limit.variable == LimitVariable::current_speed)
    for (const double level_m : depth_m) {
      if (level_m <= reach.highest_m.z || level_m >= reach.lowest_m.z) continue;
      const double share = (level_m - reach.highest_m.z) / (reach.lowest_m.z - reach.highest_m.z);
      places_m.push_back(reach.highest_m + share * (reach.lowest_m - reach.highest_m));
    }
  places_m.push_back(reach.lowest_m);
  return places_m;
}

std::vector<Course> bows_of(const Limit& limit, const PhaseReach& reach) {
  const bool matters = limit.waves && limit.waves->goes_by_heading();
  return matters ? reach.bows : std::vector<Course>();
}

WorstValue worst_at(const Limit& limit, const Agent& agent,
                    const std::vector<Triple<double>>& places_m, const std::vector<Course>& bows,
                    double t_s, AgentState& there) {
  WorstValue worst{std::nan(""), places_m.front()};
  bool is_unknown = false;
  const auto look = [&](const Limit& at_limit, const Triple<double>& place_m) {
    const double value = value_at(at_limit, agent, place_m, t_s, there);
    if (std::isnan(value)) {
      is_unknown = true;
    } else if (std::isnan(worst.value) ||
               (limit.is_least ? value < worst.value : value > worst.value)) {
      worst = {value, place_m};
    }
  };
  Limit whatever_the_bow = limit;
  if (limit.waves && limit.waves->goes_by_heading() && bows.empty())
    whatever_the_bow.waves->off_bow_rad.reset();
  for (const Triple<double>& place_m : places_m) {
    if (bows.empty()) look(whatever_the_bow, place_m);
    for (const Course& bow : bows) {
      there.vehicle.body.attitude = attitude_of({0, 0, bearing_rad(bow)});
      look(limit, place_m);
    }
  }
  if (is_unknown && limit.holds(worst.value)) worst.value = std::nan("");
  return worst;
}

std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                     const StepClock& clock, std::size_t members,
                                     const WaveFutures* waves) {
  const Agent& planned = ready.agents[agent];
  std::vector<LimitAhead> all;
  if (!planned.conduct) return all;
  const Triple<double>& start_m = ready.states[agent].vehicle.body.position_m;
  const std::vector<Limit>& limits = planned.conduct->plan.limits;
  const std::vector<double>& depth_m = ready.environment->field->snapshot().depth_m;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (only_a_run_shows(limits[i].variable)) continue;
    for (std::size_t p = 0; p < phase_count; ++p) {
      const auto phase = static_cast<Phase>(p);
      if (!limits[i].phases.has(phase)) continue;
      const auto reach = reach_in(start_m, planned.mission, phase);
      if (!reach) continue;
      LimitAhead ahead{
          agent, i, phase, places_of(limits[i], *reach, depth_m), bows_of(limits[i], *reach), {}};
      ahead.members.resize(has_members(limits[i].variable, waves) ? members : 1);
      all.push_back(std::move(ahead));
    }
  }
  const double step_s = std::chrono::duration<double>(clock.step).count();
  const double first_s = seconds_between(ready.start, clock.first);
  const auto waters = waters_of(ready, members);
  Agent living = planned;
  AgentState there = ready.states[agent];
  for (std::size_t m = 0; m < members; ++m) {
    living.water = waters[m];
    for (LimitAhead& ahead : all) {
      if (m >= ahead.members.size()) continue;
      const Limit& limit = limits[ahead.limit];
      const auto value = [&](std::size_t i) {
        const double t_s = first_s + static_cast<double>(i) * step_s;
        const double found = worst_at(limit, living, ahead.places_m, ahead.bows, t_s, there).value;
        const bool is_of_others = limit.waves && found == 0;  // these waves are none to it
        const bool is_spread = waves != nullptr && !is_of_others &&
                               limit.variable == LimitVariable::significant_wave_height;
        return is_spread ? waves->height_m(m, found, clock.time_of(i)) : found;
      };
      std::vector<double>& values = ahead.members[m];
      values.reserve(clock.steps);
      double before = value(0);
      for (std::size_t i = 0; i < clock.steps; ++i) {
        const double after = value(i + 1);
        values.push_back(worse_of(limit, before, after));
        before = after;
      }
    }
  }
  return all;
}

}  // namespace slackwater::twin

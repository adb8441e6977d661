#include "twin/rehearse/limit_ahead.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "twin/agent/conduct.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

bool is_of_waves(LimitVariable variable) {
  return variable == LimitVariable::significant_wave_height;
}

/// How many series a limit has. Waves of the forecast, and what is assumed, are the same in all
/// members; heights that have an error are as many as there are futures of the waves.
std::size_t series_of(LimitVariable variable, std::size_t members, const WaveFutures* waves) {
  if (is_of_waves(variable)) return waves == nullptr ? 1 : waves->futures();
  if (variable == LimitVariable::wave_peak_period || !word_of(variable).is_served) return 1;
  return members;
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

/// The value of each step, the worse of those at its two ends.
std::vector<double> worst_of_steps(const Limit& limit, const std::vector<double>& at_stamps) {
  std::vector<double> values;
  values.reserve(at_stamps.size() - 1);
  for (std::size_t i = 0; i + 1 < at_stamps.size(); ++i)
    values.push_back(worse_of(limit, at_stamps[i], at_stamps[i + 1]));
  return values;
}

/// Heights as forecast, in one future.
std::vector<double> heights_of(const Limit& limit, std::vector<double> heights_m,
                               std::size_t future, const WaveFutures& waves,
                               const std::vector<WaveFutures::Moment>& moments) {
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    const bool is_of_others = limit.waves && heights_m[i] == 0;  // these waves are none to it
    if (!is_of_others) heights_m[i] = waves.height_m(future, heights_m[i], moments[i]);
  }
  return heights_m;
}

/// Of heights with the bounds of a table at the same stamps; without these as they are.
std::vector<double> shares_of(std::vector<double> heights_m,
                              const std::vector<HeightBound>& bounds) {
  for (std::size_t i = 0; i < bounds.size(); ++i) heights_m[i] /= bounds[i].at_most_m;
  return heights_m;
}

/// Of each step the bound at the end where more of it is taken up.
std::vector<HeightBound> worse_ends(const std::vector<double>& heights_m,
                                    const std::vector<HeightBound>& bounds) {
  std::vector<HeightBound> worse;
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const HeightBound &begin = bounds[i], &end = bounds[i + 1];
    const bool is_end = heights_m[i + 1] * begin.at_most_m > heights_m[i] * end.at_most_m;
    worse.push_back(is_end ? end : begin);
  }
  return worse;
}

double yaw_of(const AgentState& there) { return euler_angles(there.vehicle.body.attitude).yaw_rad; }

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
  return limit.goes_by_heading() ? reach.bows : std::vector<Course>();
}

WorstValue worst_at(const Limit& limit, const Agent& agent,
                    const std::vector<Triple<double>>& places_m, const std::vector<Course>& bows,
                    double t_s, AgentState& there) {
  WorstValue worst{std::nan(""), places_m.front()};
  bool is_unknown = false;
  const auto is_worse = [&](const WorstValue& one) {
    if (std::isnan(worst.value)) return true;
    if (one.by_sea)
      return one.value * worst.by_sea->at_most_m > worst.value * one.by_sea->at_most_m ||
             (one.value == worst.value && one.by_sea->at_most_m < worst.by_sea->at_most_m);
    return limit.is_least ? one.value < worst.value : one.value > worst.value;
  };
  const auto look = [&](const Limit& at_limit, const Triple<double>& place_m, bool has_bow) {
    WorstValue one{value_at(at_limit, agent, place_m, t_s, there), place_m};
    if (std::isnan(one.value)) {
      is_unknown = true;
      return;
    }
    if (limit.table)
      one.by_sea = limit.table->limit_at(agent.water->sea(place_m, t_s).sea,
                                         has_bow ? yaw_of(there) : std::nan(""));
    if (is_worse(one)) worst = one;
  };
  std::optional<Limit> whatever_the_bow;
  if (limit.waves && limit.waves->goes_by_heading() && bows.empty()) {
    whatever_the_bow = limit;
    whatever_the_bow->waves->off_bow_rad.reset();
  }
  for (const Triple<double>& place_m : places_m) {
    if (bows.empty()) look(whatever_the_bow ? *whatever_the_bow : limit, place_m, false);
    for (const Course& bow : bows) {
      there.vehicle.body.attitude = attitude_of({0, 0, bearing_rad(bow)});
      look(limit, place_m, true);
    }
  }
  if (is_unknown && limit.holds(worst.value, worst.bound_of(limit))) worst.value = std::nan("");
  return worst;
}

namespace {

/// Values of limits over the steps of a grid, in the waters of a forecast.
class LimitsInWater {
 public:
  LimitsInWater(const ReadyRun& ready, std::size_t agent, const StepClock& clock,
                std::size_t members, const WaveFutures* waves)
      : clock_(clock),
        members_(members),
        waves_(waves),
        waters_(waters_of(ready, members)),
        living_(ready.agents[agent]),
        there_(ready.states[agent]),
        step_s_(std::chrono::duration<double>(clock.step).count()),
        first_s_(seconds_between(ready.start, clock.first)) {
    for (std::size_t i = 0; waves != nullptr && i <= clock.steps; ++i)
      moments_.push_back(waves->moment(clock.time_of(i)));
  }

  /// The values of a limit at the places and with the bows of `ahead`.
  void fill(const Limit& limit, LimitAhead& ahead) {
    ahead.members.resize(series_of(limit.variable, members_, waves_));
    std::vector<HeightBound> bounds;  // of a table, at the stamps
    if (!is_of_waves(limit.variable)) {
      for (std::size_t m = 0; m < ahead.members.size(); ++m)
        ahead.members[m] = worst_of_steps(limit, values_in(m, limit, ahead, bounds));
      return;
    }
    const std::vector<double> heights_m = values_in(0, limit, ahead, bounds);
    for (std::size_t f = 0; f < ahead.members.size(); ++f)
      ahead.members[f] = worst_of_steps(
          limit, shares_of(waves_ == nullptr ? heights_m
                                             : heights_of(limit, heights_m, f, *waves_, moments_),
                           bounds));
    ahead.by_sea = worse_ends(heights_m, bounds);
  }

 private:
  std::vector<double> values_in(std::size_t member, const Limit& limit, const LimitAhead& ahead,
                                std::vector<HeightBound>& bounds) {
    living_.water = waters_[member];
    std::vector<double> values;
    values.reserve(clock_.steps + 1);
    for (std::size_t i = 0; i <= clock_.steps; ++i) {
      const double t_s = first_s_ + static_cast<double>(i) * step_s_;
      const WorstValue worst = worst_at(limit, living_, ahead.places_m, ahead.bows, t_s, there_);
      values.push_back(worst.value);
      if (limit.table) bounds.push_back(worst.by_sea.value_or(HeightBound{limit.bound, {}, {}}));
    }
    return values;
  }

  StepClock clock_;
  std::size_t members_;
  const WaveFutures* waves_;
  std::vector<std::shared_ptr<const EnvironmentSampler>> waters_;
  std::vector<WaveFutures::Moment> moments_;
  Agent living_;
  AgentState there_;
  double step_s_;
  double first_s_;
};

}  // namespace

std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                     const StepClock& clock, std::size_t members,
                                     const WaveFutures* waves) {
  const Agent& planned = ready.agents[agent];
  std::vector<LimitAhead> all;
  if (!planned.conduct) return all;
  const Triple<double>& start_m = ready.states[agent].vehicle.body.position_m;
  const std::vector<Limit>& limits = planned.conduct->plan.limits;
  const std::vector<double>& depth_m = ready.environment->field->snapshot().depth_m;
  LimitsInWater in_water(ready, agent, clock, members, waves);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    if (only_a_run_shows(limits[i].variable)) continue;
    for (std::size_t p = 0; p < phase_count; ++p) {
      const auto phase = static_cast<Phase>(p);
      if (!limits[i].phases.has(phase)) continue;
      const auto reach = reach_in(start_m, planned.mission, phase);
      if (!reach) continue;
      LimitAhead ahead{
          agent, i, phase, places_of(limits[i], *reach, depth_m), bows_of(limits[i], *reach),
          {},    {}};
      in_water.fill(limits[i], ahead);
      all.push_back(std::move(ahead));
    }
  }
  return all;
}

std::vector<LimitAhead> limits_ahead(const ReadyRun& ready, std::size_t agent,
                                     const std::vector<Limit>& limits, const StepClock& clock,
                                     std::size_t members, const WaveFutures* waves) {
  std::vector<LimitAhead> all;
  Triple<double> place_m = ready.states[agent].vehicle.body.position_m;
  place_m.z = 0;
  LimitsInWater in_water(ready, agent, clock, members, waves);
  for (std::size_t i = 0; i < limits.size(); ++i) {
    expects(!only_a_run_shows(limits[i].variable), "a limit that a forecast can answer");
    all.push_back({agent, i, Phase::transit, {place_m}, {}, {}, {}});
    in_water.fill(limits[i], all.back());
  }
  return all;
}

}  // namespace slackwater::twin

#include "twin/environment/sea_of_run.h"

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "fields/wave/growth.h"
#include "fields/wave/product_sea.h"

namespace slackwater::twin {
namespace {

/// The states of a forecast's sea at the nodes of a run.
struct KnownSea {
  std::vector<SeaState> states;
  SampleStatus first_unknown = SampleStatus::ok;  ///< ok: all are known
  double unknown_from_s = 0;
  bool is_any_known = false;
};

KnownSea sea_at_nodes(const Environment& environment, double duration_s) {
  const EnvironmentSampler sampler(environment);
  const double end_s = seconds_between(environment.epoch, environment.field->range().to);
  const auto steps = static_cast<std::size_t>(std::ceil(duration_s / sea_course_step_s));
  KnownSea known;
  for (std::size_t i = 0; i <= steps; ++i) {
    // The run ends within the forecast, the last node perhaps after it.
    const double t_s = std::min(static_cast<double>(i) * sea_course_step_s, end_s);
    const SeaSample sample = sampler.sea({}, t_s);
    if (has_value(sample.status)) {
      if (!known.is_any_known) std::fill(known.states.begin(), known.states.end(), sample.sea);
      known.is_any_known = true;
      known.states.push_back(sample.sea);
      continue;
    }
    if (known.first_unknown == SampleStatus::ok) {
      known.first_unknown = sample.status;
      known.unknown_from_s = t_s;
    }
    known.states.push_back(known.states.empty() ? SeaState{} : known.states.back());
  }
  return known;
}

bool has_waves(const SeaState& sea) {
  return sea.significant_height_m > 0 && sea.peak_period_s > 0 &&
         std::isfinite(sea.from_direction_deg);
}

/// What the sinusoids are made of.
SeaState realised_state(const std::vector<SeaState>& states) {
  SeaState largest;
  for (const SeaState& state : states)
    if (has_waves(state) && state.significant_height_m > largest.significant_height_m)
      largest = state;
  const SeaState& start = states.front();
  const bool bears_it = has_waves(start) && largest.significant_height_m <=
                                                std::max(start.significant_height_m,
                                                         steepest_height_m(start.peak_period_s));
  if (!bears_it) return largest;
  return {largest.significant_height_m, start.peak_period_s, start.from_direction_deg};
}

HeightCourse course_of(const std::vector<SeaState>& states, double realised_m) {
  constexpr double rounding = 1e-9;
  std::vector<double> factors;
  bool changes = false;
  for (const SeaState& state : states) {
    factors.push_back(std::max(0.0, state.significant_height_m) / realised_m);
    changes = changes || std::abs(factors.back() - 1) > rounding;
  }
  return changes ? HeightCourse(sea_course_step_s, std::move(factors)) : HeightCourse();
}

std::string no_waves(SampleStatus status) {
  return "the forecast has no waves there (" + std::string(name_of(status)) + ")";
}

/// At the origin.
WaveWater water_of(const Environment& environment) {
  const Field& field = *environment.field;
  const GeoPoint& origin = environment.origin;
  const Place at_surface{origin.longitude_deg(), origin.latitude_deg(), 0, environment.epoch};
  BedSample bed;
  field.sample_bed({&at_surface, 1}, {&bed, 1});
  if (!has_value(bed.status)) {
    throw Error(ErrorKind::invalid_input, "origin: " + std::string(name_of(bed.status)) + " (" +
                                              field.range().text() +
                                              "); waves need a depth of water there");
  }
  const CurrentSample current = field.current(at_surface, environment.member);
  WaveWater water{bed.water_depth_m, {}};
  if (has_value(current.status)) water.current_m_s = current.velocity_m_s;
  return water;
}

std::shared_ptr<const SeaRealisation> realised(const Scenario& scenario,
                                               const Environment& environment,
                                               const PartitionedSea& sea) {
  if (sea.partitions.empty() || !(sea.significant_height_m() > 0)) return nullptr;
  return std::make_shared<const SeaRealisation>(realise(sea, water_of(environment), scenario.seed,
                                                        environment.epoch,
                                                        {.count = scenario.waves.components}));
}

}  // namespace

RunSea sea_of_run(const Scenario& scenario, const Environment& environment,
                  std::vector<std::string>& warnings) {
  if (const auto& wave = scenario.waves.regular)
    return {with_context("waves",
                         [&] {
                           return std::make_shared<const SeaRealisation>(
                               realise(*wave, water_of(environment), environment.epoch));
                         }),
            wave->period_s};
  if (const PartitionedSea& stated = scenario.waves.made_up; !scenario.waves.from_forecast)
    return {realised(scenario, environment, stated), stated.peak_period_s()};
  const KnownSea known = sea_at_nodes(environment, scenario.duration_s);
  const SeaState state = realised_state(known.states);
  if (!(state.significant_height_m > 0)) {
    const bool is_calm =
        known.first_unknown == SampleStatus::ok &&
        std::all_of(known.states.begin(), known.states.end(),
                    [](const SeaState& sea) { return sea.significant_height_m == 0; });
    if (!is_calm) warnings.push_back(no_waves(known.first_unknown) + ": the sea is calm");
    return {};
  }
  if (known.first_unknown != SampleStatus::ok)
    warnings.push_back(no_waves(known.first_unknown) +
                       formatted(" at {:.0f} min and perhaps later: they stay as high as known",
                                 known.unknown_from_s / 60));
  const WavePartition partition{state.significant_height_m, state.peak_period_s,
                                state.from_direction_deg};
  const ServedSea served = product_sea(state.significant_height_m, {&partition, 1});
  warnings.insert(warnings.end(), served.warnings.begin(), served.warnings.end());
  const auto sea = realised(scenario, environment, served.sea);
  if (sea == nullptr) return {};
  HeightCourse course = course_of(known.states, state.significant_height_m);
  if (course.is_constant()) return {sea, state.peak_period_s};
  return {std::make_shared<const SeaRealisation>(sea->following(std::move(course))),
          state.peak_period_s};
}

}  // namespace slackwater::twin

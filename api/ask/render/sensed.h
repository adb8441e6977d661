#pragma once
#include <cstdint>

#include "api/ask/render/render_view.h"
#include "twin/environment/environment.h"
#include "twin/render/light/lit_scene.h"
#include "twin/render/light/warmth.h"

namespace slackwater::api {

/// A sensor at a moment, and what is about it.
struct SensorThere {
  const twin::RenderSensor& sensor;
  const twin::RenderScene& scene;
  const twin::EnvironmentSampler& sampler;  ///< of the run's water, as somebody leads it
  const twin::Lighting& lighting;           ///< all but lamps and shadows
  const twin::Warmth& warmth;
  twin::Pose pose;
  twin::Carriage lamps_on;   ///< what carries its lamps
  double sun_beam_w_m2 = 0;  ///< at right angles to it; 0 by night and under cloud
  bool is_overcast = false;
  std::uint64_t seed = 0;  ///< of the moment's noise
  int threads = 1;
};

/// What it sees, hears or feels. The same bits on any number of threads.
[[nodiscard]] Seen sensed(const SensorThere& there);
/// How many pixels show each of the defects of a view.
void count_defects(RenderView& view);

}  // namespace slackwater::api

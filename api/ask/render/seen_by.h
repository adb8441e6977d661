#pragma once
#include <cstdint>

#include "api/ask/render/render_view.h"
#include "twin/environment/environment.h"
#include "twin/inspection/instrument/pose.h"
#include "twin/render/light/lit_scene.h"
#include "twin/render/light/warmth.h"

namespace slackwater::api {

/// What is before a sensor at a moment.
struct BeforeSensor {
  const twin::RenderSensor& sensor;
  const twin::RenderScene& scene;
  const twin::Pose& pose;          ///< of the sensor
  const twin::Carriage& lamps_on;  ///< what has its lamps
  const twin::Lighting& lighting;  ///< without lamps and shadows
  const twin::Warmth& warmth;      ///< to infrared
  double beam_w_m2 = 0;            ///< of the sun, at right angles to it
  bool is_overcast = false;
  const twin::EnvironmentSampler& sampler;  ///< of the water, to an ADCP
  std::uint64_t seed = 0;                   ///< of noise
  int threads = 1;
};

/// What it sees, or hears. The same bits on any number of threads.
[[nodiscard]] SeenByDevice seen_by(const BeforeSensor& before);

}  // namespace slackwater::api

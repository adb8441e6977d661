#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A single-beam echo sounder: one round beam along its axis, which tells one range.
struct EchoSounderSheet {
  double beam_rad = 0.44;          ///< whole angle between half-power points, all round
  int rings = 96;                  ///< of rays about the axis
  int round = 24;                  ///< rays of each ring
  int bins = 512;                  ///< of range, from 0 to the longest
  double noise_sd_m = 0.01;        ///< of the range that is told
  double noise_per_range = 0.005;  ///< added to it, for each metre of range
  double step_m = 0.001;           ///< that ranges are told in
  double absorption_db_m = 0.038;  ///< one way
  double mackenzie_db = -27;       ///< 10 log10(mu) of the bed: echo.h
  double noise_floor = 1e-12;      ///< intensity of noise in a bin, of a source of 1 at 1 m
  double detected_db = 10;         ///< over the noise: the least peak that is told
};

/// One ping: the echo, and the range that is made of it.
struct EchoSounding {
  double bin_m = 0;
  std::vector<float> intensity;  ///< by bin, with speckle and noise
  std::vector<float> mean;       ///< without
  float range_m = 0;             ///< as told: the footprint's, with noise; NaN: no bottom
  float footprint_range_m = 0;   ///< the same without noise; NaN: nothing within the gate
  float nearest_range_m = 0;     ///< of what is within the half-power beam; NaN likewise
  float axis_range_m = 0;        ///< straight along the axis; NaN likewise
  std::uint16_t instance = 0;    ///< 1 + the place of what the axis meets; 0: nothing
};

/// One ping. The beam is cast into as rings of rays out to three half-power widths (85 degrees off
/// at most), each with its solid angle, sin(t) dt dp, and its pattern; what they throw back
/// (echo.h) falls into the bins of their ranges. What is told is the range of the footprint, the
/// mean of those of its rays by what they throw back of it,
///
///   sum E r / sum E,
///
/// plus normal noise of noise_sd + noise_per_range r. A wide beam so tells more than what lies
/// straight below it, by about <t^2>/2 of it over a level bed, and over a slope less. Nothing is
/// told where no bin of the mean echo is `detected_db` over the noise floor. Only what lies within
/// the gate, from the least to the longest range, is heard.
///
/// Noise and speckle by (seed, bin) alone.
/// @param caster  of the scene's things, in their order
[[nodiscard]] EchoSounding echo_sounded(const RenderScene& scene, const RayCaster& caster,
                                        const EchoSounderSheet& sheet, const Pose& pose,
                                        double least_range_m, double most_range_m,
                                        std::uint64_t seed, int threads);

}  // namespace slackwater::twin

#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A forward-looking sonar: a fan of beams to the right and left of its axis, each narrow across
/// and tall upright, whose echoes fall into bins of range.
struct ImagingSonarSheet {
  int beams = 512;
  double across_rad = 2.27;   ///< of the whole fan, from the first beam's middle to the last one's
  double beam_rad = 0.0105;   ///< of one beam, between its half-power points
  double upright_rad = 0.35;  ///< of each beam, likewise
  int rays = 256;             ///< cast in each beam, upright
  int bins = 512;             ///< of range, from 0 to the longest
  double frequency_hz = 750e3;
  double absorption_db_m = 0.25;  ///< one way
  double mackenzie_db = -27;      ///< 10 log10(mu) of the bed: echo.h
  double noise_floor = 1e-9;      ///< intensity of noise in a bin, in the units of the picture
};

/// A picture: beams from left to right by bins from near to far.
struct SonarImage {
  int beams = 0;
  int bins = 0;
  std::vector<float> intensity;  ///< with speckle; of a source of 1 at 1 m, the ways back and forth
  std::vector<float> mean;       ///< without speckle and noise
};

/// One ping. Each beam is cut into as many rays upright as the sheet says, evenly over three
/// half-power widths; what a ray throws back (echo.h) falls into the bin of its range. Its solid
/// angle is the beam's width times cos(e) de, and b the pattern of a beam upright.
///
/// Speckle: the intensity of a bin is that times an exponential random number of mean 1, by (seed,
/// beam, bin) alone; noise is added likewise.
/// @param caster  of the scene's things, in their order
[[nodiscard]] SonarImage pinged(const RenderScene& scene, const RayCaster& caster,
                                const ImagingSonarSheet& sheet, const Pose& pose,
                                double least_range_m, double most_range_m, std::uint64_t seed,
                                int threads);

}  // namespace slackwater::twin

#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/inspection/instrument/look.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A multibeam echo sounder: a fan of narrow beams to the right and left of its axis, which looks
/// down, each told as one range.
struct MultibeamSheet {
  int beams = 512;
  double across_rad = 2.44;  ///< of the whole fan, from the first beam's middle to the last's
  double beam_across_rad = 0.0094;  ///< of one beam, between its half-power points
  double beam_along_rad = 0.0192;
  double noise_sd_m = 0.01;        ///< of a range
  double noise_per_range = 0.001;  ///< added to it, for each metre of range
  double bearing_sd_rad = 0;       ///< by which a beam looks beside where it is told to look
  double step_m = 0.006;           ///< that ranges are told in
  double absorption_db_m = 0.096;  ///< one way
  double mackenzie_db = -27;       ///< 10 log10(mu) of the bed: echo.h
  double noise_floor = 5e-16;      ///< intensity of noise, of a source of 1 at 1 m
  double detected_db = 10;         ///< over the noise: the least echo that is told
};

/// A sounding: the range that a beam told, and what was so.
struct Sounding {
  double bearing_rad = 0;       ///< to the right of the axis, as told
  float range_m = 0;            ///< with noise; NaN: none
  float true_range_m = 0;       ///< where the beam is told to look; NaN: nothing within the gate
  float level = 0;              ///< of the mean echo, of a source of 1 at 1 m; 0: none
  std::uint16_t instance = 0;   ///< 1 + the place of what was met; 0: nothing
  Triple<double> place_m;       ///< NED of the run, as told: of no meaning without a range
  Triple<double> true_place_m;  ///< likewise without a true range
};

/// One ping. Beam by beam the range of what the middle of the beam meets, plus normal noise of
/// noise_sd + noise_per_range r, rounded to `step_m`; laid along where the beam is told to look.
/// The beam itself looks beside that by `bearing_sd` in the fan's plane. Over a level bed at a
/// depth h below the sonar, a beam t off straight down so tells a depth with the variance
///
///   (sd(r) cos t)^2 + (h tan t bearing_sd)^2,   r = h / cos t:
///
/// outer beams are worse by their bearing. Not told is what lies outside of the gate, from the
/// least to the longest range, and an echo (echo.h, of the beam's solid angle) of less than
/// `detected_db` over the noise floor: what is met too far off or too slantwise. Speckle has no
/// part in that.
///
/// Noise by (seed, beam) alone.
/// @param caster  of the scene's things, in their order
[[nodiscard]] std::vector<Sounding> sounded(const RenderScene& scene, const RayCaster& caster,
                                            const MultibeamSheet& sheet, const Pose& pose,
                                            double least_range_m, double most_range_m,
                                            std::uint64_t seed, int threads);

}  // namespace slackwater::twin

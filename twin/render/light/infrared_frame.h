#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/band_radiance.h"
#include "twin/render/light/lit_scene.h"
#include "twin/render/light/warmth.h"

namespace slackwater::twin {

/// A camera of heat.
struct InfraredSensor {
  double from_m = 8e-6;  ///< of its band
  double to_m = 14e-6;
  /// Noise-equivalent temperature difference at a black body of 300 K, standard deviation.
  double netd_k = 0.05;
};

/// What shines and stands between.
struct InfraredLight {
  const Warmth& warmth;
  Sky sky;                   ///< where the sun stands, and whether it shines
  double beam_w_m2 = 0;      ///< of the sun, at right angles to it
  bool is_overcast = false;  ///< the sky is cloud, and no sun
  /// Beam attenuation of visible light in air. In fog, from 1 km of visibility down (c >= 3/km),
  /// droplets are larger than the waves of heat, too, and c is added to that of clear air; in haze
  /// they are not.
  double visible_attenuation_per_m = 0;
  const Shadows& shadows;
};

/// What an infrared camera sees, row by row.
struct InfraredFrame {
  int wide = 0;
  int high = 0;
  std::vector<float> radiance;       ///< W/(m2 sr) in the band, without noise
  std::vector<float> apparent_k;     ///< as told: of a black body that radiates so, with noise
  std::vector<float> temperature_k;  ///< of the place; NaN: sky
  std::vector<float> emissivity;     ///< of the place; NaN: sky
};

/// Of a place of temperature T and emissivity e that is met at a range r:
///
///     L = tau (e B(T) + (1 - e) R) + (1 - tau) B(air),   tau = exp(-k r)
///     T = that of its material + in_sun max(0, n . sun) beam/1000, unless shadowed
///
/// with B of the band (band_radiance.h). R is what falls on it: on a Lambert face the sky and, from
/// below the horizon, the sea, by how much of either it sees, (1 + n_up)/2 of sky. The sea mirrors
/// one place of the sky, 1 - e = R0 + (1 - R0)(1 - cos)^5 with R0 of its emissivity (Schlick).
///
/// A clear sky, h above the horizon, is air as warm as the air with what is left of it overhead:
///
///     S(h) = B(air) (1 - t^(1/sin h)),  t = 1 - B(overhead)/B(air),
///
/// its mean over a level face B(air) (1 - t^1.66) (Elsasser 1942: the diffuse way through a layer
/// is 1.66 times the upright one). So all of one temperature is seen at that temperature.
///
/// Physics: Planck's law, emission and reflection, Beer and Lambert's law, noise. Stand-ins: the
/// temperatures and emissivities, which are stated (warmth.h); what stands near is not mirrored;
/// no heat runs along a surface, so no defect is warmer or colder but by its material.
///
/// The same bits on any number of threads.
/// @param hits  of the same scene and camera, in air
[[nodiscard]] InfraredFrame infrared_of(const RenderScene& scene, const InfraredLight& light,
                                        const InfraredSensor& sensor, const Pinhole& camera,
                                        const FrameHits& hits, std::uint64_t seed, int threads);

}  // namespace slackwater::twin

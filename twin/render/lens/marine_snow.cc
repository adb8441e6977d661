#include "twin/render/lens/marine_snow.h"

#include <algorithm>
#include <cmath>

#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/fading.h"
#include "twin/render/light/lamp_veil.h"

namespace slackwater::twin {

std::vector<Speck> flakes_in_view(const MarineSnow& snow, const Pinhole& camera,
                                  std::uint64_t seed) {
  return specks_in_view(snow.flakes, camera, seed, "twin/render/marine_snow");
}

LightFrame with_flakes(const LightFrame& light, const std::vector<Speck>& flakes,
                       const MarineSnow& snow, const Lighting& lighting, double surface_m,
                       const Pinhole& camera, const FrameHits& hits) {
  LightFrame out = light;
  const ColouredClarity& water = lighting.water;
  for (const Speck& flake : flakes) {
    const Triple<double> way = camera.direction(flake.u, flake.v);
    const double away_m = flake.depth_m / dot(way, camera.axis());
    const auto column = static_cast<int>(flake.u), row = static_cast<int>(flake.v);
    const auto pixel_at = [&](int i, int j) {
      return static_cast<std::size_t>(j) * static_cast<std::size_t>(light.wide) +
             static_cast<std::size_t>(i);
    };
    if (hits.range_m[pixel_at(column, row)] < away_m) continue;
    const Triple<double> at_m = camera.position_m() + away_m * way;
    Bands bright{};
    for (std::size_t k = 0; k < bright.size(); ++k)
      bright[k] = water.daylight *
                  fading(water.diffuse_attenuation_per_m[k] * std::max(0.0, at_m.z - surface_m));
    for (const Lamp& lamp : lighting.lamps) {
      const Triple<double> from_lamp = at_m - lamp.position_m;
      const double far_m = std::max(1e-3, length_of(from_lamp));
      const double lit = BeamEdge(lamp).lit(dot(from_lamp, lamp.axis) / far_m);
      const double share = lamp.range_m / far_m;
      for (std::size_t k = 0; k < bright.size(); ++k)
        bright[k] += share * share * lit * fading(water.beam_attenuation_per_m[k] * far_m);
    }
    SpeckDisc(camera, flake, snow.flakes.diameter_m).for_pixels([&](int i, int j, double share) {
      for (std::size_t k = 0; k < bright.size(); ++k)
        out.light[pixel_at(i, j)][k] +=
            static_cast<float>(share * snow.reflectance / usual_reflectance * bright[k] *
                               fading(water.beam_attenuation_per_m[k] * away_m));
    });
  }
  return out;
}

}  // namespace slackwater::twin

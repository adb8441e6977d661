#include "twin/render/light/sky_light.h"

#include <algorithm>

#include "fields/base/constants.h"
#include "twin/render/light/sun_glint.h"

namespace slackwater::twin {
namespace {

double sun_in_sea(const Lighting& lighting, const Triple<double>& direction,
                  const Triple<double>& normal) noexcept {
  const Sky& sky = lighting.sky;
  if (!(sky.beam > 0)) return 0;
  const double across_beam = sky.beam * lighting.air.daylight / std::max(0.05, -sky.to_sun.z);
  // A white face sends up its light over pi.
  return whites_light * constants::pi * across_beam *
         sun_glint_per_sr(-1.0 * direction, sky.to_sun, normal, lighting.sea_slope);
}

}  // namespace

Bands sky_light(const Lighting& lighting, const Triple<double>& direction) noexcept {
  const double sine = std::max(0.0, -direction.z);
  const double bright = lighting.air.daylight * whites_light * 9 / 7 * (1 + 2 * sine) / 3;
  if (!(lighting.sky.beam > 0)) return {bright, bright, bright};
  const double blue = 1 - (1 - sine) * (1 - sine);
  // No brighter than the sky's own share, paler to the horizon.
  const double of_sky = bright * (1 - 0.7 * lighting.sky.beam);
  return {of_sky * (1 - 0.55 * blue), of_sky * (1 - 0.25 * blue), of_sky};
}

Bands sea_light(const Lighting& lighting, const Triple<double>& direction,
                const Triple<double>& normal) noexcept {
  const double cosine = -dot(direction, normal);
  const double mirrored = mirrored_share(cosine);
  Bands light = sky_light(lighting, direction + (2 * cosine) * normal);
  const double glint = sun_in_sea(lighting, direction, normal);
  const ColouredClarity& water = lighting.water;
  for (std::size_t k = 0; k < light.size(); ++k) {
    const double absorbed =
        std::max(water.backscatter_per_m,
                 0.83 * water.diffuse_attenuation_per_m[k] - water.backscatter_per_m);
    const double back = absorbed > 0 ? 0.33 * water.backscatter_per_m / absorbed : 0;
    light[k] =
        mirrored * light[k] + (1 - mirrored) * 0.54 * back * whites_light * water.daylight + glint;
  }
  return light;
}

}  // namespace slackwater::twin

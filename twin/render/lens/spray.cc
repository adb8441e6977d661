#include "twin/render/lens/spray.h"

#include <algorithm>
#include <cmath>

#include "twin/render/light/fading.h"
#include "twin/render/light/sky_light.h"

namespace slackwater::twin {
namespace {

/// What comes along a look from the sky, or from a level sea so far below.
Bands light_about(const Lighting& lighting, const Triple<double>& look, double height_m) {
  if (look.z <= 0) return sky_light(lighting, look);
  Bands light = sea_light(lighting, look, {0, 0, -1});
  const Bands veil = sky_light(lighting, {look.x, look.y, 0});
  for (std::size_t k = 0; k < light.size(); ++k) {
    const double left = fading(lighting.air.beam_attenuation_per_m[k] * height_m / look.z);
    light[k] = left * light[k] + (1 - left) * veil[k];
  }
  return light;
}

}  // namespace

std::vector<Speck> drops_in_view(const Specks& spray, const Pinhole& camera, std::uint64_t seed) {
  return specks_in_view(spray, camera, seed, "twin/render/spray");
}

Triple<double> look_through_drop(const Triple<double>& look, const Triple<double>& side,
                                 double off) noexcept {
  constexpr double water_index = 1.333;
  const double turn = 2 * (std::asin(off) - std::asin(off / water_index));
  return std::cos(turn) * look - std::sin(turn) * side;
}

LightFrame with_drops(const LightFrame& light, const std::vector<Speck>& drops, const Specks& spray,
                      const Lighting& lighting, double surface_m, const Pinhole& camera,
                      const FrameHits& hits) {
  LightFrame out = light;
  const auto pixel_at = [&](int i, int j) {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(light.wide) +
           static_cast<std::size_t>(i);
  };
  for (const Speck& drop : drops) {
    const Triple<double> look = camera.direction(drop.u, drop.v);
    const double away_m = drop.depth_m / dot(look, camera.axis());
    if (hits.range_m[pixel_at(static_cast<int>(drop.u), static_cast<int>(drop.v))] < away_m)
      continue;
    const double height_m = std::max(0.0, surface_m - (camera.position_m().z + away_m * look.z));
    const SpeckDisc disc(camera, drop, spray.diameter_m);
    disc.for_pixels([&](int i, int j, double share) {
      const double right = i + 0.5 - drop.u, down = j + 0.5 - drop.v;
      const double off_px = std::hypot(right, down);
      Triple<double> beyond = look;
      if (off_px > 0) {
        Triple<double> side = right * camera.right() + down * camera.down();
        side = side - dot(side, look) * look;
        beyond = look_through_drop(look, (1 / length_of(side)) * side,
                                   std::min(1.0, off_px / disc.radius_px()));
      }
      const Bands seen = light_about(lighting, beyond, height_m);
      for (std::size_t k = 0; k < seen.size(); ++k) {
        float& there = out.light[pixel_at(i, j)][k];
        there += static_cast<float>(share) * (static_cast<float>(seen[k]) - there);
      }
    });
  }
  return out;
}

}  // namespace slackwater::twin

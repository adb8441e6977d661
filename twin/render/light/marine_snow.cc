#include "twin/render/light/marine_snow.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/random.h"
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/fading.h"
#include "twin/render/light/lamp_veil.h"

namespace slackwater::twin {
namespace {

/// Knuth's product of even numbers, in steps that no exponential leaves the range of.
std::size_t poisson(double mean, Rng& rng) {
  constexpr double most_of_step = 50;
  std::size_t count = 0;
  while (mean > 0) {
    const double ends = fading(std::min(mean, most_of_step));
    mean -= most_of_step;
    for (double product = 1 - rng.uniform(); product > ends; product *= 1 - rng.uniform()) ++count;
  }
  return count;
}

}  // namespace

double volume_in_view_m3(const Pinhole& camera, double near_m, double far_m) noexcept {
  return camera.wide() / camera.focal_u() * (camera.high() / camera.focal_v()) *
         (far_m * far_m * far_m - near_m * near_m * near_m) / 3;
}

std::vector<Flake> flakes_in_view(const MarineSnow& snow, const Pinhole& camera,
                                  std::uint64_t seed) {
  Rng rng(seed, "twin/render/marine_snow");
  const double near = snow.nearest_m * snow.nearest_m * snow.nearest_m;
  const double far = snow.reach_m * snow.reach_m * snow.reach_m;
  std::vector<Flake> flakes(
      poisson(snow.per_m3 * volume_in_view_m3(camera, snow.nearest_m, snow.reach_m), rng));
  for (Flake& flake : flakes) {
    flake.u = rng.uniform(0, camera.wide());
    flake.v = rng.uniform(0, camera.high());
    flake.depth_m = std::cbrt(rng.uniform(near, far));
  }
  return flakes;
}

LightFrame with_flakes(const LightFrame& light, const std::vector<Flake>& flakes,
                       const MarineSnow& snow, const Lighting& lighting, double surface_m,
                       const Pinhole& camera, const FrameHits& hits) {
  LightFrame out = light;
  const ColouredClarity& water = lighting.water;
  for (const Flake& flake : flakes) {
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
    // A disc with an edge of a pixel; all of it has the disc's area.
    const double radius_px = 0.5 * camera.focal_u() * snow.diameter_m / flake.depth_m;
    const double drawn_px = std::max(0.5, radius_px);
    const int reach = static_cast<int>(std::ceil(drawn_px + 0.5));
    const auto covered = [&](int i, int j) {
      return std::clamp(drawn_px + 0.5 - std::hypot(i + 0.5 - flake.u, j + 0.5 - flake.v), 0.0,
                        1.0);
    };
    double all = 0;
    for (int j = row - reach; j <= row + reach; ++j)
      for (int i = column - reach; i <= column + reach; ++i) all += covered(i, j);
    const double scale = constants::pi * radius_px * radius_px / all;
    for (int j = std::max(0, row - reach); j <= std::min(light.high - 1, row + reach); ++j)
      for (int i = std::max(0, column - reach); i <= std::min(light.wide - 1, column + reach); ++i)
        for (std::size_t k = 0; k < bright.size(); ++k)
          out.light[pixel_at(i, j)][k] +=
              static_cast<float>(scale * covered(i, j) * snow.reflectance / usual_reflectance *
                                 bright[k] * fading(water.beam_attenuation_per_m[k] * away_m));
  }
  return out;
}

}  // namespace slackwater::twin

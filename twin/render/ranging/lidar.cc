#include "twin/render/ranging/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/parallel.h"
#include "twin/render/light/albedo.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/fading.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::twin {
namespace {

constexpr float no_echo = std::numeric_limits<float>::quiet_NaN();
constexpr double mirror_cosine = 0.99939;  // of two degrees

double elevation_rad(const LidarSheet& sheet, int channel) noexcept {
  const int steps = std::max(1, sheet.channels - 1);
  return sheet.lowest_rad + (sheet.highest_rad - sheet.lowest_rad) * channel / steps;
}

float told_range(const LidarSheet& sheet, double range_m, std::uint64_t key) noexcept {
  const double noisy = range_m + sheet.noise_sd_m * normal_at(key);
  return static_cast<float>(std::max(0.0, std::floor(noisy / sheet.step_m + 0.5) * sheet.step_m));
}

}  // namespace

Triple<double> lidar_direction(const LidarSheet& sheet, const Pose& pose, int channel,
                               int column) noexcept {
  return fan_direction(pose, 2 * constants::pi * column / sheet.columns,
                       elevation_rad(sheet, channel));
}

LidarScan scanned(const RenderScene& scene, const RayCaster& caster, const LidarSheet& sheet,
                  const Pose& pose, double least_range_m, double most_range_m,
                  double attenuation_per_m, std::uint64_t seed, int threads) {
  LidarScan scan;
  scan.channels = sheet.channels;
  scan.columns = sheet.columns;
  const auto columns = static_cast<std::size_t>(sheet.columns);
  const std::size_t pulses = columns * static_cast<std::size_t>(sheet.channels);
  scan.range_m.assign(pulses, no_echo);
  scan.true_range_m.assign(pulses, no_echo);
  scan.instance.assign(pulses, 0);
  scan.intensity.assign(pulses, 0);
  for_all(static_cast<std::size_t>(sheet.channels), threads, [&](std::size_t channel) {
    for (std::size_t column = 0; column < columns; ++column) {
      const Ray ray{pose.position_m, lidar_direction(sheet, pose, static_cast<int>(channel),
                                                     static_cast<int>(column))};
      const auto hit = caster.first_hit(ray, most_range_m);
      const std::size_t at = channel * columns + column;
      bool is_of_drop = false;
      if (sheet.drops_per_m > 0) {
        const std::uint64_t key = noise_key(seed, channel, column);
        const double drop_m = -logarithm(1 - even_at(key ^ 2U)) / sheet.drops_per_m;
        is_of_drop = drop_m < (hit ? hit->range_m : most_range_m);
        if (is_of_drop && drop_m >= least_range_m && even_at(key ^ 3U) < sheet.drops_told)
          scan.range_m[at] = told_range(sheet, drop_m, key);
      }
      if (!hit || hit->range_m < least_range_m) continue;
      const SeenThing& thing = scene.things[hit->mesh];
      const double range_m = hit->range_m;
      scan.true_range_m[at] = static_cast<float>(range_m);
      scan.instance[at] = static_cast<std::uint16_t>(hit->mesh + 1);
      const Triple<double> normal = thing.mesh.area_vector_m2(hit->triangle);
      const double squareness = std::abs(dot(normal, ray.direction)) / length_of(normal);
      double back = 0;
      if (thing.seen_class != SeenClass::water)
        back =
            squareness * albedo_of(thing.material, ray.from_m + range_m * ray.direction, seed)[0];
      else if (squareness > mirror_cosine)
        back = 1;
      const double far = most_range_m / range_m;
      const double told =
          sheet.headroom * back * far * far * fading(2 * attenuation_per_m * range_m);
      scan.intensity[at] = static_cast<float>(told);
      const std::uint64_t key = noise_key(seed, channel, column);
      if (is_of_drop || told < 1 || even_at(key ^ 1U) < sheet.dropout) continue;
      scan.range_m[at] = told_range(sheet, range_m, key);
    }
  });
  return scan;
}

}  // namespace slackwater::twin

#include "twin/render/ranging/multibeam.h"

#include <cmath>
#include <limits>

#include "fields/base/parallel.h"
#include "twin/render/ranging/echo.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::twin {
namespace {

constexpr float no_sounding = std::numeric_limits<float>::quiet_NaN();

}  // namespace

std::vector<Sounding> sounded(const RenderScene& scene, const RayCaster& caster,
                              const MultibeamSheet& sheet, const Pose& pose, double least_range_m,
                              double most_range_m, std::uint64_t seed, int threads) {
  const double mu = std::pow(10.0, sheet.mackenzie_db / 10);
  const double solid_angle = sheet.beam_across_rad * sheet.beam_along_rad;
  const double taken_per_m = taken_both_ways_per_m(sheet.absorption_db_m);
  const double least_level = sheet.noise_floor * std::pow(10.0, sheet.detected_db / 10);
  std::vector<Sounding> soundings(static_cast<std::size_t>(sheet.beams));
  for_all(soundings.size(), threads, [&](std::size_t beam) {
    Sounding& one = soundings[beam];
    one.bearing_rad = beam_bearing_rad(sheet.across_rad, sheet.beams, static_cast<int>(beam));
    one.range_m = one.true_range_m = no_sounding;
    const Ray told{pose.position_m, fan_direction(pose, one.bearing_rad, 0)};
    const auto met = caster.first_hit(told, most_range_m);
    if (met && met->range_m >= least_range_m) {
      one.true_range_m = static_cast<float>(met->range_m);
      one.true_place_m = told.from_m + met->range_m * told.direction;
    }
    const std::uint64_t key = noise_key(seed, beam);
    const double beside_rad = sheet.bearing_sd_rad * normal_at(noise_key(seed, beam, 1));
    const Ray ray{pose.position_m, fan_direction(pose, one.bearing_rad + beside_rad, 0)};
    const auto hit = sheet.bearing_sd_rad > 0 ? caster.first_hit(ray, most_range_m) : met;
    if (!hit || hit->range_m < least_range_m) return;
    const double r = hit->range_m;
    const double level = thrown_back(mu * solid_angle, scene, ray, *hit, taken_per_m);
    one.level = static_cast<float>(level);
    one.instance = static_cast<std::uint16_t>(hit->mesh + 1);
    if (level < least_level) return;
    const double noisy = r + (sheet.noise_sd_m + sheet.noise_per_range * r) * normal_at(key);
    const double stepped =
        sheet.step_m > 0 ? std::floor(noisy / sheet.step_m + 0.5) * sheet.step_m : noisy;
    if (!(stepped >= least_range_m && stepped <= most_range_m)) return;
    one.range_m = static_cast<float>(stepped);
    one.place_m = told.from_m + stepped * told.direction;
  });
  return soundings;
}

}  // namespace slackwater::twin

#include "twin/render/ranging/echo_sounder.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/parallel.h"
#include "twin/render/ranging/echo.h"

namespace slackwater::twin {
namespace {

constexpr float no_bottom = std::numeric_limits<float>::quiet_NaN();

/// What a ray of a beam threw back.
struct RayEcho {
  double range_m = 0;
  double echo = 0;  ///< 0: nothing
};

}  // namespace

EchoSounding echo_sounded(const RenderScene& scene, const RayCaster& caster,
                          const EchoSounderSheet& sheet, const Pose& pose, double least_range_m,
                          double most_range_m, std::uint64_t seed, int threads) {
  const auto rings = static_cast<std::size_t>(sheet.rings);
  const auto round = static_cast<std::size_t>(sheet.round);
  const auto bins = static_cast<std::size_t>(sheet.bins);
  const double mu = std::pow(10.0, sheet.mackenzie_db / 10);
  const double taken_per_m = taken_both_ways_per_m(sheet.absorption_db_m);
  const double widest_rad = std::min(0.5 * cast_widths * sheet.beam_rad, 85 * constants::degree);
  const double step_rad = widest_rad / sheet.rings;
  const Triple<double> down = cross(pose.axis, pose.right);
  std::vector<RayEcho> echoes(rings * round);
  for_all(rings, threads, [&](std::size_t ring) {
    const double off = (static_cast<double>(ring) + 0.5) * step_rad;
    const double weight = mu * pattern_both_ways(off, sheet.beam_rad) * std::sin(off) * step_rad *
                          2 * constants::pi / sheet.round;
    for (std::size_t i = 0; i < round; ++i) {
      // Every other ring is turned by half a step, so that their rays do not stand in rows.
      const double turn = 2 * constants::pi *
                          (static_cast<double>(i) + 0.5 * static_cast<double>(ring % 2)) /
                          sheet.round;
      const Ray ray{pose.position_m, std::cos(off) * pose.axis +
                                         (std::sin(off) * std::cos(turn)) * pose.right +
                                         (std::sin(off) * std::sin(turn)) * down};
      const auto hit = caster.first_hit(ray, most_range_m);
      if (!hit || hit->range_m < least_range_m) continue;
      echoes[ring * round + i] = {hit->range_m, thrown_back(weight, scene, ray, *hit, taken_per_m)};
    }
  });

  EchoSounding sounding;
  sounding.bin_m = most_range_m / sheet.bins;
  sounding.range_m = sounding.footprint_range_m = no_bottom;
  sounding.nearest_range_m = sounding.axis_range_m = no_bottom;
  std::vector<double> sums(bins, 0.0);
  double all = 0, moment_m = 0, nearest_m = std::numeric_limits<double>::infinity();
  for (std::size_t at = 0; at < echoes.size(); ++at) {
    const auto& [range_m, echo] = echoes[at];
    if (!(echo > 0)) continue;
    all += echo;
    moment_m += echo * range_m;
    const auto bin = static_cast<std::size_t>(range_m / sounding.bin_m);
    sums[std::min(bin, bins - 1)] += echo;
    const double off = (static_cast<double>(at / round) + 0.5) * step_rad;
    if (off <= 0.5 * sheet.beam_rad) nearest_m = std::min(nearest_m, range_m);
  }
  for (std::size_t bin = 0; bin < bins; ++bin) {
    sounding.mean.push_back(static_cast<float>(sums[bin]));
    sounding.intensity.push_back(
        static_cast<float>(speckled(sums[bin], sheet.noise_floor, noise_key(seed, bin, 1))));
  }
  if (const auto hit = caster.first_hit({pose.position_m, pose.axis}, most_range_m);
      hit && hit->range_m >= least_range_m) {
    sounding.axis_range_m = static_cast<float>(hit->range_m);
    sounding.instance = static_cast<std::uint16_t>(hit->mesh + 1);
  }
  if (std::isfinite(nearest_m)) sounding.nearest_range_m = static_cast<float>(nearest_m);
  if (!(all > 0)) return sounding;
  const double told_m = moment_m / all;
  sounding.footprint_range_m = static_cast<float>(told_m);
  const double least_level = sheet.noise_floor * std::pow(10.0, sheet.detected_db / 10);
  if (*std::max_element(sums.begin(), sums.end()) < least_level) return sounding;
  const double sd_m = sheet.noise_sd_m + sheet.noise_per_range * told_m;
  const double noisy = told_m + sd_m * normal_at(noise_key(seed, 0, 2));
  const double stepped =
      sheet.step_m > 0 ? std::floor(noisy / sheet.step_m + 0.5) * sheet.step_m : noisy;
  if (stepped >= least_range_m && stepped <= most_range_m)
    sounding.range_m = static_cast<float>(stepped);
  return sounding;
}

}  // namespace slackwater::twin

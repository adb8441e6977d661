#include "twin/render/ranging/imaging_sonar.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/parallel.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/fading.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::twin {
namespace {

constexpr double ln10 = 2.302585092994046, ln2 = 0.6931471805599453;
constexpr double upright_span = 3;  // half-power widths that are cast into

/// Exponential, mean 1. @param key  gives a number in (0, 1]
double exponential_at(std::uint64_t key) noexcept { return -logarithm(1 - even_at(key)); }

}  // namespace

double sonar_bearing_rad(const ImagingSonarSheet& sheet, int beam) noexcept {
  return sheet.beams < 2 ? 0
                         : sheet.across_rad * (static_cast<double>(beam) / (sheet.beams - 1) - 0.5);
}

SonarImage pinged(const RenderScene& scene, const RayCaster& caster, const ImagingSonarSheet& sheet,
                  const Pose& pose, double least_range_m, double most_range_m, std::uint64_t seed,
                  int threads) {
  SonarImage image;
  image.beams = sheet.beams;
  image.bins = sheet.bins;
  const auto bins = static_cast<std::size_t>(sheet.bins);
  image.mean.assign(static_cast<std::size_t>(sheet.beams) * bins, 0);
  image.intensity.assign(image.mean.size(), 0);
  const double mu = std::pow(10.0, sheet.mackenzie_db / 10);
  const double taken_per_m = 2 * sheet.absorption_db_m * ln10 / 10;
  const double step_rad = upright_span * sheet.upright_rad / sheet.rays;
  // What a ray weighs: solid angle and pattern, the same in each beam.
  std::vector<double> elevation(static_cast<std::size_t>(sheet.rays)), weight(elevation.size());
  for (std::size_t k = 0; k < elevation.size(); ++k) {
    elevation[k] =
        (static_cast<double>(k) + 0.5) * step_rad - 0.5 * upright_span * sheet.upright_rad;
    const double off = 2 * elevation[k] / sheet.upright_rad;
    weight[k] =
        mu * sheet.beam_rad * step_rad * std::cos(elevation[k]) * fading(2 * ln2 * off * off);
  }
  for_all(static_cast<std::size_t>(sheet.beams), threads, [&](std::size_t beam) {
    std::vector<double> sum(bins, 0.0);
    const double bearing = sonar_bearing_rad(sheet, static_cast<int>(beam));
    for (std::size_t k = 0; k < elevation.size(); ++k) {
      const Ray ray{pose.position_m, fan_direction(pose, bearing, elevation[k])};
      const auto hit = caster.first_hit(ray, most_range_m);
      if (!hit || hit->range_m < least_range_m) continue;
      const double r = hit->range_m;
      const Triple<double> normal = scene.things[hit->mesh].mesh.area_vector_m2(hit->triangle);
      const double squareness = std::abs(dot(normal, ray.direction)) / length_of(normal);
      const auto bin = static_cast<std::size_t>(r / most_range_m * sheet.bins);
      sum[std::min(bin, bins - 1)] += weight[k] * squareness * fading(taken_per_m * r) / (r * r);
    }
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const std::size_t at = beam * bins + bin;
      const std::uint64_t key = noise_key(seed, beam, bin);
      image.mean[at] = static_cast<float>(sum[bin]);
      image.intensity[at] = static_cast<float>(sum[bin] * exponential_at(key) +
                                               sheet.noise_floor * exponential_at(key ^ 1U));
    }
  });
  return image;
}

std::vector<Sounding> sounded(const RayCaster& caster, const Pose& pose, int beams,
                              double across_rad, double noise_sd_m, double noise_per_range,
                              double least_range_m, double most_range_m, std::uint64_t seed) {
  constexpr float nothing_met = std::numeric_limits<float>::quiet_NaN();
  std::vector<Sounding> soundings;
  ImagingSonarSheet fan;
  fan.beams = beams;
  fan.across_rad = across_rad;
  for (int beam = 0; beam < beams; ++beam) {
    const Ray ray{pose.position_m, fan_direction(pose, sonar_bearing_rad(fan, beam), 0)};
    const auto hit = caster.first_hit(ray, most_range_m);
    Sounding one{nothing_met, nothing_met};
    if (hit && hit->range_m >= least_range_m) {
      const double sd_m = noise_sd_m + noise_per_range * hit->range_m;
      one.true_range_m = static_cast<float>(hit->range_m);
      one.range_m = static_cast<float>(
          hit->range_m + sd_m * normal_at(noise_key(seed, static_cast<std::uint64_t>(beam))));
    }
    soundings.push_back(one);
  }
  return soundings;
}

}  // namespace slackwater::twin

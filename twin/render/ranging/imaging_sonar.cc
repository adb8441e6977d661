#include "twin/render/ranging/imaging_sonar.h"

#include <algorithm>
#include <cmath>

#include "fields/base/parallel.h"
#include "twin/render/ranging/echo.h"
#include "twin/render/ranging/fan.h"

namespace slackwater::twin {

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
  const double taken_per_m = taken_both_ways_per_m(sheet.absorption_db_m);
  const double step_rad = cast_widths * sheet.upright_rad / sheet.rays;
  // What a ray weighs: solid angle and pattern, the same in each beam.
  std::vector<double> elevation(static_cast<std::size_t>(sheet.rays)), weight(elevation.size());
  for (std::size_t k = 0; k < elevation.size(); ++k) {
    elevation[k] =
        (static_cast<double>(k) + 0.5) * step_rad - 0.5 * cast_widths * sheet.upright_rad;
    weight[k] = mu * sheet.beam_rad * step_rad * std::cos(elevation[k]) *
                pattern_both_ways(elevation[k], sheet.upright_rad);
  }
  for_all(static_cast<std::size_t>(sheet.beams), threads, [&](std::size_t beam) {
    std::vector<double> sum(bins, 0.0);
    const double bearing = beam_bearing_rad(sheet.across_rad, sheet.beams, static_cast<int>(beam));
    for (std::size_t k = 0; k < elevation.size(); ++k) {
      const Ray ray{pose.position_m, fan_direction(pose, bearing, elevation[k])};
      const auto hit = caster.first_hit(ray, most_range_m);
      if (!hit || hit->range_m < least_range_m) continue;
      const auto bin = static_cast<std::size_t>(hit->range_m / most_range_m * sheet.bins);
      sum[std::min(bin, bins - 1)] += thrown_back(weight[k], scene, ray, *hit, taken_per_m);
    }
    for (std::size_t bin = 0; bin < bins; ++bin) {
      const std::size_t at = beam * bins + bin;
      image.mean[at] = static_cast<float>(sum[bin]);
      image.intensity[at] =
          static_cast<float>(speckled(sum[bin], sheet.noise_floor, noise_key(seed, beam, bin)));
    }
  });
  return image;
}

}  // namespace slackwater::twin

#include "twin/sensor/range_sonar.h"

namespace slackwater::twin {

std::vector<SonarEcho> measured(const RangeSonar& sonar, NoiseStream& noise, const Scene& scene,
                                const Triple<double>& at_m, const Rotation<double>& r) {
  std::vector<SonarEcho> echoes;
  const double step_rad = sonar.sector_rad / sonar.beams;
  const Triple<double> ahead{std::cos(sonar.tilt_rad), 0, std::sin(sonar.tilt_rad)};
  for (int beam = 0; beam < sonar.beams; ++beam) {
    SonarEcho echo;
    echo.bearing_rad = (beam + 0.5) * step_rad - 0.5 * sonar.sector_rad;
    const Triple<double> direction =
        std::cos(echo.bearing_rad) * ahead + Triple<double>{0, std::sin(echo.bearing_rad), 0};
    const Ray ray{at_m, r.to_ned(direction)};
    const double error_m = sonar.noise_sd_m * noise.normal();
    const std::optional<Hit> hit = first_hit(scene, ray);
    if (hit && hit->range_m >= sonar.nearest_m && hit->range_m <= sonar.farthest_m &&
        hit->squareness(ray) >= sonar.least_squareness)
      echo.range_m = rounded_to(hit->range_m + error_m, sonar.resolution_m);
    echoes.push_back(echo);
  }
  return echoes;
}

}  // namespace slackwater::twin

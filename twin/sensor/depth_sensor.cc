#include "twin/sensor/depth_sensor.h"

#include <algorithm>

namespace slackwater::twin {

double measured_depth_m(const DepthSensor& sensor, NoiseStream& noise, double down_m,
                        double surface_m) noexcept {
  const double depth_m = std::max(0.0, down_m - surface_m);
  const double felt_m =
      sensor.scale * depth_m + sensor.offset_m + sensor.noise_sd_m * noise.normal();
  return rounded_to(std::clamp(felt_m, 0.0, sensor.deepest_m), sensor.resolution_m);
}

}  // namespace slackwater::twin

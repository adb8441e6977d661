#pragma once
#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// Depth by pressure: the depth below the surface as it stands, with an error of scale (the density
/// assumed), an offset (the barometer at the start), white noise and a resolution.
///
/// Defaults: MS5837-30BA (datasheet: 0.2 mbar, 2 mm of water; 30 bar); scale and noise are
/// estimates, 0.2 % for a density taken 2 kg/m3 wrong.
struct DepthSensor {
  double scale = 1.002;
  double offset_m = 0;
  double noise_sd_m = 0.005;
  double resolution_m = 0.002;
  double deepest_m = 300;
  double rate_hz = 10;
};

/// @return metres below the surface; nothing less than 0 nor more than the sensor bears
[[nodiscard]] double measured_depth_m(const DepthSensor& sensor, NoiseStream& noise, double down_m,
                                      double surface_m) noexcept;

}  // namespace slackwater::twin

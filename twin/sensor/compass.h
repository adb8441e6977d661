#pragma once
#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// A magnetic compass: what it shows is off by its deviation,
///
///   delta(h) = A + B sin h + C cos h + D sin 2h + E cos 2h,
///
/// with h the heading (Bowditch, The American Practical Navigator, ch. 6: permanent iron gives B
/// and C, induced iron D and E), by what is left of the declination after correction, and by noise.
struct Compass {
  double constant_rad = 0;  ///< A
  double sine_rad = 0.02;   ///< B; estimates of a compass that has been swung beside thrusters
  double cosine_rad = 0.02;
  double double_sine_rad = 0.005;
  double double_cosine_rad = 0.005;
  double declination_error_rad = 0;
  double noise_sd_rad = 0.01;
  double rate_hz = 10;
};

[[nodiscard]] double deviation_rad(const Compass& compass, double heading_rad) noexcept;
/// @return clockwise from true north, in [0, 2 pi)
[[nodiscard]] double measured_heading_rad(const Compass& compass, NoiseStream& noise,
                                          double heading_rad) noexcept;

}  // namespace slackwater::twin

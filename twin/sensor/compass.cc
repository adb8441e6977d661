#include "twin/sensor/compass.h"

#include "fields/base/constants.h"

namespace slackwater::twin {

double deviation_rad(const Compass& c, double heading_rad) noexcept {
  return c.constant_rad + c.sine_rad * std::sin(heading_rad) +
         c.cosine_rad * std::cos(heading_rad) + c.double_sine_rad * std::sin(2 * heading_rad) +
         c.double_cosine_rad * std::cos(2 * heading_rad);
}

double measured_heading_rad(const Compass& compass, NoiseStream& noise,
                            double heading_rad) noexcept {
  constexpr double circle = 2 * constants::pi;
  const double shown = heading_rad + deviation_rad(compass, heading_rad) +
                       compass.declination_error_rad + compass.noise_sd_rad * noise.normal();
  const double within = shown - circle * std::floor(shown / circle);
  return within < circle ? within : 0;
}

}  // namespace slackwater::twin

#include "twin/sensor/janus.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {

JanusBeams janus_beams(double slant_rad, double azimuth_rad, bool looks_up) noexcept {
  const double down = looks_up ? -std::cos(slant_rad) : std::cos(slant_rad);
  JanusBeams beams;
  constexpr std::array<double, 4> turns{0, 1, 0.5, 1.5};
  for (std::size_t i = 0; i < 4; ++i) {
    const double azimuth = azimuth_rad + constants::pi * turns[i];
    beams[i] = {std::sin(slant_rad) * std::cos(azimuth), std::sin(slant_rad) * std::sin(azimuth),
                down};
  }
  return beams;
}

std::optional<JanusVelocity> janus_velocity(const JanusBeams& beams,
                                            const BeamSpeeds& speeds) noexcept {
  // Normal equations B^T B v = B^T s, solved by Cramer's rule on columns.
  Triple<double> xx, yy, zz, right;
  JanusVelocity out;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!speeds[i]) continue;
    ++out.beams;
    const Triple<double>& b = beams[i];
    xx = xx + b.x * b;
    yy = yy + b.y * b;
    zz = zz + b.z * b;
    right = right + *speeds[i] * b;
  }
  if (out.beams < 3) return std::nullopt;
  const double determinant = dot(xx, cross(yy, zz));
  out.velocity_m_s =
      (1 / determinant) * Triple<double>{dot(right, cross(yy, zz)), dot(xx, cross(right, zz)),
                                         dot(xx, cross(yy, right))};
  if (out.beams == 4)
    out.error_m_s = 0.25 * (*speeds[0] + *speeds[1] - *speeds[2] - *speeds[3]) / beams[0].z;
  return out;
}

}  // namespace slackwater::twin

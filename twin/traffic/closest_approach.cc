#include "twin/traffic/closest_approach.h"

#include <cmath>

namespace slackwater::twin {

ClosestApproach closest_of_all_times(const MovingPoint& own, const MovingPoint& other) noexcept {
  const Triple<double> p = other.position_m - own.position_m;
  const Triple<double> v = other.velocity_m_s - own.velocity_m_s;
  const double speed_squared = v.x * v.x + v.y * v.y;
  const double closing = -(p.x * v.x + p.y * v.y);
  // A tenth of a millimetre a second is no motion: its TCPA would be days.
  constexpr double still_m2_s2 = 1e-8;
  if (speed_squared < still_m2_s2) return {0, std::hypot(p.x, p.y), false};
  return {closing / speed_squared, std::abs(p.x * v.y - p.y * v.x) / std::sqrt(speed_squared),
          closing > 0};
}

ClosestApproach closest_approach(const MovingPoint& own, const MovingPoint& other) noexcept {
  const ClosestApproach of_all_times = closest_of_all_times(own, other);
  if (of_all_times.is_closing) return of_all_times;
  const Triple<double> p = other.position_m - own.position_m;
  return {0, std::hypot(p.x, p.y), false};
}

}  // namespace slackwater::twin

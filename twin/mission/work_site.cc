#include "twin/mission/work_site.h"

#include <cmath>

namespace slackwater::twin {

Triple<double> WorkTurbine::around(double bearing_rad, double distance_m, double down_m) const {
  return {north_m + distance_m * std::cos(bearing_rad), east_m + distance_m * std::sin(bearing_rad),
          down_m};
}

}  // namespace slackwater::twin

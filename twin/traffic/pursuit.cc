#include "twin/traffic/pursuit.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {

Heading pursue(const Pursuit& pursuit, const TrackState& wanted, const Triple<double>& position_m,
               const Triple<double>& water_m_s, double yaw_rad) {
  expects(wanted.is_known(), "only a track that says where it is can be pursued");
  const Triple<double> through_water =
      wanted.velocity_m_s + pursuit.gain_per_s * (wanted.position_m - position_m) - water_m_s;
  const double speed = std::hypot(through_water.x, through_water.y);
  Heading heading;
  heading.depth_m = wanted.position_m.z;
  heading.speed_m_s = std::min(speed, pursuit.most_speed_m_s);
  heading.yaw_rad =
      speed < pursuit.still_m_s ? yaw_rad : std::atan2(through_water.y, through_water.x);
  return heading;
}

}  // namespace slackwater::twin

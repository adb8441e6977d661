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

void learn_drift(const Pursuit& pursuit, const TrackState& wanted, const Triple<double>& position_m,
                 double dt_s, Triple<double>& drift_m_s) {
  const Triple<double> off = wanted.position_m - position_m;
  const Triple<double> asked = wanted.velocity_m_s + pursuit.gain_per_s * off - drift_m_s;
  const double closing_m_s = pursuit.gain_per_s * std::hypot(off.x, off.y);
  if (std::hypot(asked.x, asked.y) >= pursuit.most_speed_m_s ||
      closing_m_s >= 0.5 * pursuit.most_speed_m_s)
    return;
  const double learned = 0.25 * pursuit.gain_per_s * pursuit.gain_per_s * dt_s;
  const double most = 0.5 * pursuit.most_speed_m_s;
  drift_m_s.x = std::clamp(drift_m_s.x - learned * off.x, -most, most);
  drift_m_s.y = std::clamp(drift_m_s.y - learned * off.y, -most, most);
}

}  // namespace slackwater::twin

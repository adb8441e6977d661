#include "twin/control/velocity_range.h"

namespace slackwater::twin {

VelocityRange velocity_range(const Autopilot& autopilot) noexcept {
  const AutopilotSettings& s = autopilot.settings;
  const bool is_free = goes_by_ground(autopilot);
  const bool dives = autopilot.kind == VehicleKind::auv || autopilot.kind == VehicleKind::uav ||
                     autopilot.allocation.commands(Axis::heave);
  VelocityRange range;
  range.most_ahead_m_s = range.most_along_m_s = s.most_speed_m_s;
  range.most_turn_rad_s = s.most_yaw_rate_rad_s;
  if (is_free) {
    range.least_ahead_m_s = -s.most_speed_m_s;
    range.most_sideways_m_s = s.most_speed_m_s;
  } else if (autopilot.kind != VehicleKind::auv) {
    range.least_ahead_m_s = -most_astern_share * s.most_speed_m_s;
  }
  if (dives) {
    range.most_up_m_s = s.most_climb_m_s;
    range.most_down_m_s = s.most_descent_m_s;
  }
  return range;
}

}  // namespace slackwater::twin

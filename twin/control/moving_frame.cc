#include "twin/control/moving_frame.h"

namespace slackwater::twin {

Measured seen_from(const MovingFrame& frame, const Measured& measured, bool knows_water) noexcept {
  Measured seen = measured;
  seen.position_m = measured.position_m - frame.offset_m;
  seen.nu.linear = measured.nu.linear - rotation_of(measured.attitude).to_body(frame.velocity_m_s);
  if (knows_water) seen.water_m_s = measured.water_m_s - frame.velocity_m_s;
  return seen;
}

Reference over_ground(const MovingFrame& frame, const Reference& reference) noexcept {
  Reference ground = reference;
  if (reference.target == Target::cruise) return ground;
  ground.position_m = reference.position_m + frame.offset_m;
  ground.velocity_m_s = reference.velocity_m_s + frame.velocity_m_s;
  return ground;
}

void change_frame(const Triple<double>& faster_m_s, bool knows_water,
                  ControlState& state) noexcept {
  state.wanted_north_m_s -= faster_m_s.x;
  state.wanted_east_m_s -= faster_m_s.y;
  state.wanted_down_m_s -= faster_m_s.z;
  if (knows_water) return;
  // Its drift is the other way round: the speed that it lacks.
  state.drift_north_m_s += faster_m_s.x;
  state.drift_east_m_s += faster_m_s.y;
}

}  // namespace slackwater::twin

#pragma once
#include <cstdint>

namespace slackwater::people {

/// A vehicle now; units and frames as in session.fbs.
struct Pose {
  float east_m = 0, north_m = 0, up_m = 0;
  float roll_rad = 0, pitch_rad = 0, heading_rad = 0;
  float east_m_s = 0, north_m_s = 0, up_m_s = 0;
  float current_east_m_s = 0, current_north_m_s = 0;
  float bed_m = 0;
  float charge = 0;
  std::uint16_t vehicle = 0;
  bool is_halted = false;
};

}  // namespace slackwater::people

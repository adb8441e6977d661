#pragma once
#include "fields/base/frame.h"

namespace slackwater::calibration {

/// One level of a measured or modelled profile at one instant.
struct ProfileLevel {
  double depth_m = 0;      ///< >= 0, positive down
  Horizontal current_m_s;  ///< east + i north, towards, Eulerian
};

}  // namespace slackwater::calibration

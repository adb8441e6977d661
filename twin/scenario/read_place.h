#pragma once
#include "fields/base/config.h"
#include "twin/body/spatial.h"
#include "twin/control/route.h"

namespace slackwater::twin {

// Places and speeds, as vehicles and tasks have them. All throw Error(invalid_input) with the line.

/// NED, m: `north_m`, `east_m`, and `depth_m` down or `height_m` up, exactly one of them.
[[nodiscard]] Triple<double> read_place(const Config& config);

struct AskedSpeed {
  double m_s = 0;  ///< 0: none
  bool is_over_ground = false;
};
/// `speed_m_s`, through the water for craft that swim or float, or `ground_speed_m_s`.
[[nodiscard]] AskedSpeed read_speed(const Config& config);
void put_speed(const AskedSpeed& asked, Waypoint& waypoint) noexcept;

}  // namespace slackwater::twin

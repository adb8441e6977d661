#pragma once
#include <string>

#include "fields/base/config.h"
#include "twin/inspection/surface/frustum.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// z of {depth_m: 5} or {height_m: 12}.
[[nodiscard]] double read_z(const Config& level);
/// north_m, east_m, and depth_m or height_m.
[[nodiscard]] Triple<double> read_point(const Config& config);

/// An axis, and from where to where along it.
struct Upright {
  double north_m = 0;
  double east_m = 0;
  double top_m = 0;  ///< z
  double bottom_m = 0;
};
/// north_m, east_m, from, to. @throws Error(invalid_input) where `to` is not below `from`
[[nodiscard]] Upright read_upright(const Config& config);

/// bearings_deg: two, clockwise; absent: all round.
[[nodiscard]] Arc read_arc(const Config& config);

/// A given key or else the usual one.
[[nodiscard]] double number_or(const Config& config, const char* key, double usual,
                               Range range = {0.001, 500});

}  // namespace slackwater::twin

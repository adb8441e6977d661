#pragma once
#include <string>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::twin {

/// How thick the growth on a foundation is, by depth.
struct MarineGrowth {
  struct Layer {
    double bottom_m = 0;      ///< z of its lower end; infinite: all below
    double thickness_mm = 0;  ///< over all of it
    bool operator==(const Layer&) const = default;
  };
  double top_m = 0;           ///< z above which there is none
  std::vector<Layer> layers;  ///< from the uppermost down
  double density_kg_m3 = 0;   ///< in air; 0: nobody says, so that there is no mass
  std::string source;
  std::string status;
  bool operator==(const MarineGrowth&) const = default;

  [[nodiscard]] double thickness_mm_at(double down_m) const noexcept;
};

/// `growth` of a cleaning, at which source and status have to stand:
///
///     growth:
///       source: ...
///       status: estimate
///       up_to_height_m: 2                 # absent: up to mean sea level
///       density_kg_m3: 1325               # absent: no mass is told
///       by_depth: [{down_to_depth_m: 40, thickness_mm: 100}, {thickness_mm: 50}]
///
/// @throws Error(invalid_input), also for a thickness without its unit
[[nodiscard]] MarineGrowth read_marine_growth(const Config& config);

}  // namespace slackwater::twin

#pragma once
#include "twin/inspection/surface/planned_surface.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// A level bed with a scour pit about a round foundation: a cone that is deepest at the pile.
///
///   z(r, b) = bed + D (1 + k cos(b - b0)) max(0, 1 - (r - R) / w)
///
/// D its mean depth at the pile, k how much deeper it is on one side, w its width beyond the pile's
/// radius R. It holds 2 pi D (R w/2 + w^2/6) of water, whatever k.
struct ScourPit {
  double north_m = 0;  ///< the pile's axis
  double east_m = 0;
  double pile_radius_m = 0;
  double bed_m = 0;
  double depth_m = 0;      ///< D; 0: a level bed
  double width_m = 0;      ///< w
  double skew = 0;         ///< k
  double deepest_rad = 0;  ///< b0, a bearing

  [[nodiscard]] double z_m(double north_at_m, double east_at_m) const noexcept;
  [[nodiscard]] double volume_m3() const noexcept;
};

/// @param level_bed  about the same foundation
/// @throws Unmakeable for one that is deeper than scour gets
[[nodiscard]] ScourPit scour_pit(const BedSizes::Scour& sizes, const ScourPit& level_bed);

}  // namespace slackwater::twin

#pragma once
#include "twin/body/attitude.h"

namespace slackwater::twin {

/// A place and its velocity over ground, in the plane: the third component is not looked at.
struct MovingPoint {
  Triple<double> position_m;
  Triple<double> velocity_m_s;
};

/// When and how near two points pass if both hold their velocities (TCPA and DCPA).
struct ClosestApproach {
  double time_s = 0;  ///< from now; 0 where they do not come nearer
  double distance_m = 0;
  bool is_closing = false;
};

/// With p and v the position and velocity of one as the other sees it, |p + v t|^2 is least at
///
///   t = -p.v / |v|^2,     d = |p x v| / |v|.
///
/// Where t would be negative they part, and where v = 0 (same velocity: parallel and abreast)
/// nothing changes: the closest is now. Source: IMO MSC.192(79), which names the two; the formula
/// is a minimisation.
[[nodiscard]] ClosestApproach closest_approach(const MovingPoint& own,
                                               const MovingPoint& other) noexcept;

/// The same over all times: `time_s` is negative where they were nearest before now, and
/// `distance_m` is that of then. 0 and the distance now where v = 0.
[[nodiscard]] ClosestApproach closest_of_all_times(const MovingPoint& own,
                                                   const MovingPoint& other) noexcept;

}  // namespace slackwater::twin

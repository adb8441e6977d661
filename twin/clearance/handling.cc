#include "twin/clearance/handling.h"

namespace slackwater::twin {

Claim claim_of(const Handling& h, const OwnMotion& own) noexcept {
  Claim claim;
  claim.radius_m = h.radius_m + h.stray_m;
  if (h.manner == Manner::circles) {
    const Planar centre = own.position_m + h.turning_radius_m * to_the_right(own.bow);
    claim.stretch = {centre, centre};
    claim.radius_m += h.turning_radius_m + h.reaction_s * h.most_speed_m_s;
  } else {
    const double speed = size_of(own.velocity_m_s);
    const double time_s = h.reaction_s + speed / (2 * h.deceleration_m_s2);
    claim.stretch = {own.position_m, own.position_m + time_s * own.velocity_m_s};
  }
  if (h.is_afloat) {
    claim.top_m = -h.above_m;
    claim.bottom_m = h.below_m;
    return claim;
  }
  const double down = std::abs(own.down_m_s);
  const double way = down * (h.reaction_s + down / (2 * h.vertical_deceleration_m_s2));
  claim.top_m = own.depth_m - h.above_m - (own.down_m_s < 0 ? way : 0.0);
  claim.bottom_m = own.depth_m + h.below_m + (own.down_m_s > 0 ? way : 0.0);
  return claim;
}

}  // namespace slackwater::twin

#include "twin/render/stage/drawn_place.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

void DrawnPatch::add(std::size_t surface, const Surface& made) {
  for (std::size_t p = 0; p < made.patches.size(); ++p) {
    up_to_m2_.push_back((up_to_m2_.empty() ? 0 : up_to_m2_.back()) + made.patches[p].area_m2);
    patch_.emplace_back(surface, p);
  }
}

std::pair<std::size_t, std::size_t> DrawnPatch::drawn(Rng& rng) const {
  const double at_m2 = rng.uniform() * up_to_m2_.back();
  const auto next = std::upper_bound(up_to_m2_.begin(), up_to_m2_.end() - 1, at_m2);
  return patch_[static_cast<std::size_t>(next - up_to_m2_.begin())];
}

Pose pose_looking_at(const Triple<double>& place_m, const Triple<double>& normal, double range_m,
                     double off_rad, double round_rad, double roll_rad) noexcept {
  const Triple<double> side =
      std::abs(normal.z) < 0.9 ? cross({0, 0, 1}, normal) : cross({1, 0, 0}, normal);
  const Triple<double> e1 = (1 / length_of(side)) * side;
  const Triple<double> e2 = cross(normal, e1);
  const Triple<double> way =
      std::cos(off_rad) * normal +
      std::sin(off_rad) * (std::cos(round_rad) * e1 + std::sin(round_rad) * e2);
  Pose pose;
  pose.position_m = place_m + range_m * way;
  pose.axis = -1.0 * way;
  Triple<double> right = cross({0, 0, 1}, pose.axis);
  if (length_of(right) < 1e-3) right = cross({1, 0, 0}, pose.axis);
  right = (1 / length_of(right)) * right;
  const Triple<double> down = cross(pose.axis, right);
  pose.right = std::cos(roll_rad) * right + std::sin(roll_rad) * down;
  return pose;
}

}  // namespace slackwater::twin

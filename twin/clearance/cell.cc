#include "twin/clearance/cell.h"

namespace slackwater::twin {

void Cell::add(const Plane& plane, const Stretch& own) noexcept {
  if (planes_ < most_planes) {
    plane_[planes_++] = plane;
    return;
  }
  is_crowded_ = true;
  const auto farthest = std::max_element(
      plane_.begin(), plane_.end(),
      [&](const Plane& a, const Plane& b) { return a.room_m(own) < b.room_m(own); });
  if (plane.room_m(own) < farthest->room_m(own)) *farthest = plane;
}

RoomLeft Cell::room_of(const Claim& claim) const noexcept {
  RoomLeft least;
  const auto take = [&](double room_m, Hazard hazard) {
    if (room_m < least.room_m) least = {room_m, hazard};
  };
  take(claim.top_m - top_m_, above_);
  take(bottom_m_ - claim.bottom_m, below_);
  for (const Plane& plane : planes())
    if (plane.whose != Plane::course) take(plane.room_m(claim.stretch), plane.hazard);
  return least;
}

bool nearest_in(const Cell& cell, const Planar& wanted, Planar& nearest) noexcept {
  constexpr double touch_m = 1e-9;
  const std::span<const Plane> planes = cell.planes();
  Planar best = wanted;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const double room = planes[i].room_m(best);
    if (room >= -touch_m) continue;
    // The nearest of the line is its foot; what earlier planes leave of the line is a piece of it.
    const Planar foot = wanted + planes[i].room_m(wanted) * planes[i].normal;
    const Planar along = to_the_right(planes[i].normal);
    double low = -std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t j = 0; j < i; ++j) {
      const double slope = dot(planes[j].normal, along), left = planes[j].room_m(foot);
      if (std::abs(slope) < 1e-12) {
        if (left < -touch_m) return false;
      } else if (slope > 0) {
        high = std::min(high, left / slope);
      } else {
        low = std::max(low, left / slope);
      }
    }
    if (low > high + touch_m) return false;
    best = foot + std::clamp(0.0, std::min(low, high), high) * along;
  }
  nearest = best;
  return true;
}

}  // namespace slackwater::twin

#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "twin/clearance/handling.h"

namespace slackwater::twin {

inline constexpr std::size_t most_planes = 48;

/// What a vehicle keeps clear of.
enum class Hazard : std::uint8_t { none, vehicle, structure, line, vessel };

/// An upright plane that the middle of a claim does not cross: n . x <= limit.
struct Plane {
  Planar normal;  ///< of length one, away from the vehicle
  double limit_m = 0;
  /// Behind it: a vehicle by its place in the run, what stands there, or a vessel's course.
  static constexpr std::ptrdiff_t fixed = -1;
  static constexpr std::ptrdiff_t course = -2;
  std::ptrdiff_t whose = fixed;
  Hazard hazard = Hazard::none;

  /// What is left of the way of a claim to it; negative beyond it.
  [[nodiscard]] double room_m(const Stretch& s) const noexcept {
    return limit_m - std::max(dot(normal, s.from), dot(normal, s.to));
  }
  [[nodiscard]] double room_m(const Planar& at) const noexcept { return limit_m - dot(normal, at); }
};

/// What is left to the nearest of all bounds of a cell, and whose that one is.
struct RoomLeft {
  double room_m = std::numeric_limits<double>::infinity();
  Hazard hazard = Hazard::none;
};

/// Where a vehicle may have its claims until it looks again: a convex room between planes and two
/// depths. A value of fixed size.
class Cell {
 public:
  /// One too many takes the place of the farthest, and `is_crowded`.
  void add(const Plane& plane, const Stretch& own) noexcept;
  void keep_below(double z_m, Hazard hazard) noexcept {
    if (z_m > top_m_) above_ = hazard;
    top_m_ = std::max(top_m_, z_m);
  }
  void keep_above(double z_m, Hazard hazard) noexcept {
    if (z_m < bottom_m_) below_ = hazard;
    bottom_m_ = std::min(bottom_m_, z_m);
  }

  [[nodiscard]] std::span<const Plane> planes() const noexcept { return {plane_.data(), planes_}; }
  [[nodiscard]] double top_m() const noexcept { return top_m_; }
  [[nodiscard]] double bottom_m() const noexcept { return bottom_m_; }
  [[nodiscard]] bool is_crowded() const noexcept { return is_crowded_; }

  /// Of all planes and both depths, the least; infinite where there are none. Not of a vessel's
  /// course, which may be crossed far enough before it.
  [[nodiscard]] RoomLeft room_of(const Claim& claim) const noexcept;
  [[nodiscard]] double room_m(const Claim& claim) const noexcept { return room_of(claim).room_m; }

 private:
  std::array<Plane, most_planes> plane_{};
  std::size_t planes_ = 0;
  double top_m_ = -std::numeric_limits<double>::infinity();
  double bottom_m_ = std::numeric_limits<double>::infinity();
  Hazard above_ = Hazard::none;
  Hazard below_ = Hazard::none;
  bool is_crowded_ = false;
};

/// The place of the cell that is nearest to `wanted`: plane by plane, as in Seidel's linear
/// programme of two unknowns (de Berg et al., Computational Geometry, 2008, 4.4); where a new plane
/// cuts off the best place so far, the next best lies on it. Quadratic in the planes at worst.
/// @return false where the planes leave no room; `nearest` is then as it was
[[nodiscard]] bool nearest_in(const Cell& cell, const Planar& wanted, Planar& nearest) noexcept;

}  // namespace slackwater::twin

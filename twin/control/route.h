#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "twin/control/reference.h"

namespace slackwater::twin {

/// Where to go: NED metres from the site's origin, and how fast on the way there.
struct Waypoint {
  Triple<double> position_m;
  double speed_m_s = 0;    ///< 0: as the vehicle's settings say
  double over_ground = 0;  ///< 1: that speed is over ground, whatever the kind of vehicle
  bool operator==(const Waypoint&) const = default;
};

/// What is left of a route. Values: a new route may be put in its place at any step.
class Route {
 public:
  Route() = default;
  /// From `start` through the waypoints. @throws ContractViolation for numbers that are not finite
  Route(const Triple<double>& start, std::span<const Waypoint> waypoints);

  [[nodiscard]] bool is_done() const noexcept { return next_ >= points_.size(); }
  [[nodiscard]] bool is_empty() const noexcept { return points_.empty(); }
  [[nodiscard]] std::size_t next() const noexcept { return next_; }
  /// The leg under way; the last one when all is done.
  [[nodiscard]] const Triple<double>& from() const noexcept;
  [[nodiscard]] const Waypoint& to() const noexcept;
  /// The waypoint after `to`; nothing after the last.
  [[nodiscard]] const Waypoint* after() const noexcept;
  [[nodiscard]] double remaining_m(const Triple<double>& position_m) const noexcept;

  /// Takes the waypoints that are reached: nearer than `tolerance_m` in the plane and
  /// `depth_tolerance_m`, or passed by abeam within `passing_m` of them.
  /// @return how many
  std::size_t advance(const Triple<double>& position_m, double tolerance_m,
                      double depth_tolerance_m, double passing_m);

  /// Leaves out the waypoint of the leg under way.
  void skip() noexcept {
    if (!is_done()) ++next_;
  }

  /// Once it is done: from its last waypoint through all of them again.
  void begin_again() noexcept {
    if (points_.empty()) return;
    start_ = points_.back().position_m;
    next_ = 0;
  }

  /// Names each member to a visitor, for what stores a route and takes it up again.
  template <typename Self, typename Visit>
  static void for_each_member(Self& self, Visit&& visit) {
    auto& [start, points, next] = self;
    visit("start", start);
    visit("points", points);
    visit("next", next);
  }

 private:
  Triple<double> start_;
  std::vector<Waypoint> points_;
  std::size_t next_ = 0;
};

/// A place beside a leg, in the plane.
struct LegPlace {
  double along_m = 0;   ///< from the leg's start
  double across_m = 0;  ///< positive to the right of the way
  double length_m = 0;  ///< of the leg
  Course course;        ///< of the leg; north where it has no length
};
[[nodiscard]] LegPlace place_on_leg(const Triple<double>& from, const Triple<double>& to,
                                    const Triple<double>& position_m) noexcept;

}  // namespace slackwater::twin

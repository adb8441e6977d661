#pragma once
#include <array>
#include <span>

#include "twin/body/actuators.h"
#include "twin/body/spatial.h"

namespace slackwater::twin {

/// What one mount can push, N; `torque_per_thrust_m` is the reaction of its propeller, along its
/// own axis.
struct ThrustRange {
  double least_n = 0;  ///< astern: zero or negative
  double most_n = 0;   ///< ahead
  double torque_per_thrust_m = 0;
};

/// The six components of a wrench, in the order of Fossen's tau.
enum class Axis : std::size_t { surge, sway, heave, roll, pitch, yaw };
inline constexpr std::size_t axes = 6;
using AxisNumbers = std::array<double, axes>;

[[nodiscard]] inline AxisNumbers numbers_of(const Spatial<double>& s) noexcept {
  return {s.linear.x, s.linear.y, s.linear.z, s.angular.x, s.angular.y, s.angular.z};
}

/// An axis that the autopilot wants to command; those of a lower level are served first.
struct WantedAxis {
  Axis axis = Axis::surge;
  std::size_t level = 0;
};
inline constexpr std::size_t most_levels = 3;

/// How thrusters share a wrench, worked out once from where they stand. With B the matrix that
/// takes thrusts to the wrench, W = diag(1/limit^2) and rows of B only for the axes that are
/// commanded,
///
///   B+ = W^-1 B^T (B W^-1 B^T)^-1,    B B+ = 1,
///
/// so that t = B+ tau is the thrust of least weighted square. Source: Fossen (2011), 12.3.2.
struct Allocation {
  std::size_t mounts = 0;
  std::size_t levels = 0;
  std::array<std::array<double, most_mounts>, axes> inverse{};  ///< B+: by axis, then by mount
  /// 1 - B+ B: what thrusters may do against each other without any wrench.
  std::array<std::array<double, most_mounts>, most_mounts> idle{};
  bool has_idle = false;                                       ///< anything but zeros in it
  std::array<std::array<double, most_mounts>, axes> effect{};  ///< B, of all axes
  std::array<double, most_mounts> least_n{};
  std::array<double, most_mounts> most_n{};
  std::array<bool, axes> is_commanded{};
  std::array<std::size_t, axes> level{};
  /// The most force or moment along each axis alone, both positive; 0 where there is none (the roll
  /// of a multirotor has none by itself: it lives on the thrust that carries it).
  AxisNumbers most_ahead{};
  AxisNumbers most_astern{};

  [[nodiscard]] bool commands(Axis axis) const noexcept {
    return is_commanded[static_cast<std::size_t>(axis)];
  }
  /// The weaker of the two ways.
  [[nodiscard]] double most_either_way(Axis axis) const noexcept {
    const auto i = static_cast<std::size_t>(axis);
    return most_ahead[i] < most_astern[i] ? most_ahead[i] : most_astern[i];
  }
};

/// @param wanted  in the order of their importance: an axis that the mounts move only together with
///                earlier ones (the pitch of two outboards, say, that comes with their surge) is
///                left out
/// @throws ContractViolation for no mounts or too many, more levels than `most_levels`, a range
///         without zero in it
[[nodiscard]] Allocation plan_allocation(std::span<const Mount> mounts,
                                         std::span<const ThrustRange> ranges,
                                         std::span<const WantedAxis> wanted);

struct Thrusts {
  std::array<double, most_mounts> thrust_n{};
  AxisNumbers share{};  ///< of what was asked along each axis, 0 to 1
};

/// Thrusts within their ranges for a wrench in body axes about the origin.
///
/// Where the wrench asks for too much, thrusters first help each other out as far as that changes
/// nothing of the wrench; then each level of axes has what the levels before it have left, scaled
/// down as a whole, so that force and moment keep their direction within a level. An ROV thus keeps
/// upright and at its depth first, then on its heading, and gives up way through the water. Cost:
/// 48 multiplications, ten times that when it asks for too much. No allocation.
[[nodiscard]] Thrusts allocate(const Allocation& allocation,
                               const Spatial<double>& wrench) noexcept;

/// B t: what thrusts do, moments of the propellers included.
[[nodiscard]] Spatial<double> wrench_of(const Allocation& allocation,
                                        const std::array<double, most_mounts>& thrust_n) noexcept;

}  // namespace slackwater::twin

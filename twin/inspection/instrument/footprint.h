#pragma once
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// Whether a place is within the angles of a frame: |x| <= z tan(h/2), |y| <= z tan(v/2), with x, y
/// to the right and down in the picture and z along the axis.
[[nodiscard]] bool holds(const FrameFootprint& frame, const Pose& pose,
                         const Triple<double>& place_m) noexcept;
/// Whether a place in a fan's plane is within its sector and out of its blind zone: the angle from
/// the axis, either side, is at most half of the one and at least half of the other.
[[nodiscard]] bool holds(const FanFootprint& fan, const Pose& pose,
                         const Triple<double>& place_m) noexcept;

/// Whether a frame may hold anything of a ball: false only where it holds nothing.
[[nodiscard]] bool may_hold(const FrameFootprint& frame, const Pose& pose,
                            const Triple<double>& centre_m, double radius_m) noexcept;

/// How far a place lies ahead of a fan's plane, along `right` x `axis`.
[[nodiscard]] double ahead_of_fan_m(const Pose& pose, const Triple<double>& place_m) noexcept;

/// Between two poses, straight.
/// @param share  0: `before`, 1: `now`
[[nodiscard]] Pose pose_between(const Pose& before, const Pose& now, double share) noexcept;

}  // namespace slackwater::twin

#include "twin/inspection/instrument/footprint.h"

#include <cmath>

namespace slackwater::twin {
namespace {

Triple<double> between(const Triple<double>& a, const Triple<double>& b, double share) noexcept {
  return a + share * (b - a);
}

}  // namespace

bool holds(const FrameFootprint& frame, const Pose& pose, const Triple<double>& place_m) noexcept {
  const Triple<double> way = place_m - pose.position_m;
  const double depth = dot(way, pose.axis);
  return depth > 0 &&
         std::abs(dot(way, pose.right)) <= depth * std::tan(frame.horizontal_rad / 2) &&
         std::abs(dot(way, cross(pose.axis, pose.right))) <=
             depth * std::tan(frame.vertical_rad / 2);
}

bool holds(const FanFootprint& fan, const Pose& pose, const Triple<double>& place_m) noexcept {
  const Triple<double> way = place_m - pose.position_m;
  const double off_axis = std::abs(std::atan2(dot(way, pose.right), dot(way, pose.axis)));
  return off_axis <= fan.across_rad / 2 && off_axis >= fan.blind_rad / 2;
}

bool may_hold(const FrameFootprint& frame, const Pose& pose, const Triple<double>& centre_m,
              double radius_m) noexcept {
  const Triple<double> way = centre_m - pose.position_m;
  const double depth = dot(way, pose.axis);
  const auto is_near_side = [&](double aside, double half_rad) {
    return std::abs(aside) * std::cos(half_rad) - depth * std::sin(half_rad) <= radius_m;
  };
  return depth >= -radius_m && is_near_side(dot(way, pose.right), frame.horizontal_rad / 2) &&
         is_near_side(dot(way, cross(pose.axis, pose.right)), frame.vertical_rad / 2);
}

double ahead_of_fan_m(const Pose& pose, const Triple<double>& place_m) noexcept {
  return dot(place_m - pose.position_m, cross(pose.right, pose.axis));
}

Pose pose_between(const Pose& before, const Pose& now, double share) noexcept {
  Pose pose;
  pose.position_m = between(before.position_m, now.position_m, share);
  pose.velocity_m_s = between(before.velocity_m_s, now.velocity_m_s, share);
  pose.turning_rad_s = between(before.turning_rad_s, now.turning_rad_s, share);
  const Triple<double> axis = between(before.axis, now.axis, share);
  pose.axis = (1 / length_of(axis)) * axis;
  Triple<double> right = between(before.right, now.right, share);
  right = right - dot(right, pose.axis) * pose.axis;
  pose.right = (1 / length_of(right)) * right;
  return pose;
}

}  // namespace slackwater::twin

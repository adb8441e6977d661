#include "twin/render/frame/pinhole.h"

#include <cmath>

namespace slackwater::twin {

Pinhole::Pinhole(const Pose& pose, const FrameFootprint& frame) noexcept
    : position_m_(pose.position_m),
      axis_(pose.axis),
      right_(pose.right),
      down_(cross(pose.axis, pose.right)),
      wide_(frame.pixels_wide),
      high_(frame.pixels_high),
      focal_u_(frame.pixels_wide / (2 * std::tan(frame.horizontal_rad / 2))),
      focal_v_(frame.pixels_high / (2 * std::tan(frame.vertical_rad / 2))) {}

std::optional<PixelPlace> Pinhole::place_of(const Triple<double>& at_m) const noexcept {
  const Triple<double> way = at_m - position_m_;
  const double depth_m = dot(way, axis_);
  if (!(depth_m > 0)) return std::nullopt;
  return PixelPlace{0.5 * wide_ + focal_u_ * dot(way, right_) / depth_m,
                    0.5 * high_ + focal_v_ * dot(way, down_) / depth_m, depth_m};
}

std::array<double, 9> Pinhole::matrix() const noexcept {
  return {focal_u_, 0, 0.5 * wide_, 0, focal_v_, 0.5 * high_, 0, 0, 1};
}

}  // namespace slackwater::twin

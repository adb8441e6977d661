#include "twin/inspection/instrument/pointing.h"

#include <cmath>

namespace slackwater::twin {
namespace {

/// Rodrigues: about a unit vector, right-handed.
Triple<double> turned(const Triple<double>& v, const Triple<double>& about, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return c * v + s * cross(about, v) + (1 - c) * dot(about, v) * about;
}

}  // namespace

bool is_pointed(const Instrument& instrument) noexcept {
  return instrument.aim == Aim::fixed &&
         std::holds_alternative<FrameFootprint>(instrument.footprint);
}

Pose pointed(Pose pose, const Carriage& carriage, const CameraPointing& pointing) noexcept {
  const Triple<double> down = carriage.attitude.to_ned({0, 0, 1});
  pose.axis = turned(pose.axis, down, pointing.pan_rad);
  pose.right = turned(pose.right, down, pointing.pan_rad);
  pose.axis = turned(pose.axis, pose.right, pointing.tilt_rad);
  return pose;
}

void zoom_in(double zoom, Instrument& instrument) noexcept {
  if (auto* frame = std::get_if<FrameFootprint>(&instrument.footprint)) zoom_in(zoom, *frame);
}

void zoom_in(double zoom, FrameFootprint& frame) noexcept {
  const auto narrowed = [zoom](double field_rad) {
    return 2 * std::atan(std::tan(field_rad / 2) / zoom);
  };
  frame.horizontal_rad = narrowed(frame.horizontal_rad);
  frame.vertical_rad = narrowed(frame.vertical_rad);
}

}  // namespace slackwater::twin

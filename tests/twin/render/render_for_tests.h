#pragma once
#include <cmath>

#include "fields/base/constants.h"
#include "twin/inspection/instrument/instrument.h"
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// A frame of square pixels.
inline FrameFootprint frame_of(int wide, int high, double horizontal_deg) {
  FrameFootprint frame;
  frame.pixels_wide = wide;
  frame.pixels_high = high;
  frame.horizontal_rad = horizontal_deg * constants::degree;
  frame.vertical_rad = 2 * std::atan(std::tan(frame.horizontal_rad / 2) * high / wide);
  return frame;
}

/// A camera at a place that looks at another, its picture level; north is to the right of one that
/// looks straight down.
inline Pose looking(const Triple<double>& from_m, const Triple<double>& at_m) {
  Pose pose;
  pose.position_m = from_m;
  pose.axis = (1 / length_of(at_m - from_m)) * (at_m - from_m);
  Triple<double> right = cross({0, 0, 1}, pose.axis);
  if (length_of(right) < 1e-6) right = {1, 0, 0};
  right = right - dot(right, pose.axis) * pose.axis;
  pose.right = (1 / length_of(right)) * right;
  return pose;
}

}  // namespace slackwater::twin

#pragma once

namespace slackwater::twin {

/// Where a camera looks, from where it is mounted to look, and how much it shows.
struct CameraPointing {
  double pan_rad = 0;   ///< to starboard
  double tilt_rad = 0;  ///< up
  double zoom = 1;      ///< focal length, in that of its whole field
  bool operator==(const CameraPointing&) const = default;
};

/// Any camera pans all round, tilts from straight down to straight up, and zooms as common cameras
/// for inspection do, 10 times: estimates.
inline constexpr double most_pan_rad = 3.141592653589793, most_tilt_rad = most_pan_rad / 2;
inline constexpr double most_zoom = 10;

}  // namespace slackwater::twin

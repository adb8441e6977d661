#pragma once
#include "twin/inspection/instrument/pose.h"
#include "twin/sensor/camera_pointing.h"

namespace slackwater::twin {

/// Whether somebody turns it: a camera that is fixed on the hull but for its joints.
[[nodiscard]] bool is_pointed(const Instrument& instrument) noexcept;

/// The pose of a camera whose joints are turned: first about the vehicle's own down axis, then
/// about the right of its picture. Its place on the hull stays.
[[nodiscard]] Pose pointed(Pose pose, const Carriage& carriage,
                           const CameraPointing& pointing) noexcept;

/// A camera whose focal length is `zoom` times its own, with as many pixels: tan(field/2) is so
/// much less.
void zoom_in(double zoom, FrameFootprint& frame) noexcept;
/// Others than cameras stay as they are.
void zoom_in(double zoom, Instrument& instrument) noexcept;

}  // namespace slackwater::twin

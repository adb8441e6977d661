#pragma once
#include <array>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// When the rows of a picture see.
struct Shutter {
  double exposure_s = 0;   ///< of each row
  double line_time_s = 0;  ///< from one row to the next below it; 0: all of them at once
};

/// How a place that stands still runs over the picture of a camera that moves, pixels a second to
/// the right and down. With p the way from the camera to it, and v, w how the camera goes and
/// turns, P' = -(v + w x p), told in the camera's axes as (X, Y, Z)' of p = (X, Y, Z),
///
///   u' = f_u (X' - X Z'/Z)/Z,   v' = f_v (Y' - Y Z'/Z)/Z:
///
/// f v/z of one that goes past at a depth z: what quality.h's blur is of, laid on the picture.
[[nodiscard]] std::array<double, 2> image_motion_px_s(const Pinhole& camera, const Pose& pose,
                                                      const Triple<double>& way_m) noexcept;

/// The light of a picture whose rows see one after the other, each for a while, by a camera that
/// moves as its pose says: row j at t_j = (j + 1/2 - h/2) line time about the picture's middle. Of
/// a pixel with the motion m, the mean over t_j +- exposure/2 of the light at its place less m t,
/// by points no farther apart than half a pixel, each between its four pixels.
///
/// To first order in time: m is that of the pixel's own place. Stand-ins: vehicles and waves smear
/// as if they stood still, and at an outline what is before and what is behind smear each by its
/// own motion alone. The truth of the picture is that of its middle.
///
/// The same bits on any number of threads.
/// @param hits  of the picture
[[nodiscard]] LightFrame through_shutter(const LightFrame& light, const Shutter& shutter,
                                         const Pinhole& camera, const Pose& pose,
                                         const FrameHits& hits, int threads);

}  // namespace slackwater::twin

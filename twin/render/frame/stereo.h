#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/render/frame/pinhole.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin {

/// The right one of a pair of cameras: `baseline_m` to the right of the first, looking the same way
/// (a rectified pair: both pictures lie in one plane, and their rows in one line).
[[nodiscard]] Pose right_of(const Pose& left, double baseline_m) noexcept;

/// What two pictures of a pair have to do with each other, of the left one, row by row.
struct StereoTruth {
  /// Pixels that a place lies farther left in the right picture, f_u b / z at depth z; NaN: nothing
  /// is seen.
  std::vector<float> disparity;
  /// 1 where the right camera has the same place in its picture, and nothing stands before it.
  std::vector<std::uint8_t> is_in_both;
};

/// The same bits on any number of threads.
/// @param truth   of the left picture
/// @param hits    of it
/// @param caster  of all things of the scene
[[nodiscard]] StereoTruth stereo_truth(const Pinhole& left, const TruthFrame& truth,
                                       const FrameHits& hits, double baseline_m,
                                       const RayCaster& caster, int threads);

}  // namespace slackwater::twin

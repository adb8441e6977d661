#pragma once
#include "twin/render/frame/pinhole.h"
#include "twin/render/frame/truth_frame.h"

namespace slackwater::twin {

/// Surface in view that is seen no flatter than 80 degrees off its normal, m2: the sum over pixels
/// of
///
///     z^2 / (f_u f_v |n . d|),
///
/// z the depth along the axis, d = (x, y, 1) the pixel's way through a plane a metre ahead, n the
/// unit normal in the picture's axes. Flatter, nobody tells anything from a picture.
[[nodiscard]] double seen_area_m2(const TruthFrame& truth, const Pinhole& camera) noexcept;

}  // namespace slackwater::twin

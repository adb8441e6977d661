#pragma once
#include "twin/render/frame/pixel_footprint.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// How much of a pixel a mark covers, 0 to 1: of 8 x 8 places spread evenly over the footprint,
/// those that the mark holds; all of it where it holds the four corners, for marks are convex. So a
/// crack that is thinner than a pixel darkens it by as much as it covers, instead of all or
/// nothing.
[[nodiscard]] double share_of(const DefectMark& mark, const PixelFootprint& pixel) noexcept;

}  // namespace slackwater::twin

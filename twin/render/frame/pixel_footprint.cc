#include "twin/render/frame/pixel_footprint.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

PixelFootprint::PixelFootprint(const Pinhole& camera, const Triple<double>& at_m,
                               const Triple<double>& face) noexcept
    : middle_m(at_m) {
  // A face that is all but edge-on is seen as if it turned 3 degrees towards the camera.
  constexpr double least_cosine = 0.05;
  const Triple<double> way = at_m - camera.position_m();
  const double depth_m = dot(way, camera.axis()), far_m = length_of(way);
  const double towards = dot(face, way);
  const double across = std::copysign(std::max(std::abs(towards), least_cosine * far_m), towards);
  const auto laid = [&](const Triple<double>& s) { return s - (dot(face, s) / across) * way; };
  side_m = (depth_m / camera.focal_u()) * laid(camera.right());
  down_m = (depth_m / camera.focal_v()) * laid(camera.down());
}

}  // namespace slackwater::twin

#include "twin/render/frame/seen_area.h"

#include <cmath>

namespace slackwater::twin {
namespace {

/// |n . d| of a pixel: d = (x, y, 1) through a plane a metre ahead, n in the picture's axes.
double through_pixel(const Pinhole& camera, int i, int j,
                     const std::array<float, 3>& normal) noexcept {
  const double x = (i + 0.5 - 0.5 * camera.wide()) / camera.focal_u();
  const double y = (j + 0.5 - 0.5 * camera.high()) / camera.focal_v();
  return std::abs(x * static_cast<double>(normal[0]) + y * static_cast<double>(normal[1]) +
                  static_cast<double>(normal[2]));
}

}  // namespace

double seen_area_m2(const TruthFrame& truth, const Pinhole& camera) noexcept {
  constexpr double flattest_cosine = 0.17364817766693036;  // 80 degrees
  double sum_m2 = 0;
  std::size_t at = 0;
  for (int j = 0; j < camera.high(); ++j)
    for (int i = 0; i < camera.wide(); ++i, ++at) {
      if (truth.instance[at] == 0) continue;
      const double depth_m = static_cast<double>(truth.depth_m[at]);
      const double range_m = static_cast<double>(truth.range_m[at]);
      const double through = through_pixel(camera, i, j, truth.normal[at]);
      if (through * depth_m < flattest_cosine * range_m) continue;
      sum_m2 += depth_m * depth_m / (camera.focal_u() * camera.focal_v() * through);
    }
  return sum_m2;
}

}  // namespace slackwater::twin

#include "twin/render/frame/stereo.h"

#include <cmath>
#include <limits>

#include "fields/base/parallel.h"

namespace slackwater::twin {

Pose right_of(const Pose& left, double baseline_m) noexcept {
  Pose right = left;
  const Triple<double> arm_m = baseline_m * left.right;
  right.position_m = left.position_m + arm_m;
  right.velocity_m_s = left.velocity_m_s + cross(left.turning_rad_s, arm_m);
  return right;
}

StereoTruth stereo_truth(const Pinhole& left, const TruthFrame& truth, const FrameHits& hits,
                         double baseline_m, const RayCaster& caster, int threads) {
  constexpr float nothing_seen = std::numeric_limits<float>::quiet_NaN();
  constexpr double before = 1 - 1e-6;  // of the way: the place itself does not stand in its own way
  StereoTruth stereo;
  stereo.disparity.assign(truth.pixels(), nothing_seen);
  stereo.is_in_both.assign(truth.pixels(), 0);
  const Triple<double> right_eye_m = left.position_m() + baseline_m * left.right();
  for_all(static_cast<std::size_t>(left.high()), threads, [&](std::size_t j) {
    for (int i = 0; i < left.wide(); ++i) {
      const std::size_t at =
          j * static_cast<std::size_t>(left.wide()) + static_cast<std::size_t>(i);
      if (!hits.is_hit(at)) continue;
      const Ray ray = left.ray(i, static_cast<int>(j));
      const double range_m = hits.range_m[at];
      const double depth_m = range_m * dot(ray.direction, left.axis());
      const double disparity = left.focal_u() * baseline_m / depth_m;
      stereo.disparity[at] = static_cast<float>(disparity);
      if (!(i + 0.5 - disparity >= 0)) continue;
      const Triple<double> way = ray.from_m + range_m * ray.direction - right_eye_m;
      const double away_m = length_of(way);
      stereo.is_in_both[at] =
          caster.is_blocked({right_eye_m, (1 / away_m) * way}, before * away_m) ? 0 : 1;
    }
  });
  return stereo;
}

}  // namespace slackwater::twin

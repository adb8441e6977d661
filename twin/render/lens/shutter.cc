#include "twin/render/lens/shutter.h"

#include <algorithm>
#include <cmath>

#include "fields/base/parallel.h"

namespace slackwater::twin {
namespace {

/// Between the middles of four pixels; held at the edges.
std::array<double, 3> light_at(const LightFrame& frame, double u, double v) noexcept {
  const double x = std::clamp(u - 0.5, 0.0, frame.wide - 1.0);
  const double y = std::clamp(v - 0.5, 0.0, frame.high - 1.0);
  const auto left = static_cast<std::size_t>(x), top = static_cast<std::size_t>(y);
  const auto wide = static_cast<std::size_t>(frame.wide);
  const std::size_t right = std::min(left + 1, wide - 1);
  const std::size_t bottom = std::min(top + 1, static_cast<std::size_t>(frame.high) - 1);
  const double a = x - static_cast<double>(left), b = y - static_cast<double>(top);
  std::array<double, 3> light{};
  for (std::size_t k = 0; k < light.size(); ++k) {
    const auto one = [&](std::size_t row, std::size_t column) {
      return static_cast<double>(frame.light[row * wide + column][k]);
    };
    const double upper = one(top, left) + a * (one(top, right) - one(top, left));
    const double lower = one(bottom, left) + a * (one(bottom, right) - one(bottom, left));
    light[k] = upper + b * (lower - upper);
  }
  return light;
}

}  // namespace

std::array<double, 2> image_motion_px_s(const Pinhole& camera, const Pose& pose,
                                        const Triple<double>& way_m) noexcept {
  const Triple<double> runs = -1.0 * (pose.velocity_m_s + cross(pose.turning_rad_s, way_m));
  const double z = dot(way_m, camera.axis()), z_runs = dot(runs, camera.axis());
  const auto along = [&](const Triple<double>& side, double focal) {
    return focal * (dot(runs, side) - dot(way_m, side) * z_runs / z) / z;
  };
  return {along(camera.right(), camera.focal_u()), along(camera.down(), camera.focal_v())};
}

LightFrame through_shutter(const LightFrame& light, const Shutter& shutter, const Pinhole& camera,
                           const Pose& pose, const FrameHits& hits, int threads) {
  constexpr double seen_px = 0.02;       // less than that is as if it stood still
  constexpr double without_end_m = 1e9;  // sky and open water only turn
  constexpr int most_points = 512;
  LightFrame out = light;
  for_all(static_cast<std::size_t>(light.high), threads, [&](std::size_t j) {
    const double middle_s = (static_cast<double>(j) + 0.5 - 0.5 * light.high) * shutter.line_time_s;
    for (int i = 0; i < light.wide; ++i) {
      const std::size_t at = j * static_cast<std::size_t>(light.wide) + static_cast<std::size_t>(i);
      const double range_m = hits.is_hit(at) ? hits.range_m[at] : without_end_m;
      const auto [u_px_s, v_px_s] =
          image_motion_px_s(camera, pose, range_m * camera.ray(i, static_cast<int>(j)).direction);
      const double speed_px_s = std::hypot(u_px_s, v_px_s);
      if (speed_px_s * (shutter.exposure_s + std::abs(middle_s)) < seen_px) continue;
      const double smear_px = speed_px_s * shutter.exposure_s;
      const int points = std::clamp(
          static_cast<int>(std::min<double>(most_points, 2 * smear_px)) + 1, 1, most_points);
      std::array<double, 3> sum{};
      for (int k = 0; k < points; ++k) {
        const double t_s = middle_s + shutter.exposure_s * ((k + 0.5) / points - 0.5);
        const auto one =
            light_at(light, i + 0.5 - u_px_s * t_s, static_cast<double>(j) + 0.5 - v_px_s * t_s);
        for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += one[c];
      }
      for (std::size_t c = 0; c < sum.size(); ++c)
        out.light[at][c] = static_cast<float>(sum[c] / points);
    }
  });
  return out;
}

}  // namespace slackwater::twin

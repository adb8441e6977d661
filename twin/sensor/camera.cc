#include "twin/sensor/camera.h"

#include <array>
#include <cmath>

namespace slackwater::twin {

double Camera::focal_length_pixels() const noexcept {
  return pixels_wide / (2 * std::tan(horizontal_field_rad / 2));
}

std::optional<Sighting> sighting(const Camera& camera, const Scene& scene,
                                 const Triple<double>& vehicle_m, const Rotation<double>& r,
                                 double u, double v) {
  const double f = camera.focal_length_pixels();
  const double right = u - 0.5 * camera.pixels_wide;
  const double down = v - 0.5 * camera.pixels_high;
  const double size = std::sqrt(f * f + right * right + down * down);
  const double c = std::cos(camera.tilt_rad), s = std::sin(camera.tilt_rad);
  const Triple<double> body{(c * f - s * down) / size, right / size, (s * f + c * down) / size};
  const Ray ray{vehicle_m + r.to_ned(camera.position_m), r.to_ned(body)};
  const std::optional<Hit> hit = first_hit(scene, ray);
  if (!hit || hit->range_m > camera.visibility_m) return std::nullopt;
  Sighting seen;
  seen.range_m = hit->range_m;
  seen.at_m = ray.from_m + hit->range_m * ray.direction;
  seen.squareness = hit->squareness(ray);
  // A pixel at the angle a from the axis is cos(a)/f wide across the plane of that angle, less
  // within it.
  seen.pixel_size_m = hit->range_m / size / seen.squareness;
  return seen;
}

Footprint footprint(const Camera& camera, const Scene& scene, const Triple<double>& vehicle_m,
                    const Rotation<double>& r, int per_side) {
  const double w = camera.pixels_wide, h = camera.pixels_high;
  const std::array<std::array<double, 2>, 5> corners{{{0, 0}, {w, 0}, {w, h}, {0, h}, {0, 0}}};
  Footprint out;
  for (std::size_t side = 0; side < 4; ++side) {
    for (int k = 0; k < per_side; ++k) {
      const double share = static_cast<double>(k) / per_side;
      const double u = corners[side][0] + share * (corners[side + 1][0] - corners[side][0]);
      const double v = corners[side][1] + share * (corners[side + 1][1] - corners[side][1]);
      if (const auto seen = sighting(camera, scene, vehicle_m, r, u, v))
        out.outline_m.push_back(seen->at_m);
      else
        out.whole = false;
    }
  }
  out.centre = sighting(camera, scene, vehicle_m, r, w / 2, h / 2);
  return out;
}

}  // namespace slackwater::twin

#include "twin/render/scene/sea_mesh.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/wave/sea_sampling.h"

namespace slackwater::twin {

TriangleMesh sea_mesh(const SeaRealisation* sea, const Triple<double>& middle_m, double reach_m,
                      double t_s) {
  constexpr std::uint32_t round = 160;
  constexpr double first_m = 0.25, grows = 1 + 1.0 / 14;
  std::vector<WavePlace> places{{middle_m.y, middle_m.x, 0, t_s}};
  std::vector<Triple<double>> from_middle_m{{0, 0, 0}};
  for (double out_m = first_m;; out_m *= grows) {
    const double ring_m = std::min(out_m, reach_m);
    for (std::uint32_t i = 0; i < round; ++i) {
      const double bearing = 2 * constants::pi * i / round;
      const double north = ring_m * std::cos(bearing), east = ring_m * std::sin(bearing);
      from_middle_m.push_back({north, east, 0});
      places.push_back({middle_m.y + east, middle_m.x + north, 0, t_s});
    }
    if (out_m >= reach_m) break;
  }
  std::vector<double> height_m(places.size(), 0.0);
  if (sea != nullptr) sample_elevation(*sea, places, height_m);
  TriangleMesh mesh;
  mesh.origin_m = {middle_m.x, middle_m.y, 0};
  for (std::size_t i = 0; i < places.size(); ++i)
    mesh.corners.push_back({static_cast<float>(from_middle_m[i].x),
                            static_cast<float>(from_middle_m[i].y),
                            static_cast<float>(std::isfinite(height_m[i]) ? -height_m[i] : 0.0)});
  for (std::uint32_t i = 0; i < round; ++i)
    mesh.triangles.push_back({0, 1 + (i + 1) % round, 1 + i});
  const auto rings = static_cast<std::uint32_t>((places.size() - 1) / round);
  for (std::uint32_t k = 0; k + 1 < rings; ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = 1 + k * round + i, b = 1 + k * round + (i + 1) % round;
      mesh.triangles.push_back({a, b, b + round});
      mesh.triangles.push_back({a, b + round, a + round});
    }
  return mesh;
}

}  // namespace slackwater::twin

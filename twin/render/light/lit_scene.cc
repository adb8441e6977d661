#include "twin/render/light/lit_scene.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {

double clear_beam_w_m2(double elevation_deg) noexcept {
  if (!(elevation_deg > 0)) return 0;
  const double sine = std::sin(elevation_deg * constants::degree);
  const double air_mass = 1 / (sine + 0.50572 * std::pow(elevation_deg + 6.07995, -1.6364));
  return 1353 * std::pow(0.7, std::pow(air_mass, 0.678)) * sine;
}

Sky clear_sky(double elevation_deg, double azimuth_deg) noexcept {
  const double up = elevation_deg * constants::degree, round = azimuth_deg * constants::degree;
  Sky sky;
  sky.to_sun = {std::cos(up) * std::cos(round), std::cos(up) * std::sin(round), -std::sin(up)};
  constexpr double of_sky = 0.1;  // of the beam at right angles
  if (elevation_deg > 0) sky.beam = std::sin(up) / (std::sin(up) + of_sky);
  return sky;
}

Shadows shadows_of(const RenderScene& scene) {
  std::vector<TriangleMesh> meshes;
  for (const SeenThing& thing : scene.things)
    if (thing.seen_class != SeenClass::water) meshes.push_back(thing.mesh);
  return {std::make_shared<const RayCaster>(meshes), nullptr};
}

}  // namespace slackwater::twin

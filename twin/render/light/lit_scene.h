#pragma once
#include <memory>
#include <vector>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/render/light/growth.h"
#include "twin/render/light/water_type.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// Daylight, stated: where the sun stands and what share of the light is its beam. Under an
/// overcast sky there is no beam; a sun below the horizon has none either.
struct Sky {
  Triple<double> to_sun{0, 0, -1};  ///< unit, NED
  double beam = 0;  ///< of what falls on a level face, 0 to below 1: the rest is the sky's
};

/// A clear sky over a sun at an elevation. The beam is Meinel's, I = 1353 * 0.7^(m^0.678) W/m2,
/// through an air mass m of Kasten and Young, 1/(sin h + 0.50572 (h + 6.07995)^-1.6364) with h in
/// degrees; the sky adds a tenth of it, so that beam = sin h / (sin h + 0.1).
/// Sources: Meinel and Meinel (1976), Applied Solar Energy; Kasten and Young (1989), Applied Optics
/// 28(22), 4735-4738.
/// @param azimuth_deg  clockwise from north
[[nodiscard]] Sky clear_sky(double elevation_deg, double azimuth_deg) noexcept;
/// I sin h of it: what falls on a level face of the beam, W/m2.
[[nodiscard]] double clear_beam_w_m2(double elevation_deg) noexcept;

/// A lamp, as the inspection has it (seen_light.h): in clear water it lights a place before it, at
/// its range, as well as is needed; its light falls off with the cosine from its axis, and ends at
/// the edge of its beam, over a tenth of its angle.
struct Lamp {
  Triple<double> position_m;  ///< NED of the run
  Triple<double> axis;        ///< unit
  double range_m = 0;
  double half_beam_rad = 1.5707963267948966;
};

/// Who stands in whose light: the triangles of things, cast at. What does not move is asked in a
/// caster that lasts; the sea keeps no light off.
struct Shadows {
  std::shared_ptr<const RayCaster> still;   ///< may be null
  std::shared_ptr<const RayCaster> moving;  ///< may be null

  [[nodiscard]] bool is_blocked(const Ray& ray, double most_range_m) const {
    return (still && still->is_blocked(ray, most_range_m)) ||
           (moving && moving->is_blocked(ray, most_range_m));
  }
};
/// One caster of all things but the sea.
[[nodiscard]] Shadows shadows_of(const RenderScene& scene);

/// What is needed to see a scene in its light.
struct Lighting {
  ColouredClarity water;
  ColouredClarity air;
  Sky sky;
  std::vector<Lamp> lamps;
  Shadows shadows;
  double growth = usual_growth;  ///< how much steel under water is overgrown (growth.h)
  double sea_slope = 0.03;       ///< mean square, of waves too short for its mesh (sun_glint.h)
  std::uint64_t seed = 0;        ///< of materials
};

}  // namespace slackwater::twin

#pragma once
#include <optional>
#include <span>
#include <variant>

#include "twin/body/spatial.h"

namespace slackwater::twin {

// What stands in the water: NED metres from the site's origin, z down from mean sea level.

/// A vertical cylinder with flat ends: a monopile, the leg of a jacket, a tower.
struct Cylinder {
  double north_m = 0;
  double east_m = 0;
  double radius_m = 0;
  double top_m = 0;     ///< z, negative above the sea
  double bottom_m = 0;  ///< z, more than `top_m`
};

/// A box on end, turned about the vertical.
struct Box {
  Triple<double> centre_m;
  Triple<double> half_size_m;  ///< forward, to the right, down
  double heading_cosine = 1;
  double heading_sine = 0;
};
[[nodiscard]] Box box_of(const Triple<double>& centre_m, const Triple<double>& half_size_m,
                         double heading_rad) noexcept;

using Structure = std::variant<Cylinder, Box>;

/// To the nearest point of the surface, negative inside. Exact, and usable in the step.
template <typename Real>
[[nodiscard]] Real signed_distance_m(const Cylinder& c, const Triple<Real>& at_m) {
  const Real none = Real{} + 0.0;
  const Real north = at_m.x - c.north_m, east = at_m.y - c.east_m;
  const Real aside = square_root(north * north + east * east) - c.radius_m;
  const Real above = absolute(at_m.z - 0.5 * (c.top_m + c.bottom_m)) - 0.5 * (c.bottom_m - c.top_m);
  const Real out_aside = larger_of(aside, none), out_above = larger_of(above, none);
  return square_root(out_aside * out_aside + out_above * out_above) +
         smaller_of(larger_of(aside, above), none);
}
template <typename Real>
[[nodiscard]] Real signed_distance_m(const Box& b, const Triple<Real>& at_m) {
  const Real none = Real{} + 0.0;
  const Real north = at_m.x - b.centre_m.x, east = at_m.y - b.centre_m.y;
  const Real x = absolute(b.heading_cosine * north + b.heading_sine * east) - b.half_size_m.x;
  const Real y = absolute(b.heading_cosine * east - b.heading_sine * north) - b.half_size_m.y;
  const Real z = absolute(at_m.z - b.centre_m.z) - b.half_size_m.z;
  const Real ox = larger_of(x, none), oy = larger_of(y, none), oz = larger_of(z, none);
  return square_root(ox * ox + oy * oy + oz * oz) + smaller_of(larger_of(x, larger_of(y, z)), none);
}
[[nodiscard]] double signed_distance_m(const Structure& structure, const Triple<double>& at_m);

/// The least signed distance along a straight way, within 1e-9 of its length; negative where the
/// way leads through.
[[nodiscard]] double least_distance_m(const Structure& structure, const Triple<double>& from_m,
                                      const Triple<double>& to_m);

/// A half line; `direction` is a unit vector.
struct Ray {
  Triple<double> from_m;
  Triple<double> direction;
};

/// Where a ray first meets a surface from outside.
struct Hit {
  double range_m = 0;
  Triple<double> normal;  ///< unit, outward

  /// Cosine of the angle between the ray, looked at backwards, and the normal: 1 for a ray that
  /// meets it squarely.
  [[nodiscard]] double squareness(const Ray& ray) const { return -dot(ray.direction, normal); }
};

/// Nothing for a ray that misses or starts inside.
[[nodiscard]] std::optional<Hit> first_hit(const Structure& structure, const Ray& ray);
/// A horizontal plane: the sea bed seen from above, the surface seen from below.
[[nodiscard]] std::optional<Hit> hit_of_level(double level_m, const Ray& ray);

/// All that a sound or a look can meet.
struct Scene {
  std::span<const Structure> structures;
  double bed_m = 0;      ///< z of a level bed
  double surface_m = 0;  ///< z of the surface, negative when it stands high
};
[[nodiscard]] std::optional<Hit> first_hit(const Scene& scene, const Ray& ray);

}  // namespace slackwater::twin

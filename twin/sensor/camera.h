#pragma once
#include <optional>
#include <vector>

#include "twin/scene/structure.h"

namespace slackwater::twin {

/// A pinhole camera that looks forward, tilted downwards: the pixel (u, v), counted from the upper
/// left corner, sees along
///
///   (f, u - w/2, v - h/2) / |...|,  f = w / (2 tan(fov/2)) in pixels.
///
/// The field of view is the one in the medium: a flat port narrows it under water by the refractive
/// index, 1.33.
/// Source: Hartley and Zisserman, Multiple View Geometry (2004), 6.1. Defaults: the kind of the
/// BlueROV2's camera (1080p, 64 degrees in water; unconfirmed); the visibility is that of fair
/// North Sea water, an estimate.
struct Camera {
  int pixels_wide = 1920;
  int pixels_high = 1080;
  double horizontal_field_rad = 1.117;
  double tilt_rad = 0;
  Triple<double> position_m;  ///< on the vehicle, body axes
  double visibility_m = 5;    ///< nothing is made out beyond

  [[nodiscard]] double focal_length_pixels() const noexcept;
};

/// What a pixel sees.
struct Sighting {
  Triple<double> at_m;
  double range_m = 0;
  double squareness = 0;    ///< cosine of the angle of incidence: 1 is seen squarely
  double pixel_size_m = 0;  ///< what a pixel covers of the surface along its longer side, at most
};
[[nodiscard]] std::optional<Sighting> sighting(const Camera& camera, const Scene& scene,
                                               const Triple<double>& vehicle_m,
                                               const Rotation<double>& r, double u, double v);

/// The edge of what a picture shows, walked around from the upper left corner.
struct Footprint {
  std::vector<Triple<double>> outline_m;
  bool whole =
      true;  ///< false where a part of the edge sees nothing: then the outline leaves it out
  std::optional<Sighting> centre;
};
/// @param per_side  points on each side of the picture, at least 1: 1 is enough for a plane, whose
///                  outline is straight
[[nodiscard]] Footprint footprint(const Camera& camera, const Scene& scene,
                                  const Triple<double>& vehicle_m, const Rotation<double>& r,
                                  int per_side);

}  // namespace slackwater::twin

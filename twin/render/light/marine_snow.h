#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// Flakes in the water before the lens, all alike.
struct MarineSnow {
  double per_m3 = 0;
  double diameter_m = 0.002;
  double reflectance = 0.3;
  double nearest_m = 0.1;  ///< along the camera's axis: nearer ones are out of focus
  /// Farther ones are too small to be told apart: they are in the water's own backscatter.
  double reach_m = 3;
};

/// A flake in view.
struct Flake {
  double u = 0;        ///< pixels from the left edge
  double v = 0;        ///< from the upper edge
  double depth_m = 0;  ///< along the axis
};

/// The volume in view between two depths, w h/(f_u f_v) (far^3 - near^3)/3, m3.
[[nodiscard]] double volume_in_view_m3(const Pinhole& camera, double near_m, double far_m) noexcept;

/// Those of a picture: a Poisson number with the mean per_m3 times the volume in view, evenly over
/// it. By the seed alone; flakes of two pictures have nothing to do with each other.
[[nodiscard]] std::vector<Flake> flakes_in_view(const MarineSnow& snow, const Pinhole& camera,
                                                std::uint64_t seed);

/// The picture with its flakes: each adds, over the pixels that its disc of f diameter/z covers, as
/// much as a place of its reflectance would that all light falls on squarely,
///
///   reflectance/rho (D + sum over lamps of R^2 cos(from its axis)/d^2 exp(-c d)) exp(-c s)
///
/// (light_frame.h), s away. One behind what its pixel meets is not seen. Stand-ins: flakes hide
/// nothing, are in no shadow, and are round. The truth of the picture does not know them.
/// @param camera  under water
[[nodiscard]] LightFrame with_flakes(const LightFrame& light, const std::vector<Flake>& flakes,
                                     const MarineSnow& snow, const Lighting& lighting,
                                     double surface_m, const Pinhole& camera,
                                     const FrameHits& hits);

}  // namespace slackwater::twin

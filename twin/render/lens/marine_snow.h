#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/lens/specks.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// Flakes in the water before the lens. Those beyond their reach are in the water's own
/// backscatter.
struct MarineSnow {
  Specks flakes;
  double reflectance = 0.3;
};

[[nodiscard]] std::vector<Speck> flakes_in_view(const MarineSnow& snow, const Pinhole& camera,
                                                std::uint64_t seed);

/// The picture with its flakes: each adds, over the pixels that its disc of f diameter/z covers, as
/// much as a place of its reflectance would that all light falls on squarely,
///
///   reflectance/rho (D + sum over lamps of R^2 cos(from its axis)/d^2 exp(-c d)) exp(-c s)
///
/// (light_frame.h), s away. One behind what its pixel meets is not seen. Stand-ins: flakes hide
/// nothing, are in no shadow, and are round. The truth of the picture does not know them.
/// @param camera  under water
[[nodiscard]] LightFrame with_flakes(const LightFrame& light, const std::vector<Speck>& flakes,
                                     const MarineSnow& snow, const Lighting& lighting,
                                     double surface_m, const Pinhole& camera,
                                     const FrameHits& hits);

}  // namespace slackwater::twin

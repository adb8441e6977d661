#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/lens/specks.h"
#include "twin/render/light/light_frame.h"

namespace slackwater::twin {

/// Drops of spray or rain in the air before the lens.
[[nodiscard]] std::vector<Speck> drops_in_view(const Specks& spray, const Pinhole& camera,
                                               std::uint64_t seed);

/// Where a look goes on behind a drop, a ball of water of index n = 1.333 that it meets `off` of
/// its radius from the middle: in and out by Snell's law, 2 (asin(off) - asin(off/n)) towards the
/// other side, so that a drop shows what is about it upside down.
/// Source: van de Hulst (1957), Light Scattering by Small Particles, 12.2 (the ray p = 1).
/// @param look  unit
/// @param side  unit, square to the look, from the drop's middle to where it is met
/// @param off   0 to 1
[[nodiscard]] Triple<double> look_through_drop(const Triple<double>& look,
                                               const Triple<double>& side, double off) noexcept;

/// The picture with its drops: each hides what is behind the pixels that its disc covers, and shows
/// there, of `look_through_drop`, the sky (`sky_light`) or a level sea (`sea_light`) through the
/// air between. What a drop mirrors inside and out is taken to come along with that: water takes
/// nothing away on a millimetre, and in an even light a drop is not seen at all. One behind what
/// its pixel meets is not seen. Stand-ins: a drop shows neither the scene's things nor the lamps;
/// it hangs still, and is round. The truth of the picture does not know them.
/// @param camera  above water
[[nodiscard]] LightFrame with_drops(const LightFrame& light, const std::vector<Speck>& drops,
                                    const Specks& spray, const Lighting& lighting, double surface_m,
                                    const Pinhole& camera, const FrameHits& hits);

}  // namespace slackwater::twin

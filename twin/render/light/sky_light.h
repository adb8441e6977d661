#pragma once
#include "twin/inspection/instrument/seen_light.h"
#include "twin/render/light/lit_scene.h"

namespace slackwater::twin {

/// Light is told in that of a place of the usual reflectance: a white one has so many times of it.
inline constexpr double whites_light = 1 / usual_reflectance;

/// What the sky sends along a look, at and below the horizon what it sends from there: the CIE's
/// overcast sky, (1 + 2 sin h)/3 (Moon and Spencer 1942); a clear one is blue, an estimate. The
/// sun's disc is not in it.
/// @param direction  unit, NED, of the look
[[nodiscard]] Bands sky_light(const Lighting& lighting, const Triple<double>& direction) noexcept;

/// What the sea sends along a look from above: the sky that it mirrors, the light that comes back
/// out of it, and the sun's glitter (light_frame.h).
/// @param direction, normal  unit, NED; the look goes down onto a face that looks up
[[nodiscard]] Bands sea_light(const Lighting& lighting, const Triple<double>& direction,
                              const Triple<double>& normal) noexcept;

}  // namespace slackwater::twin

#pragma once
#include <cstdint>

#include "twin/body/spatial.h"
#include "twin/render/light/water_type.h"

namespace slackwater::twin {

/// How much of steel under water is overgrown where nobody says so, 0 none to 1 all.
inline constexpr double usual_growth = 0.5;

/// What has grown on a place.
struct Growth {
  double share = 0;  ///< of the ground that it hides
  Bands albedo{};
};

/// Growth on steel between the surface and 20 m of depth, in patches of about 0.7 m, less with
/// depth. It is of four kinds, in stretches of about 1.1 m: slime and algae (green to brown),
/// mussels (near black, 20 mm), soft growth (orange, brown and white: hydroids and anemones, which
/// a detector of rust has to leave alone) and barnacles (pale dots of 15 mm). Kinds, sizes and
/// colours are estimates by eye of photographs of North Sea piles; no mark counts them.
/// @param at_m    NED of the run
/// @param amount  0 to 1
[[nodiscard]] Growth growth_at(const Triple<double>& at_m, double amount,
                               std::uint64_t seed) noexcept;

}  // namespace slackwater::twin

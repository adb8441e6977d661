#pragma once
#include <array>
#include <cstdint>

#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

/// What a pixel shows, for people and detectors: the numbers are those of the files.
enum class SeenClass : std::uint8_t {
  nothing,  ///< open water or sky
  monopile,
  transition_piece,
  tower,
  nacelle,
  blade,
  anodes,
  mooring_line,
  cable,
  bed,
  water,      ///< the surface of the sea, from above or below
  structure,  ///< of the scenario, that nobody inspects
  vehicle,
  vessel,  ///< of the traffic
  tether,  ///< of a vehicle
};
inline constexpr std::size_t seen_classes = 15;
[[nodiscard]] const char* name_of(SeenClass seen) noexcept;
[[nodiscard]] SeenClass class_of(SurfaceKind kind) noexcept;

/// What it is made of, which gives it its colours (twin/render/light/albedo.h).
enum class Material : std::uint8_t {
  none,
  yellow_paint,
  grey_paint,
  gelcoat,  ///< of blades, white
  steel,    ///< bare or under thin slime
  concrete,
  anode,  ///< aluminium alloy, pitted
  sand,
  rubber,   ///< of cables
  plastic,  ///< of vehicles
  water,
  rust,    ///< corrosion
  growth,  ///< soft and hard, mixed
  crack,
};
inline constexpr std::size_t materials = 14;
[[nodiscard]] const char* name_of(Material material) noexcept;
[[nodiscard]] Material usual_material_of(SurfaceKind kind) noexcept;

}  // namespace slackwater::twin

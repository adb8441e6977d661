#pragma once
#include <cstdint>

#include "twin/render/light/water_type.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// Smooth noise over space, 0 to 1, mean 1/2: random numbers at the corners of cubes of one length,
/// blended by 3 t^2 - 2 t^3, four octaves of halved lengths and weights. The same bits everywhere:
/// the numbers are those of SplitMix64 by the corner alone.
/// Source: Perlin (1985), SIGGRAPH 19(3), 287-296, as value noise.
[[nodiscard]] double value_noise(const Triple<double>& at_m, double length_m,
                                 std::uint64_t seed) noexcept;

/// What a place of a material throws back of red, green and blue, as a Lambert face: two colours of
/// the material, mixed by noise. The colours are estimates by eye of what photographs of the kind
/// show; only that wet dark steel, growth and mud are near 0.1 is the inspection's
/// (`usual_reflectance`).
[[nodiscard]] Bands albedo_of(Material material, const Triple<double>& at_m,
                              std::uint64_t seed) noexcept;

/// The same of a place of a thing: where it shows a defect, that of rust, growth, a gap, ... ; on
/// steel, anodes and yellow paint under water what has grown there (growth.h); on the steel of
/// piles, transition pieces and towers a weld all round each 3 m (the height of a can, an
/// estimate), 24 mm wide, dark along its toes.
/// @param mark    that holds the place; null: none
/// @param growth  how much is overgrown, 0 to 1
[[nodiscard]] Bands albedo_at(const SeenThing& thing, const DefectMark* mark,
                              const Triple<double>& at_m, double growth,
                              std::uint64_t seed) noexcept;

/// 0 below `from`, 1 above `to`, smooth between.
[[nodiscard]] double step_between(double from, double to, double x) noexcept;

/// What a place of a thing is of: of its own, or what a defect lays bare.
/// @param mark  that holds the place; null: none
[[nodiscard]] Material material_at(const SeenThing& thing, const DefectMark* mark) noexcept;

}  // namespace slackwater::twin

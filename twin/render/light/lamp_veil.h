#pragma once
#include <array>

#include "twin/render/light/lit_scene.h"

namespace slackwater::twin {

/// The edge of a lamp's beam, as cosines from its axis.
struct BeamEdge {
  double full = 0;  ///< within: all of it
  double dark = 0;  ///< beyond: nothing
  explicit BeamEdge(const Lamp& lamp) noexcept {
    constexpr double right_angle = 1.5707963267948966;
    if (lamp.half_beam_rad >= right_angle) return;
    dark = std::cos(lamp.half_beam_rad);
    full = std::cos(0.9 * lamp.half_beam_rad);
  }
  /// The cosine, and what the edge leaves of it.
  [[nodiscard]] double lit(double cosine) const noexcept {
    if (!(cosine > dark)) return 0;
    if (cosine >= full) return cosine;
    const double t = (cosine - dark) / (full - dark);
    return cosine * t * t * (3 - 2 * t);
  }
};

/// The way of a look past a lamp, cut into the eight points of its integral over the logarithm of
/// the way out and back (`lamp_veil_per_m`).
struct LookPastLamp {
  std::array<double, 8> lit{};    ///< of each point, with its weight
  std::array<double, 8> way_m{};  ///< out and back
  bool is_dark = true;

  LookPastLamp(const Lamp& lamp, const BeamEdge& edge, const Ray& ray, double range_m) noexcept;
  /// Of each colour by its beam attenuation.
  [[nodiscard]] Bands sums(const Bands& beam_attenuation_per_m) const noexcept;
};

/// int_0^r cos(from a lamp's axis) beam / d(s)^2 exp(-c (s + d(s))) ds along a ray: what the water
/// before an eye is lit by a lamp anywhere, with the ways to and from it.
[[nodiscard]] double lamp_veil_along_per_m(const Lamp& lamp, const Ray& ray, double range_m,
                                           double beam_attenuation_per_m) noexcept;

}  // namespace slackwater::twin

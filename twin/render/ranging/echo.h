#pragma once
#include <cmath>

#include "twin/inspection/cast/ray_caster.h"
#include "twin/render/light/counted_noise.h"
#include "twin/render/light/fading.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// What the echoes of all sonars have in common.
///
/// Spreading is spherical, there and back; the water takes `a` dB/m one way; the bed throws back by
/// Lambert's law, S = 10 log10(mu) + 10 log10(cos^2 i), with Mackenzie's 27 dB below for mu
/// (Mackenzie 1961, J. Acoust. Soc. Am. 33, 1498). What a ray of solid angle dW meets squarely or
/// not at range r throws back, of a source of intensity 1 at 1 m, is so
///
///   dI = mu cos(i) dW b^2 10^(-2 a r/10) / r^2
///
/// for dA = r^2 dW / cos(i). The surface of the sea, seen from below, throws back as the bed does
/// (an estimate), and nothing comes by way of it.

/// x of 10^(-2 a r/10) = exp(-x r).
[[nodiscard]] inline double taken_both_ways_per_m(double absorption_db_m) noexcept {
  constexpr double ln10 = 2.302585092994046;
  return 2 * absorption_db_m * ln10 / 10;
}

/// b^2 of a beam of so many radians between its half-power points, `off_rad` from its middle: once
/// out and once in, b = exp(-ln 2 (2 off/width)^2).
[[nodiscard]] inline double pattern_both_ways(double off_rad, double half_power_rad) noexcept {
  constexpr double ln2 = 0.6931471805599453;
  const double off = 2 * off_rad / half_power_rad;
  return fading(2 * ln2 * off * off);
}

/// Beams are cast into over so many of their half-power widths: beyond, b^2 is 4e-6.
inline constexpr double cast_widths = 3;

/// What a ray throws back: dI with `weight` for mu dW b^2, cos(i) of the triangle that it meets.
[[nodiscard]] inline double thrown_back(double weight, const RenderScene& scene, const Ray& ray,
                                        const CastHit& hit, double taken_per_m) noexcept {
  const double r = hit.range_m;
  const Triple<double> normal = scene.things[hit.mesh].mesh.area_vector_m2(hit.triangle);
  const double squareness = std::abs(dot(normal, ray.direction)) / length_of(normal);
  return weight * squareness * fading(taken_per_m * r) / (r * r);
}

/// Exponential, mean 1: the intensity of many scatterers' speckle (Rayleigh's amplitude).
[[nodiscard]] inline double exponential_at(std::uint64_t key) noexcept {
  return -logarithm(1 - even_at(key));
}

/// An echo of that mean with speckle and noise, by a key alone.
[[nodiscard]] inline double speckled(double mean, double noise_floor, std::uint64_t key) noexcept {
  return mean * exponential_at(key) + noise_floor * exponential_at(key ^ 1U);
}

}  // namespace slackwater::twin

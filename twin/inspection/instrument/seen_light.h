#pragma once
#include "twin/inspection/instrument/look.h"

namespace slackwater::twin {

/// What reaches an instrument of a place's light, and how much of it is not veil.
struct SeenLight {
  double light = 1;     ///< of what the instrument needs, at most 1
  double contrast = 1;  ///< share of the light that comes from the place
};

/// Light and contrast of a place through the water or air between, by single scattering (McGlamery
/// 1979, Proc. SPIE 208; Jaffe 1990, IEEE J. Oceanic Eng. 15(2), 101-111, of which it leaves out
/// what is scattered forward). All light is told as the share of what is needed on a place that is
/// seen through nothing; the place throws back `usual_reflectance` of what falls on it:
///
///     day on it    D = daylight exp(-K z)
///     lamp on it   E = R^2 r / r_l^3 exp(-c r_l),  r_l = (r^2 + h^2)^(1/2)
///     of the place S = (D + E) exp(-c r)
///     veil         V = D (1 - exp(-c r)) + R^2 b_b/(2 rho) J(r)
///     contrast = S / (S + V),  light = min(1, S + V)
///
/// R is the lamp's range in clear water, h how far it is beside the lens, r the way from the lens;
/// its light falls off with the cosine from its axis, which is parallel to the lens'. The water
/// scatters b_b/(2 pi) back into each direction behind: of the lamp by `lamp_veil_per_m`, of the
/// day until it is as bright as the place (Duntley 1963, J. Opt. Soc. Am. 53(2), 214-233). So
///
/// - by day alone the contrast is exp(-c r), and light D;
/// - by the lamp alone, in clear water or near by, contrast light = (R/r)^2 exp(-c (r_l + r)) for
///   h << r, until there is enough of it;
/// - where the lamp's veil hides more than the lamp shows, it is taken to be off.
///
/// What needs no light of day or lamp: contrast exp(-c r) of cameras, exp(-2 c r) of LiDAR, whose
/// light goes there and back; 1 for sound and probes.
///
/// @param depth_m  of the place, positive down
/// @param range_m  above 0
[[nodiscard]] SeenLight seen_light(const Instrument& instrument, const Clarity& clarity,
                                   double depth_m, double range_m) noexcept;

/// Of wet steel, growth and mud, an estimate.
inline constexpr double usual_reflectance = 0.1;

/// J(r) = integral over s from 0 to r of s / s_l^3 exp(-c (s + s_l)) ds, s_l = (s^2 + h^2)^(1/2):
/// what a lamp beside a lens lights of the water before it, with its ways out and back. In clear
/// water 1/h - (r^2 + h^2)^(-1/2). By eight points over the logarithm of s + s_l: to 2e-4 for c r
/// up to 30 and r up to 60 h.
/// @param aside_m  h > 0
[[nodiscard]] double lamp_veil_per_m(double beam_attenuation_per_m, double aside_m,
                                     double range_m) noexcept;

/// Whether a contrast is below that at which a black disc is lost from sight by day, exp(-4.8) =
/// 0.0082 (Davies-Colley 1988): Blackwell's (1946, J. Opt. Soc. Am. 36(11), 624-643) observers lost
/// large discs at some thousandths.
[[nodiscard]] bool is_lost(double contrast) noexcept;

}  // namespace slackwater::twin

#pragma once
#include <optional>
#include <variant>

#include "fields/wind/blended_wake.h"
#include "fields/wind/gaussian_wake.h"
#include "fields/wind/jensen_wake.h"
#include "fields/wind/larsen_wake.h"

namespace slackwater {

enum class WakeModel { jensen, gaussian, larsen, blended };

/// Which wake, and the numbers that replace the published formulas where a wake was measured.
struct WakeSettings {
  WakeModel model = WakeModel::blended;
  /// k of Jensen; offshore (Barthelmie et al. 2009).
  double jensen_growth = 0.04;
  LarsenRadius larsen_radius = LarsenRadius::risoe_2009;
  /// k* of the Gaussian wake; else `wake_growth` of the turbulence.
  std::optional<double> gaussian_growth = std::nullopt;
  /// Fitted shape of the blended wake; else `blended_wake_shape` of thrust and turbulence.
  std::optional<BlendedWakeShape> blended_shape = std::nullopt;
  bool operator==(const WakeSettings&) const = default;
};

/// No wake at all: behind a rotor that stands still.
struct NoWake {
  [[nodiscard]] static double deficit(double, double) noexcept { return 0; }
  [[nodiscard]] static double edge_m(double) noexcept { return 0; }
  [[nodiscard]] static double reach_m(double) noexcept { return -1; }
};

/// One wake as a value. All models answer `deficit(x, r)`, `edge_m(x)` and `reach_m(x)`; visit once
/// per turbine, then sample.
using Wake = std::variant<NoWake, JensenWake, GaussianWake, LarsenWake, BlendedWake>;

/// The wake behind a rotor with this thrust in this turbulence. Thrust coefficients are held below
/// 0.999; 0 or less leaves no wake.
/// @param turbulence_intensity  TI that meets the rotor, a fraction in [0, 1]
[[nodiscard]] Wake make_wake(const WakeSettings& settings, double diameter_m, double hub_height_m,
                             double thrust_coefficient, double turbulence_intensity);

/// Deficit (fraction of the wind at the turbine) x downstream and r off the axis of a wake. 0
/// beside and upstream of the rotor: none of these models knows the blockage ahead of it.
[[nodiscard]] double wake_deficit(const Wake& wake, double downstream_m, double radius_m) noexcept;

/// Turbulence that a rotor adds to the air, at x/D diameters downstream, x > 0:
///   I+ = 0.73 a^0.8325 I0^0.0325 (x/D)^-0.32,  a = (1 - sqrt(1 - Ct))/2.
/// Fitted for 5 < x/D < 15, 0.07 < I0 < 0.14, 0.1 < a < 0.4; used outside as the best there is.
/// Source: Crespo & Hernandez (1996), J. Wind Eng. Ind. Aerodyn. 61, 71; exponent of I0 as in
/// fields/docs/physics.md, section 10.
[[nodiscard]] double added_turbulence(double thrust_coefficient, double ambient_intensity,
                                      double downstream_diameters) noexcept;

}  // namespace slackwater

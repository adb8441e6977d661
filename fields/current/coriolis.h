#pragma once
#include "fields/base/angle.h"

namespace slackwater {

/// Half-width of the band about the equator in which no Ekman balance is asked for. At 3 degrees
/// the inertial period is 9.5 days and the Ekman depth for 0.02 m2/s is 228 m: a day is far too
/// short for a steady balance.
inline constexpr double equatorial_band_deg = 3.0;

/// Coriolis parameter f = 2 Omega sin(latitude), rad/s: positive in the north, 0 on the equator.
[[nodiscard]] double coriolis_parameter_rad_s(Angle latitude) noexcept;

/// Whether |latitude| < 3 degrees. There the models of this folder are not evaluated: the steady
/// column drops the wind-driven term and the bed layer and leaves the interior alone
/// (`level_responses`), and the calibration says so in a warning.
[[nodiscard]] bool is_equatorial(Angle latitude) noexcept;

}  // namespace slackwater

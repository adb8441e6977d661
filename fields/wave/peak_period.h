#pragma once

namespace slackwater {

/// The peak period of a sea of which only a mean period is known, as that of a JONSWAP sea of
/// gamma 3.3 (the mean of its measurements):
///
///   Tp = 1.11 Tm-1,0     energy period                       (1.17 for gamma 1, 1.07 for 7)
///   Tp = 1.29 Tm02       mean zero-upcrossing period         (1.41 for gamma 1, 1.21 for 7)
///
/// Computed from `JonswapSpectrum`, once. Swell and seas of several peaks have no such relation.
/// Source of the spectrum and of the second ratio: DNV-RP-C205, 3.5.5.
[[nodiscard]] double peak_period_of_energy_period_s(double energy_period_s);
[[nodiscard]] double peak_period_of_zero_crossing_period_s(double zero_crossing_period_s);

}  // namespace slackwater

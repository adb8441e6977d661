#pragma once
#include <span>
#include <string_view>

#include "fields/base/time.h"

namespace slackwater {

/// A tidal frequency, named as in Doodson (1921): an integer combination of the rates of the mean
/// lunar day, the mean longitudes of moon and sun, and the longitude of the lunar perigee.
struct Constituent {
  std::string_view name;
  int tau = 0;  ///< multiples of mean lunar time
  int s = 0;    ///< of the mean longitude of the moon
  int h = 0;    ///< of the mean longitude of the sun
  int p = 0;    ///< of the longitude of the lunar perigee
  /// Added to the sum of the four angles so that the equilibrium amplitude is positive, in cycles.
  double offset_cycles = 0;
  double speed_rad_s = 0;
};

/// The constituents Slackwater knows: M2 S2 N2 K2 K1 O1 P1 Q1 M4 MS4 MN4 M6 MSf.
[[nodiscard]] std::span<const Constituent> tidal_constituents() noexcept;

/// One of them by name; Error(not_found) lists the names that exist.
[[nodiscard]] const Constituent& tidal_constituent(std::string_view name);

/// Mean longitudes of the moon (s), the sun (h) and the lunar perigee (p), radians, not reduced to
/// one turn.
struct MeanLongitudes {
  double s_rad = 0;
  double h_rad = 0;
  double p_rad = 0;
};

/// Linear in time since 1899-12-31 12:00 UT; the neglected quadratic terms stay below 0.01 degree
/// for s and h and below 0.2 degree for p between 1950 and 2100. Source: Explanatory Supplement
/// (1961), p. 98 and 107, as used by Schureman (1958) and Foreman (1977).
[[nodiscard]] MeanLongitudes mean_longitudes(UtcTime time) noexcept;

/// Astronomical argument V(t) at Greenwich, radians in [0, 2 pi): the phase of the equilibrium
/// tide, without the 18.6-year nodal corrections (at most 3.7 % of M2 and 19 % of O1, constant over
/// a record of weeks).
[[nodiscard]] double astronomical_argument_rad(const Constituent& constituent,
                                               UtcTime time) noexcept;

}  // namespace slackwater

#pragma once
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"

namespace slackwater::twin {

/// Where the centre of the sun stands, seen from a place at sea level, without refraction.
struct SunPosition {
  double elevation_deg = 0;  ///< above the horizon; below it negative
  double azimuth_deg = 0;    ///< clockwise from true north, 0 to 360
};

/// The low-accuracy position of Meeus: mean longitude and anomaly of the sun, equation of the
/// centre, aberration and the main term of nutation, apparent sidereal time, parallax. Good to
/// 0.01 degrees from 1990 to 2050, of which UTC's distance from UT1 is up to 0.004: against NREL's
/// solar position algorithm as pvlib has it, see tests/strangers/sun.py.
///
/// Cost: some twenty sines. Thread-safe.
/// Source: Meeus, Astronomical Algorithms (2nd ed.), chapters 12, 13, 22 and 25; the NOAA solar
/// calculator is the same but for sidereal time.
[[nodiscard]] SunPosition sun_position(const GeoPoint& point, UtcTime time) noexcept;

}  // namespace slackwater::twin

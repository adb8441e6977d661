#pragma once
#include <span>
#include <vector>

#include "fields/base/frame.h"
#include "fields/service/snapshot.h"
#include "fields/wave/fetch.h"

namespace slackwater {

/// The waves a wind has raised by itself.
struct WindSea {
  double significant_height_m = 0;
  double peak_period_s = 0;
};

/// Wind sea at the end of a fetch, blown over long enough, in water of one depth (Breugem &
/// Holthuijsen 2007):
///
///   H* = 0.24 [A tanh(4.41e-4 X*^0.79 / A)]^0.572,  A = tanh(0.343 d*^1.14)
///   T* = 7.69 [B tanh(2.77e-7 X*^1.45 / B)]^0.187,  B = tanh(0.10 d*^2.01)
///
/// with H* = g Hs/U^2, T* = g Tp/U, X* = g X/U^2, d* = g d/U^2. In deep water it joins Kahma &
/// Calkoen (1992) at short fetch and Pierson & Moskowitz at long fetch. Hs is held at the steepness
/// limit below.
///
/// @param wind_speed_m_s  U at 10 m, >= 0; below 0.5 m/s there is no wind sea (all zero)
/// @param fetch_m         X > 0
/// @param water_depth_m   d > 0
/// Source: J. Waterway Port Coastal Ocean Eng. 133, 225; Holthuijsen (2007), eq. 8.3.5.
[[nodiscard]] WindSea fetch_limited_sea(double wind_speed_m_s, double fetch_m,
                                        double water_depth_m);

/// Fetch along which the energy of a growing sea has travelled after blowing for a while from
/// `start_fetch_m`: dX/dt = min(g T_e/(4 pi), sqrt(g d)), T_e = 0.903 Tp(X), the speed at which a
/// JONSWAP sea carries energy. Heights after a duration are up to a sixth above those of the
/// Coastal Engineering Manual (2002), II-2-35.
[[nodiscard]] double fetch_after(double wind_speed_m_s, double start_fetch_m, double duration_s,
                                 double water_depth_m);

/// Wind sea limited by fetch, duration and depth; none below 0.5 m/s.
[[nodiscard]] WindSea limited_wind_sea(double wind_speed_m_s, double fetch_m, double duration_s,
                                       double water_depth_m);

/// Largest Hs of this peak period: 2 pi Hs/(g Tp^2) <= 1/15 for Tp <= 8 s, 1/25 for Tp >= 15 s,
/// linear between (DNV-RP-C205, 3.5.5).
[[nodiscard]] double steepest_height_m(double peak_period_s) noexcept;

/// Where nobody says how far the wind blows over water: open shelf seas offer a few hundred
/// kilometres. An assumption to be stated with every wave that rests on it.
[[nodiscard]] inline Fetch assumed_fetch() { return Fetch(200.0e3); }

/// What surrounds a site, as far as waves need it.
struct WaveSetting {
  Fetch fetch = assumed_fetch();
  double water_depth_m = 0;  ///< > 0
  /// E-folding time of the energy of waves that the wind no longer feeds. 24 h is the median at
  /// alpha ventus, 2002-2014: 23, 24 and 25 h over the next 6, 12 and 24 h, where the wind stayed
  /// below 6 m/s.
  double swell_decay_h = 24.0;
};

/// The sea of the coming hours where no wave forecast is at hand.
///
/// The last sea is divided: waves that travel less than 60 degrees off the wind and slower than 1.2
/// U are its wind sea, as far as the growth law allows; the rest is swell. Each hour the wind sea
/// grows along its equivalent fetch; what the new wind cannot carry, or all of it where the wind
/// has turned by more than 60 degrees, joins the swell, which decays exponentially. Energies add:
/// Hs^2 = Hs_wind^2 + Hs_swell^2. Period and direction are those of the part with the higher
/// spectral peak (Hs^2 Tp). Hs stays below `steepest_height_m`. Calm water has the height 0 and the
/// period 0.
///
/// @param last    sea at the first stamp; a NaN height gives NaN throughout, a NaN period or
/// direction stays with
///                the swell
/// @param wind    at 10 m, m/s, towards; hourly, the first at the time of `last`
/// @return one sea per wind, the first is `last` itself; from a wind that is NaN onwards everything
/// is NaN Cost: microseconds an hour.  Thread-safe.
[[nodiscard]] std::vector<SeaState> propagate_sea_state(const SeaState& last,
                                                        std::span<const Horizontal> wind,
                                                        const WaveSetting& setting);

}  // namespace slackwater

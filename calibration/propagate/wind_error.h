#pragma once
#include <span>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/numbers/random.h"
#include "fields/base/time.h"

namespace slackwater::calibration {

/// How far the wind of an hour after D may be from the wind that is assumed: the standard deviation
/// of each component, growing with lead, and how long a departure lasts.
///
///   sigma^2(lead) = s_0^2 + (s_1^2 - s_0^2) [1 - exp(-((lead + age)/T)^p)]
///
/// Isotropic: the components are alike and independent. Lead in hours from the end of D.
struct WindErrorGrowth {
  double initial_m_s = 0.0;     ///< s_0, of a wind of lead and age 0
  double saturation_m_s = 0.0;  ///< s_1 >= s_0: when nothing is known any more
  double growth_time_h = 24.0;  ///< T
  double growth_power = 1.0;    ///< p
  /// E-folding time of the correlation of departures in time.
  double memory_h = 24.0;
  /// Age of the wind forecast at the end of D: the hours from its reference time to 24:00.
  double age_h = 0.0;

  /// Beside the law, per time: of a wind that stands in a gap, or was brought from another height.
  /// Empty: nowhere. Linear in between, 0 outside.
  std::vector<UtcTime> extra_at;
  std::vector<double> extra_sigma_m_s;

  /// Of a component, without the extra; 0 before the end of D (lead < 0): what the calibration was
  /// fitted to.
  [[nodiscard]] double sigma_m_s(double lead_h) const;
};

/// Standard deviation of a component of 10 m wind over the sea about its mean, without a record:
/// 5.4 m/s in three autumn months of NORA3 in the North Sea (53.3 N 1.3 E), 4.0 m/s in November at
/// buoy 61198 (Cabo de Gata); the root mean square of the two.
inline constexpr double wind_climate_sigma_m_s = 4.8;
/// E-folding time of the same wind, by which a persisted wind also relaxes to its mean
/// (calibration/day/given/horizon.h): in NORA3 the correlation is 0.79, 0.60, 0.46, 0.36 after 6,
/// 12, 18, 24 h, as of an exponential of 26, 24, 23, 24 h; 16 to 18 h at buoy 61198; of wind speed
/// at alpha ventus, thirteen years, 26 to 31 h.
inline constexpr double wind_memory_h = 24.0;

/// Of a wind that is an analysis (or reanalysis) of the time itself: 1 m/s per component, lasting 6
/// h. The error of ERA5's wind speed in the Atlantic is below 1.5 m/s away from tropical cyclones
/// and the warm boundary currents, that of the observations included (Campos et al. 2022, Remote
/// Sens. 14, 4918); successive analyses correct each other every 6 to 12 h.
[[nodiscard]] WindErrorGrowth analysed_wind_error() noexcept;

/// Of a numerical weather forecast: 1.0 m/s at its reference time, 1.3 after a day, 2.5 after
/// three, 3.8 after five, and sqrt(2) times the climatological standard deviation in the end, of
/// which ten days have used nine tenths, lasting 12 h.
///
/// The form is that of error growth towards the distance of two unrelated states (Dalcher & Kalnay
/// 1987, Tellus 39A, 474). The figures are a prior, not a fit: no record of forecasts with their
/// winds was at hand. They lie between the error of an analysis and the 2.8 m/s per component
/// (vector 4 m/s) of regional models of short lead against lidar at hub height off New England
/// (Banta et al. 2018, Bull. Amer. Meteor. Soc. 99, 1155); what is wrong with them the spread has
/// to earn back (earned_spread.h).
///
/// @param age_h  hours from the forecast's reference time to the end of D, >= 0
[[nodiscard]] WindErrorGrowth forecast_wind_error(
    double age_h = 0.0, double climate_sigma_m_s = wind_climate_sigma_m_s);

/// Of a persisted wind that decays to its climatological mean with the memory of the wind:
/// sigma_c^2 (1 - exp(-2 lead/tau)), 0 at the end of D, exact for a first-order Gauss-Markov wind.
/// The error of such a forecast in NORA3 is 2.4, 3.3, 4.3, 5.1, 5.2, 5.4 m/s per component after 3,
/// 6, 12, 24, 48, 72 h; this gives, with the record's own 5.4 m/s, 2.6, 3.4, 4.3, 5.1, 5.4, 5.4.
[[nodiscard]] WindErrorGrowth persisted_wind_error(
    double climate_sigma_m_s = wind_climate_sigma_m_s, double memory_h = wind_memory_h);

/// The climatological standard deviation of a component, from a record as far as it is long enough.
///
///   sigma^2 = [n s^2 + n_0 4.8^2] / (n - 1 + n_0),   n = 1 + length/(2 memory),   n_0 = 10
///
/// s^2: mean square of the departures from the record's mean, per component; n: independent samples
/// in the record (Leith 1973, J. Appl. Meteor. 12, 1066). Three days change little, three months
/// nearly decide.
/// @param times  ascending, as many as winds; winds that are not finite are left out
[[nodiscard]] double climate_sigma_m_s(std::span<const UtcTime> times,
                                       std::span<const Horizontal> wind_m_s);

/// Standard deviation of a component at each time, the extra included, 0 before the end of D.
[[nodiscard]] std::vector<double> departure_sigma_m_s(std::span<const UtcTime> times,
                                                      UtcTime end_of_day,
                                                      const WindErrorGrowth& growth);

/// One series of departures of the wind, m/s, to be added to it: Gauss-Markov in time,
///
///   d_k = a d_{k-1} + sqrt(sigma_k^2 - a^2 sigma_{k-1}^2) xi_k,
///   a = exp(-(t_k - t_{k-1})/memory) min(1, sigma_k/sigma_{k-1})
///
/// with independent standard normals in both components: the variance is sigma_k^2 at every time,
/// however the times are spaced. Where sigma does not fall the distribution does not depend on
/// stamps in between, and for `persisted_wind_error` it is exactly the wind's departure given the
/// wind of the end of D. Sigma may mix sources (analysed hours, then forecast ones).
///
/// @param times      ascending, strictly
/// @param sigma_m_s  of a component, per time, >= 0
/// Throws ContractViolation. Two normals per time, whatever sigma: a seed means the same member.
[[nodiscard]] std::vector<Horizontal> draw_wind_departures(std::span<const UtcTime> times,
                                                           std::span<const double> sigma_m_s,
                                                           double memory_h, Rng& random);
/// The same for one source of wind.
[[nodiscard]] std::vector<Horizontal> draw_wind_departures(std::span<const UtcTime> times,
                                                           UtcTime end_of_day,
                                                           const WindErrorGrowth& growth,
                                                           Rng& random);

}  // namespace slackwater::calibration

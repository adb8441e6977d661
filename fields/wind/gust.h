#pragma once
#include <cmath>

#include "fields/base/frame.h"

namespace slackwater {

/// A gust at one point: what stands on top of the mean wind, m/s.
struct Gust {
  double along_m_s = 0;   ///< with the mean wind
  double across_m_s = 0;  ///< to the left of it, seen from above
  double up_m_s = 0;
  bool operator==(const Gust&) const = default;
};

/// The axes of a gust: along the mean wind, across it to its left, up.
enum class GustAxis { along, across, up };

/// The gust as a vector, m/s, towards. In a calm, which has no direction, along is east.
[[nodiscard]] inline Vector3<Enu> gust_in_enu(const Gust& gust, Horizontal mean_wind_m_s) {
  const double speed_m_s = std::abs(mean_wind_m_s);
  const Horizontal along = speed_m_s > 0 ? mean_wind_m_s / speed_m_s : Horizontal(1, 0);
  const Horizontal level = along * Horizontal(gust.along_m_s, gust.across_m_s);
  return {level.real(), level.imag(), gust.up_m_s};
}

/// Gust factor G = 1 + g I: the largest gust of a stretch of time over its mean wind.
/// @param peak_factor  g, 2.5 to 3 for the 3 s gust in ten minutes
[[nodiscard]] inline double gust_factor(double turbulence_intensity,
                                        double peak_factor = 3.0) noexcept {
  return 1 + peak_factor * turbulence_intensity;
}

}  // namespace slackwater

#pragma once
#include <cmath>

namespace slackwater {

/// Standard deviation of the error of a forecast significant wave height, where the forecast itself
/// has no spread: a published record of forecasts against observations, bilinear in height and
/// lead,
///
///   Hs   12 h  24 h  36 h  48 h  72 h     (m)
///   1 m  0.34  0.36  0.37  0.39  0.43
///   2 m  0.42  0.45  0.50  0.54  0.66
///   4 m  0.66  0.76  0.85  0.94  1.08
///   6 m  0.83  0.94  1.05  1.16  1.37
///
/// below 1 m in proportion to the height, above 6 m as at 6 m, before 12 h as at 12 h, after 72 h
/// as at 72 h. It was collected for the North Sea and the Norwegian Sea; its bias (0.2 m too high
/// for low seas) is left out.
///
/// @param height_m  Hs >= 0
/// @param lead_h    hours since the forecast was made
/// Source: Wilcken (2012), table 10: the record behind the alpha factors of DNV-OS-H101, table 4-1.
[[nodiscard]] double wave_height_sigma_m(double height_m, double lead_h) noexcept;

/// Errors of heights are told as the standard deviation s of ln(Hs + 0.3 m): a height is then never
/// below 0, a storm that comes is worse than one that does not is calm, and a calm sea can rise.
namespace height_error {

inline constexpr double shift_m = 0.3;

/// The height whose error is z standard deviations; 0 at least, NaN of NaN.
[[nodiscard]] inline double height_at(double height_m, double spread, double z) noexcept {
  const double at_m = (height_m + shift_m) * std::exp(spread * z) - shift_m;
  return at_m < 0 ? 0 : at_m;
}
/// s of an error in metres: ln(Hs + 0.3 m) with the same coefficient of variation.
[[nodiscard]] double of_sigma(double height_m, double sigma_m) noexcept;

/// Of a provider's forecast: the published record above; of less than 0.3 m as of that.
[[nodiscard]] double of_product(double height_m, double lead_h) noexcept;

/// Of a sea that is kept as it was last known:
///
///   s = 0.48 sqrt(1 - exp(-lead / 26 h))
///
/// Eight of ten heights are within 1.28 s at alpha ventus, 2002 to 2014, at leads of 6 to 72 h
/// (82 to 84 %; low seas rise and high seas fall more often than this says) and in NORA3 off the
/// Wash, October to December 2022 (84, 79, 81, 79 % at 6, 12, 24, 48 h).
/// @param lead_h  hours since it was known
[[nodiscard]] double of_kept(double lead_h) noexcept;

/// How ln(Hs + 0.3 m) follows a wind that is 1 m/s stronger, averaged over the last hours with an
/// e-folding time of `wind_memory_h`: 0.10 in NORA3 (as above), the same over 12, 24 and 48 h. Of
/// the changes of the height over a day two thirds go with that of such a wind (correlation 0.82);
/// with the wind of the hour half (0.74).
inline constexpr double per_wind = 0.10;  ///< 1/(m/s)
inline constexpr double wind_memory_h = 4;

/// Of waves that are computed from the wind: what the error of the wind makes of them, and what the
/// growth law leaves out even where the wind is known.
/// @param wind_sigma_m_s  of the wind's speed
/// @param without_swell   nothing was known of the sea that they were grown from
[[nodiscard]] double of_computed(double wind_sigma_m_s, bool without_swell) noexcept;

}  // namespace height_error
}  // namespace slackwater

#pragma once

namespace slackwater {

/// The three turbulent components of IEC 61400-1: along the mean wind, across it to its left, up.
enum class GustAxis { along = 0, across = 1, up = 2 };

/// Turbulence class of the site: Iref 0.16, 0.14, 0.12 (IEC 61400-1 ed. 3, table 1).
enum class TurbulenceClass { a, b, c };
[[nodiscard]] double reference_intensity(TurbulenceClass turbulence) noexcept;

/// Standard deviation along the wind of the normal turbulence model, sigma1 = Iref (0.75 U + 5.6),
/// m/s (IEC 61400-1 ed. 3, eq. 11). U is the mean speed at hub height.
[[nodiscard]] double normal_turbulence_m_s(double hub_speed_m_s,
                                           double reference_intensity) noexcept;

/// Kaimal spectrum of IEC 61400-1 (annex B.14), one-sided, per axis k:
///
///   S_k(n) = 4 sigma_k^2 (L_k/U) / (1 + 6 n L_k/U)^(5/3)
///
/// with Lambda = 0.7 z below 60 m, else 42 m; L = 8.1, 2.7, 0.66 Lambda and sigma = 1, 0.8, 0.5
/// sigma1 along, across and up. The integral over n in (0, inf) is sigma_k^2, and that up to n is
///   sigma_k^2 [1 - (1 + 6 n L_k/U)^(-2/3)],
/// which is why bands of the spectrum can carry their exact variance.
class KaimalSpectrum {
 public:
  /// @param mean_speed_m_s  U > 0 at this height
  /// @param height_m        z > 0 above the sea surface
  /// @param sigma_along_m_s sigma1 >= 0
  KaimalSpectrum(double mean_speed_m_s, double height_m, double sigma_along_m_s);

  [[nodiscard]] double sigma_m_s(GustAxis axis) const noexcept;
  [[nodiscard]] double length_m(GustAxis axis) const noexcept;
  [[nodiscard]] double mean_speed_m_s() const noexcept { return mean_speed_m_s_; }
  /// S_k(n), m2/s2 per Hz, n >= 0 in Hz.
  [[nodiscard]] double density(GustAxis axis, double frequency_hz) const noexcept;
  /// Variance of the frequencies from 0 to n, m2/s2.
  [[nodiscard]] double variance_below(GustAxis axis, double frequency_hz) const noexcept;
  [[nodiscard]] bool operator==(const KaimalSpectrum&) const = default;

 private:
  double mean_speed_m_s_;
  double scale_m_;  ///< Lambda
  double sigma_m_s_;
};

}  // namespace slackwater

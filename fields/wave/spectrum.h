#pragma once

namespace slackwater {

/// Variance density of the sea surface over angular frequency, JONSWAP family; gamma = 1 is the
/// Pierson-Moskowitz spectrum:
///
///   S(omega) = A (5/16) Hs^2 omega_p^4 omega^-5 exp[-1.25 (omega/omega_p)^-4] gamma^e,
///   e = exp[-0.5 ((omega - omega_p)/(sigma omega_p))^2],  sigma = 0.07 below omega_p, 0.09 above
///
/// Source: Hasselmann et al. (1973); DNV-RP-C205, 3.5.5.
struct JonswapSpectrum {
  double significant_height_m = 0;  ///< Hs = 4 sqrt(m0)
  double peak_period_s = 1;         ///< Tp = 2 pi/omega_p
  double gamma = 1;                 ///< peak enhancement, 1 to 10
  double normalisation = 1;         ///< A, such that m0 = Hs^2/16

  [[nodiscard]] double peak_rad_s() const noexcept;
  /// S at omega, m2 s/rad; 0 at omega <= 0.
  [[nodiscard]] double density(double frequency_rad_s) const noexcept;
};

/// The spectrum of this height and period, A found by integration. Hs >= 0, Tp > 0, 1 <= gamma <=
/// 10, else a contract violation. Cost: some 4 000 exponentials.
[[nodiscard]] JonswapSpectrum jonswap_spectrum(double significant_height_m, double peak_period_s,
                                               double gamma);
/// gamma where only Hs and Tp are known: 5 up to Tp/sqrt(Hs) = 3.6, 1 from 5 on, between them
/// exp(5.75 - 1.15 Tp/sqrt(Hs)).  Hs > 0, Tp > 0.  Source: DNV-RP-C205, 3.5.5.5.
[[nodiscard]] double dnv_gamma(double significant_height_m, double peak_period_s);

/// Moments m_n = integral of omega^n S, m2 (rad/s)^n, over 0.2 to 60 omega_p. Beyond lie 1e-7 of
/// m0 and 3e-4 of m2; m4 has no limit, which is why none is given.
struct SpectralMoments {
  double m_1 = 0;  ///< n = -1
  double m0 = 0;
  double m1 = 0;
  double m2 = 0;

  [[nodiscard]] double significant_height_m() const noexcept;  ///< 4 sqrt(m0)
  [[nodiscard]] double tm02_s() const noexcept;           ///< 2 pi sqrt(m0/m2), zero upcrossing
  [[nodiscard]] double energy_period_s() const noexcept;  ///< Tm-10 = 2 pi m-1/m0
};
[[nodiscard]] SpectralMoments moments_of(const JonswapSpectrum& spectrum);

}  // namespace slackwater

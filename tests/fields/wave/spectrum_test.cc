#include "fields/wave/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::spectrum_test {
namespace {

using constants::pi;

/// A = 1 - 0.287 ln gamma, the published fit. Source: DNV-RP-C205, 3.5.5.5.
double fitted_normalisation(double gamma) { return 1.0 - 0.287 * std::log(gamma); }

TEST(JonswapSpectrum, HasThePublishedDensities) {
  // fields/docs/physics.md section 8: Hs 2.5, Tp 9, gamma 3.3, with the fitted A.
  JonswapSpectrum s = jonswap_spectrum(2.5, 9, 3.3);
  s.normalisation = fitted_normalisation(3.3);
  EXPECT_NEAR(s.density(s.peak_rad_s()), 1.7387269553191875, 1e-8);
  EXPECT_NEAR(s.density(0.5), 0.0843831245940463, 1e-8);
  EXPECT_NEAR(s.density(1.0), 0.2266317385014987, 1e-8);
  EXPECT_EQ(s.density(0), 0);
  EXPECT_EQ(s.density(-1), 0);
}

TEST(JonswapSpectrum, HasTheHeightThatIsAsked) {
  for (const double gamma : {1.0, 2.0, 3.3, 5.0, 7.0, 10.0}) {
    for (const double height : {0.1, 2.5, 14.0}) {
      EXPECT_NEAR(moments_of(jonswap_spectrum(height, 8, gamma)).significant_height_m() / height, 1,
                  1e-12);
    }
  }
}

TEST(JonswapSpectrum, TheNormalisationOfDnvMissesTheHeightByWhatIsPublished) {
  // fields/docs/physics.md section 8: below 0.12 % for gamma 1 to 5, -0.9 % at 7; of Hs, the root.
  const auto height_with_fit = [](double gamma) {
    JonswapSpectrum s = jonswap_spectrum(1, 8, gamma);
    s.normalisation = fitted_normalisation(gamma);
    return moments_of(s).significant_height_m();
  };
  for (const double gamma : {1.0, 2.0, 3.3, 5.0}) EXPECT_NEAR(height_with_fit(gamma), 1, 0.00125);
  EXPECT_NEAR(height_with_fit(7), 1 - 0.009, 0.0005);
}

TEST(JonswapSpectrum, HasThePublishedPeriodRatios) {
  struct Row {
    double gamma, tm02, energy;
  };
  for (const Row& row :
       {Row{1, 0.71050, 0.85722}, Row{2, 0.74655, 0.88354}, Row{3.3, 0.77751, 0.90330},
        Row{5, 0.80538, 0.91919}, Row{7, 0.82859, 0.93123}}) {
    const SpectralMoments m = moments_of(jonswap_spectrum(3, 10, row.gamma));
    EXPECT_NEAR(m.tm02_s() / 10, row.tm02, 1e-5);
    EXPECT_NEAR(m.energy_period_s() / 10, row.energy, 1e-5);
  }
}

TEST(PiersonMoskowitz, HasItsExactMoments) {
  // With x = omega/omega_p, integral of x^n 5 x^-5 exp(-1.25 x^-4) = 1.25^(n/4) Gamma(1 - n/4).
  const double hs = 2.0;
  const double peak = 2 * pi / 8.0;
  const SpectralMoments m = moments_of(jonswap_spectrum(hs, 8, 1));
  const auto exact = [&](double n) {
    return hs * hs / 16 * std::pow(peak, n) * std::pow(1.25, n / 4) * std::tgamma(1 - n / 4);
  };
  EXPECT_NEAR(m.m0 / exact(0), 1, 1e-12);
  EXPECT_NEAR(m.m_1 / exact(-1), 1, 1e-6);
  // What lies above 60 omega_p is missing: 5/((4 - n) 60^(4-n)) of m0 omega_p^n.
  EXPECT_NEAR(m.m1 / exact(1), 1 - 5.0 / (3 * 60 * 60 * 60) / (exact(1) / exact(0) / peak), 1e-6);
  EXPECT_NEAR(m.m2 / exact(2), 1 - 5.0 / (2 * 60 * 60) / (exact(2) / exact(0) / peak / peak), 1e-6);
}

TEST(JonswapSpectrum, PeaksAtItsPeriodGammaTimesAsHigh) {
  for (const double gamma : {1.0, 3.3, 7.0}) {
    const JonswapSpectrum s = jonswap_spectrum(3, 11, gamma);
    const double peak = s.peak_rad_s();
    EXPECT_GT(s.density(peak), s.density(0.999 * peak));
    EXPECT_GT(s.density(peak), s.density(1.001 * peak));
    const JonswapSpectrum plain{3, 11, 1, s.normalisation};
    EXPECT_NEAR(s.density(peak) / plain.density(peak), gamma, 1e-12);
  }
}

TEST(DnvGamma, FollowsTheRule) {
  EXPECT_EQ(dnv_gamma(4, 7.2), 5);
  EXPECT_EQ(dnv_gamma(4, 3), 5);
  EXPECT_EQ(dnv_gamma(4, 10), 1);
  EXPECT_EQ(dnv_gamma(1, 14), 1);
  EXPECT_NEAR(dnv_gamma(4, 8.6), std::exp(5.75 - 1.15 * 4.3), 1e-12);
  // Its branches join: 0.5 % at the steep end, exactly at the other.
  EXPECT_NEAR(dnv_gamma(1, 3.6 + 1e-9), 5, 0.03);
  EXPECT_NEAR(dnv_gamma(1, 5 - 1e-9), 1, 1e-8);
}

TEST(JonswapSpectrum, RefusesWhatIsNoSea) {
  EXPECT_THROW((void)jonswap_spectrum(-1, 8, 1), ContractViolation);
  EXPECT_THROW((void)jonswap_spectrum(1, 0, 1), ContractViolation);
  EXPECT_THROW((void)jonswap_spectrum(1, std::nan(""), 1), ContractViolation);
  EXPECT_THROW((void)jonswap_spectrum(1, 8, 0.5), ContractViolation);
  EXPECT_THROW((void)dnv_gamma(0, 8), ContractViolation);
  EXPECT_EQ(moments_of(jonswap_spectrum(0, 8, 1)).m0, 0);  // calm is a sea
}

}  // namespace
}  // namespace slackwater::spectrum_test

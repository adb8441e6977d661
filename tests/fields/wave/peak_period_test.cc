// Peak periods from mean periods.
#include "fields/wave/peak_period.h"

#include <gtest/gtest.h>

#include "fields/wave/spectrum.h"

namespace slackwater::peak_period_test {
namespace {

TEST(PeakPeriod, IsRecoveredFromTheMeanPeriodsOfASea) {
  for (const double peak_s : {4.0, 8.0, 14.0}) {
    const SpectralMoments sea = moments_of(jonswap_spectrum(2, peak_s, 3.3));
    EXPECT_NEAR(peak_period_of_energy_period_s(sea.energy_period_s()), peak_s, 1e-9 * peak_s);
    EXPECT_NEAR(peak_period_of_zero_crossing_period_s(sea.tm02_s()), peak_s, 1e-9 * peak_s);
  }
}

/// Tz/Tp = 0.6673 + 0.05037 gamma - 0.006230 gamma^2 + 0.0003341 gamma^3: DNV-RP-C205, 3.5.5.
TEST(PeakPeriod, OfTheZeroCrossingPeriodIsThePublishedOne) {
  const double gamma = 3.3;
  const double ratio = 0.6673 + gamma * (0.05037 + gamma * (-0.006230 + gamma * 0.0003341));
  EXPECT_NEAR(peak_period_of_zero_crossing_period_s(1) * ratio, 1, 5e-3);
}

TEST(PeakPeriod, HasTheRatiosOfThePage) {
  EXPECT_NEAR(peak_period_of_energy_period_s(1), 1.11, 5e-3);
  EXPECT_NEAR(peak_period_of_zero_crossing_period_s(1), 1.29, 5e-3);
  // How far they reach: seas without an enhanced peak, and very peaked ones.
  const SpectralMoments flat = moments_of(jonswap_spectrum(1, 1, 1));
  const SpectralMoments peaked = moments_of(jonswap_spectrum(1, 1, 7));
  EXPECT_NEAR(1 / flat.energy_period_s(), 1.17, 1e-2);
  EXPECT_NEAR(1 / peaked.energy_period_s(), 1.07, 1e-2);
  EXPECT_NEAR(1 / flat.tm02_s(), 1.41, 1e-2);
  EXPECT_NEAR(1 / peaked.tm02_s(), 1.21, 1e-2);
}

}  // namespace
}  // namespace slackwater::peak_period_test

#include "fields/wave/regular_wave.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/service/snapshot.h"
#include "fields/wave/sea_sampling.h"
#include "tests/fields/wave/textbook_sea.h"

namespace slackwater::tests::regular_wave_test {
namespace {

using constants::gravity_m_s2;
using constants::pi;

const UtcTime epoch = parse_utc("2025-03-10T06:00:00Z");

double deep_length_m(double period_s) { return gravity_m_s2 * period_s * period_s / (2 * pi); }

TEST(RegularWave, IsOneComponentOfAiryWithItsCrestAtTheOrigin) {
  const WaveWater water{30, {0.3, -0.2}};
  const RegularWave wave{1.2, 6, 250};
  const SeaRealisation sea = realise(wave, water, epoch);
  ASSERT_EQ(sea.waves().size(), 1U);
  const WaveComponent expected =
      one_wave(0.6, 6, water, vector_from_direction(1.0, wave.from_direction_deg));
  EXPECT_NEAR(std::abs(sea.waves()[0].wavenumber_rad_m - expected.wavenumber_rad_m), 0, 1e-15);
  EXPECT_NEAR(sea.waves()[0].absolute_rad_s, expected.absolute_rad_s, 1e-15);
  EXPECT_NEAR(sample_waves(sea, {0, 0, 0, 0}).motion.elevation_m, 0.6, 1e-9);
  for (const WavePlace& at : {WavePlace{0, 0, -5, 2.5}, {40, -12, -2, 7}, {-300, 90, -20, 31}}) {
    const double eta = textbook_sea(sea, at, 0).motion.elevation_m;
    const double z = 30 * (at.up_m - eta) / (30 + eta);  // Wheeler's
    const WaveSample expected_at = textbook_sea(sea, at, z), found = sample_waves(sea, at);
    EXPECT_NEAR(found.motion.elevation_m, eta, 1e-9);
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(found.motion.velocity_m_s[i], expected_at.motion.velocity_m_s[i], 1e-8);
  }
}

TEST(RegularWave, HasTheStateOfTheSeaOfItsEnergy) {
  const RegularWave wave{0.4, 5, 270};
  const SeaState state = state_of(wave);
  // m0 = H^2/8, Hs = 4 sqrt(m0).
  EXPECT_NEAR(state.significant_height_m, 4 * std::sqrt(0.4 * 0.4 / 8), 1e-15);
  EXPECT_NEAR(state.significant_height_m, realise(wave, {40, {}}, epoch).significant_height_m(),
              1e-15);
  EXPECT_EQ(state.peak_period_s, 5);
  EXPECT_EQ(state.from_direction_deg, 270);
}

TEST(RegularWave, BreaksInDeepWaterAtASeventhOfItsLength) {
  for (const double period_s : {3.0, 6.0, 9.0})
    EXPECT_NEAR(breaking_height_m(period_s, 500), 0.142 * deep_length_m(period_s),
                1e-4 * deep_length_m(period_s));
}

TEST(RegularWave, BreaksInShallowWaterAtEightNinthsOfTheDepth) {
  // tanh(kh) L goes to 2 pi h.
  EXPECT_NEAR(breaking_height_m(30, 1), 0.142 * 2 * pi, 0.005);
  EXPECT_LT(breaking_height_m(8, 5), breaking_height_m(8, 10));
}

TEST(RegularWave, ThatBreaksIsRefusedWithTheHighestAndTheShortestThatDoNot) {
  const double most_m = breaking_height_m(4, 40);
  EXPECT_EQ(why_it_breaks({most_m, 4, 0}, 40), "");
  const RegularWave steep{most_m * 1.01, 4, 0};
  const std::string why = why_it_breaks(steep, 40);
  EXPECT_NE(why.find("T 4 s"), std::string::npos) << why;
  EXPECT_NE(why.find("lower H to 3.546 m or less, or lengthen T to 4.02 s or more"),
            std::string::npos)
      << why;
  EXPECT_EQ(why_it_breaks({3.546, 4, 0}, 40), "");
  EXPECT_EQ(why_it_breaks({steep.height_m, 4.02, 0}, 40), "");
  EXPECT_THROW((void)realise(steep, {40, {}}, epoch), Error);
  EXPECT_NE(why_it_breaks({3, 8, 0}, 2).find("no longer one of that height stands there"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::regular_wave_test

#include "calibration/fuse/instrument_noise.h"

#include <gtest/gtest.h>

#include "tests/calibration/fuse/made_up_sea.h"

namespace slackwater::calibration::tests::instrument_noise_test {
namespace {

const RotaryTide m2{{1.0, 0}, {0, 0}};

TEST(InstrumentNoise, IsThatOfEachLevelWhateverTheTide) {
  Rng random(1, "instrument noise");
  for (const double step_h : {1.0 / 6, 1.0}) {
    const VectorColumn series = made_up_column({5, 10, 15}, 720, step_h, [&](double h, double z) {
      return m2.at(h) + 0.02 * z * Horizontal{random.normal(), random.normal()};
    });
    const std::vector<double> noise = instrument_noise(series);
    ASSERT_EQ(noise.size(), 3U);
    // 700 values every five of which are independent: 1 / sqrt(140) and the median's 1.4.
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(noise[k], 0.02 * series.levels_m[k], 0.12 * 0.02 * series.levels_m[k]) << step_h;
  }
}

TEST(InstrumentNoise, TideAloneIsHardlyTakenForNoise) {
  const auto tide = [](double h, double) { return m2.at(h); };
  // (2 sin(w / 2))^4 / sqrt(70) of a circle of 1 m/s: |d|^2 is constant, its root over sqrt(2 ln
  // 2).
  EXPECT_LT(instrument_noise(made_up_column({5}, 720, 1, tide))[0], 0.0066);
  EXPECT_LT(instrument_noise(made_up_column({5}, 720, 1.0 / 6, tide))[0], 1e-5);
}

TEST(InstrumentNoise, SpikesAreNotNoise) {
  Rng random(2, "instrument noise");
  VectorColumn series = made_up_column({5}, 720, 1.0 / 6, [&](double h, double) {
    return m2.at(h) + 0.03 * Horizontal{random.normal(), random.normal()};
  });
  for (std::size_t t = 0; t < series.times(); t += 50) series.value[t] += 5;
  EXPECT_NEAR(instrument_noise(series)[0], 0.03, 0.004);
}

TEST(InstrumentNoise, CannotBeToldOfRareOrFewSamples) {
  Rng random(3, "instrument noise");
  const auto noisy = [&](double, double) {
    return 0.3 * Horizontal{random.normal(), random.normal()};
  };
  EXPECT_EQ(instrument_noise(made_up_column({5}, 720, 3, noisy))[0], 0);
  EXPECT_EQ(instrument_noise(made_up_column({5}, 20, 1, noisy))[0], 0);
}

}  // namespace
}  // namespace slackwater::calibration::tests::instrument_noise_test

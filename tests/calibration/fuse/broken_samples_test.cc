#include "calibration/fuse/broken_samples.h"

#include <gtest/gtest.h>

#include "tests/calibration/fuse/made_up_sea.h"

namespace slackwater::calibration::tests::broken_samples_test {
namespace {

const RotaryTide m2{{0.6, 0}, {0.3, 0}};

VectorColumn product() {
  return made_up_column({10}, 240, 1, [](double h, double) { return m2.at(h); });
}

VectorColumn live(double step_h, double noise_m_s = 0.02) {
  Rng random(1, "broken samples");
  return made_up_column({8, 12}, 240, step_h, [&](double h, double) {
    return m2.at(h) + noise_m_s * Horizontal{random.normal(), random.normal()};
  });
}

TEST(BrokenSamples, LiveWaterHasNone) {
  for (const double step_h : {1.0, 1.0 / 6}) {
    const VectorColumn series = live(step_h);
    const UnbrokenSeries found = without_broken_samples(series, product());
    EXPECT_EQ(found.spikes, 0U);
    EXPECT_EQ(found.stuck_h, 0);
    EXPECT_EQ(found.column.status, series.status);
  }
}

TEST(BrokenSamples, SpikesOfOneAndTwoSamplesAreLeftOutAndNothingElse) {
  VectorColumn series = live(1.0 / 6);
  const std::vector<std::size_t> where{100, 333, 700, 701, series.times() - 1};
  for (const std::size_t t : where) series.value[series.offset(t, 0)] += Horizontal{0.8, -1.1};
  const UnbrokenSeries found = without_broken_samples(series, product());
  EXPECT_EQ(found.spikes, where.size());
  for (std::size_t t = 0; t < series.times(); ++t) {
    const bool is_spike = std::find(where.begin(), where.end(), t) != where.end();
    EXPECT_EQ(found.column.has(t, 0), !is_spike) << t;
    EXPECT_TRUE(found.column.has(t, 1)) << "the other bin";
  }
}

TEST(BrokenSamples, AStormThatComesWithinAnHourIsWater) {
  VectorColumn series = live(1.0 / 6);
  for (std::size_t t = 600; t < 700; ++t)
    for (std::size_t k = 0; k < 2; ++k)
      series.value[series.offset(t, k)] += 0.9 * std::min({1.0, (static_cast<double>(t) - 599) / 6,
                                                           (700 - static_cast<double>(t)) / 6});
  EXPECT_EQ(without_broken_samples(series, product()).spikes, 0U);
}

TEST(BrokenSamples, AValueThatNeverChangesForTwoDaysIsLeftOut) {
  VectorColumn series = live(1.0 / 6);
  const std::size_t last = series.times() - 1;
  for (std::size_t t = last - 288; t <= last; ++t)
    series.value[series.offset(t, 1)] = {0.21, -0.05};
  const UnbrokenSeries found = without_broken_samples(series, product());
  EXPECT_NEAR(found.stuck_h, 48, 1e-9);
  EXPECT_EQ(found.stuck_until, series.time.back().centre());
  EXPECT_TRUE(found.column.has(last - 289, 1));
  EXPECT_FALSE(found.column.has(last - 288, 1));
  EXPECT_FALSE(found.column.has(last, 1));
  EXPECT_TRUE(found.column.has(last, 0));
}

TEST(BrokenSamples, OneComponentThatStaysIsEnough) {
  VectorColumn series = live(1.0);
  for (std::size_t t = 50; t < 90; ++t) {
    Horizontal& value = series.value[series.offset(t, 0)];
    value = {value.real(), 0.125};
  }
  EXPECT_NEAR(without_broken_samples(series, product()).stuck_h, 39, 1e-9);
}

TEST(BrokenSamples, SlackWaterWithinTheResolutionIsNotStuck) {
  // A basin with hardly any current and an instrument that resolves 1 cm/s.
  Rng random(2, "slack water");
  const VectorColumn calm = made_up_column({8}, 240, 1.0 / 6, [&](double h, double) {
    const Horizontal flow = 0.01 * m2.at(h);
    return Horizontal{0.01 * std::round(flow.real() / 0.01), 0.01 * std::round(flow.imag() / 0.01)};
  });
  const VectorColumn still =
      made_up_column({10}, 240, 1, [](double h, double) { return 0.01 * m2.at(h); });
  const UnbrokenSeries found = without_broken_samples(calm, still);
  EXPECT_EQ(found.stuck_h, 0);
}

TEST(BrokenSamples, ASeriesThatNeverChangesIsStuckIfTheProductMoves) {
  const VectorColumn dead = made_up_column({8}, 240, 1, [](double, double) {
    return Horizontal{0.1, 0.1};
  });
  EXPECT_NEAR(without_broken_samples(dead, product()).stuck_h, 240, 1e-9);
  const VectorColumn still = made_up_column({10}, 240, 1, [](double, double) {
    return Horizontal{0.1, 0.1};
  });
  EXPECT_EQ(without_broken_samples(dead, still).stuck_h, 0);
}

}  // namespace
}  // namespace slackwater::calibration::tests::broken_samples_test

#include "twin/search/noisy_work.h"

#include <gtest/gtest.h>

namespace slackwater::tests::noisy_work_test {
namespace {

using twin::NoisyWorkState;
using twin::ZoneReport;
using twin::ZoneRule;

constexpr ZoneRule rule{1800, 1200};

TEST(NoisyWork, BeginsAfterAWatchWithoutASighting) {
  NoisyWorkState state;
  for (int t = 0; t <= 2000; ++t) {
    hear(rule, {t >= 100, -1e300}, t, state);
    // Nobody had watched until 99.
    EXPECT_EQ(state.is_clear, t >= 1899) << t;
    EXPECT_FALSE(state.is_seen);
    note_noise(state.is_clear, t, state);
  }
  EXPECT_EQ(state.noisy_s, std::vector<double>{1899});
  EXPECT_EQ(state.stops, 0);
}

TEST(NoisyWork, StopsForASightingAndGoesOnAfterAShorterWatch) {
  NoisyWorkState state;
  double seen_s = -1e300;
  for (int t = 0; t <= 6000; ++t) {
    // What was seen in the tick before.
    if (t == 501 || t == 2501 || t == 2601) seen_s = t - 1;
    hear(rule, {true, seen_s}, t, state);
    note_noise(state.is_clear, t, state);
  }
  // The watch before it begins is put off by the first; the others count as one stop.
  EXPECT_EQ(state.noisy_s, (std::vector<double>{2300, 2501, 3800}));
  EXPECT_EQ(state.stops, 1);
}

TEST(NoisyWork, StopsWhereNobodyWatchesAndSaysSo) {
  NoisyWorkState state;
  for (int t = 0; t <= 4000; ++t) {
    hear(rule, {t < 2000 || t >= 2010, -1e300}, t, state);
    if (t >= 2000 && t < 3209) {
      EXPECT_FALSE(state.is_clear) << t;
      EXPECT_FALSE(state.is_seen) << t;
    }
    note_noise(state.is_clear, t, state);
  }
  EXPECT_EQ(state.noisy_s, (std::vector<double>{1800, 2000, 3209}));
  EXPECT_EQ(state.stops, 0);
}

TEST(NoisyWork, IsHeldAgainstTheAnimalsOfItsWatches) {
  NoisyWorkState state;
  state.noisy_s = {100, 300, 500};
  state.stops = 1;
  twin::MammalDutyState one, other;
  one.inside_s = {250, 520};
  one.until_s = 1000;
  other.inside_s = {280, 540, 590};
  other.until_s = 595;
  const twin::MammalDutyState* const both[] = {&one, &other};
  const twin::NoiseRecord record = noise_made(state, both, 600, 1);
  EXPECT_EQ(record.noise_s, 200 + 100);
  EXPECT_EQ(record.stops, 1);
  EXPECT_EQ(record.exposed_s, 50 + 40 + 5);
}

TEST(NoisyWork, BelievesAWatchThatIsThere) {
  twin::MammalDutyState watch;
  watch.watched_s = {10};
  watch.sightings_s = {20, 30};
  ZoneReport report;
  add_to(report, watch, false);
  EXPECT_FALSE(report.is_watched);
  EXPECT_EQ(report.seen_s, 30);
  add_to(report, watch, true);
  EXPECT_TRUE(report.is_watched);
  watch.watched_s.push_back(40);
  ZoneReport later;
  add_to(later, watch, true);
  EXPECT_FALSE(later.is_watched);
}

}  // namespace
}  // namespace slackwater::tests::noisy_work_test

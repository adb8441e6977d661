#include "fields/service/wave_source.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::wave_source_test {
namespace {

using std::chrono::hours;

const UtcTime start = parse_utc("2025-03-10T00:00:00Z");

Snapshot snapshot_of(const std::vector<DataStatus>& source) {
  Snapshot snapshot;
  ForecastColumn column;
  for (std::size_t h = 0; h < source.size(); ++h) {
    snapshot.time.push_back(start + hours(h));
    column.sea.push_back({1.0, 5.0, 270.0});
  }
  column.sea_source = source;
  snapshot.columns = {ForecastColumn{}, column};  // the first column has no waves
  return snapshot;
}

TEST(WaveSourcesText, NamesEachSourceAndHowManyHoursAreOfIt) {
  using enum DataStatus;
  EXPECT_EQ(wave_sources_text(snapshot_of({forecast, forecast})), "wave product, forecast");
  EXPECT_EQ(wave_sources_text(snapshot_of({modelled, modelled})), "computed from the wind");
  EXPECT_EQ(wave_sources_text(snapshot_of({analysis, forecast, forecast, modelled})),
            "wave product, analysed (1 of 4 hours), wave product, forecast (2), computed from the "
            "wind (1)");
  EXPECT_EQ(wave_sources_text(Snapshot{}), "");
}

TEST(WaveSourcesText, HoursWithoutAWaveHaveNoSource) {
  Snapshot snapshot = snapshot_of({DataStatus::forecast, DataStatus::persisted});
  snapshot.columns[1].sea[1].significant_height_m = std::nan("");
  EXPECT_EQ(wave_sources_text(snapshot), "wave product, forecast");
  EXPECT_TRUE(has_given_waves_only(snapshot));
}

TEST(HasGivenWavesOnly, IsFalseFromTheFirstHourThatIsOurs) {
  using enum DataStatus;
  EXPECT_TRUE(has_given_waves_only(snapshot_of({analysis, forecast, observation})));
  EXPECT_FALSE(has_given_waves_only(snapshot_of({analysis, forecast, modelled})));
  EXPECT_FALSE(has_given_waves_only(snapshot_of({persisted})));
  EXPECT_TRUE(has_given_waves_only(Snapshot{})) << "no waves, none to doubt";
}

TEST(WaveSourceAt, BetweenTwoStampsIsTheOneFurtherFromAProduct) {
  using enum DataStatus;
  const Snapshot snapshot = snapshot_of({analysis, forecast, modelled});
  const auto at = [&](int minutes) {
    return wave_source_at(snapshot, start + std::chrono::minutes(minutes));
  };
  EXPECT_EQ(at(0), analysis);
  EXPECT_EQ(at(1), forecast);
  EXPECT_EQ(at(60), forecast);
  EXPECT_EQ(at(61), modelled);
  EXPECT_EQ(at(120), modelled);
  EXPECT_EQ(at(-1), std::nullopt);
  EXPECT_EQ(at(121), std::nullopt);
  EXPECT_EQ(wave_source_at(Snapshot{}, start), std::nullopt);
}

}  // namespace
}  // namespace slackwater::wave_source_test

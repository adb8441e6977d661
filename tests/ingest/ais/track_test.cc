#include "ingest/ais/track.h"

#include <gtest/gtest.h>

namespace slackwater::tests::track_test {
namespace {

using namespace ingest;
using namespace std::chrono_literals;

const UtcTime noon = parse_utc("2022-01-03T12:00:00Z");

AisReport report_at(UtcTime time, double latitude_deg, std::optional<int> second = {}) {
  AisReport report;
  report.mmsi = 338125067;
  report.type = 18;
  report.speaker = AisClass::b;
  report.time = time;
  report.position = GeoPoint::from_degrees(latitude_deg, -122.4);
  report.utc_second = second;
  return report;
}

TEST(AisTimeOfPosition, IsTheNewestInstantWithThatSecond) {
  EXPECT_EQ(time_of_position(noon + 12'555ms, 12), noon + 12s);
  EXPECT_EQ(time_of_position(noon + 12'555ms, 50), noon - 10s) << "of the minute before";
  EXPECT_EQ(time_of_position(noon + 12'555ms, 14), noon + 14s) << "clocks differ by 1.4 s";
  EXPECT_EQ(time_of_position(noon + 12'555ms, 15), noon - 45s) << "but not by 2.4 s";
  EXPECT_EQ(time_of_position(noon + 12'555ms, std::nullopt), noon + 12'555ms);
}

TEST(AisTimeOfPosition, ARelayedReportOfTheDanishLogNoLongerJumpsBack) {
  // 210248000 under way at 15 kn northwards, pyais 3.3.1: the third one was heard 22 s late.
  AisTrackCollector collector;
  collector.add(report_at(parse_utc("2010-06-11T11:46:13.224Z"), 55.125483, 12));
  collector.add(report_at(parse_utc("2010-06-11T11:46:19.875Z"), 55.125717, 18));
  collector.add(report_at(parse_utc("2010-06-11T11:46:22.866Z"), 55.123633, 0));
  collector.add(report_at(parse_utc("2010-06-11T11:46:24.936Z"), 55.1262, 24));
  const std::vector<AisTrack> tracks = std::move(collector).take();
  const auto& positions = tracks.at(0).positions;
  ASSERT_EQ(positions.size(), 4U);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_GT(positions[i].time, positions[i - 1].time);
    EXPECT_GT(positions[i].point.latitude_deg(), positions[i - 1].point.latitude_deg());
  }
}

TEST(AisTrackCollector, PositionsAscendInTimeAndTheFirstOfEqualTimesStays) {
  AisTrackCollector collector;
  for (const double minute : {3.0, 1.0, 2.0, 1.0}) {
    collector.add(
        report_at(noon + std::chrono::minutes(static_cast<int>(minute)), 47 + minute / 100));
  }
  collector.add(report_at(noon + 2min, 80));
  EXPECT_EQ(collector.positions(), 5U);
  const auto tracks = std::move(collector).take();
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_EQ(tracks[0].reports, 5U);
  ASSERT_EQ(tracks[0].positions.size(), 3U);
  EXPECT_DOUBLE_EQ(tracks[0].positions[1].point.latitude_deg(), 47.02);
}

TEST(AisTrackCollector, AMessageHeardByTwoStationsIsOnePosition) {
  AisTrackCollector collector;
  collector.add(report_at(noon + 12'100ms, 47, 11));
  collector.add(report_at(noon + 13'900ms, 47, 11));
  EXPECT_EQ(std::move(collector).take().at(0).positions.size(), 1U);
}

TEST(AisTrackCollector, ParticularsAreRenewedOneByOneAndPositionsSayTheClass) {
  AisTrackCollector collector;
  AisReport part_a = report_at(noon, 47);
  part_a.type = 24;
  part_a.position.reset();
  part_a.identity.name = "OLD NAME";
  AisReport part_b = part_a;
  part_b.identity = {};
  part_b.identity.length_m = 13;
  AisReport renamed = part_a;
  renamed.identity.name = "RUM LASS";
  for (const AisReport& report : {part_a, part_b, renamed}) collector.add(report);
  AisReport position = report_at(noon, 47);
  position.speaker = AisClass::a;
  collector.add(position);
  collector.add(part_b);  // speaks as class B, but without a position
  const auto track = std::move(collector).take().at(0);
  EXPECT_EQ(track.identity.name, "RUM LASS");
  EXPECT_EQ(track.identity.length_m, 13);
  EXPECT_EQ(track.speaker, AisClass::a);
  EXPECT_EQ(track.reports, 5U);
}

TEST(AisTrackCollector, WithoutATimeAReportTellsWhoButNotWhere) {
  AisTrackCollector collector;
  AisReport report = report_at(noon, 47);
  report.time.reset();
  report.identity.name = "RUM LASS";
  collector.add(report);
  const auto track = std::move(collector).take().at(0);
  EXPECT_TRUE(track.positions.empty());
  EXPECT_EQ(track.identity.name, "RUM LASS");
}

}  // namespace
}  // namespace slackwater::tests::track_test

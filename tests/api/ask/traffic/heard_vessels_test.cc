// What was known of vessels at a time: nothing that came later.
#include "api/ask/traffic/heard_vessels.h"

#include <gtest/gtest.h>

#include "fields/base/numbers/random.h"

namespace slackwater::tests::heard_vessels_test {
namespace {

using namespace api;

using ingest::AisReport;
using std::chrono::minutes;
using std::chrono::seconds;

const UtcTime start = parse_utc("2025-03-04T06:00:00Z");

AisReport position(std::uint32_t mmsi, Duration after, double latitude_deg) {
  AisReport report;
  report.mmsi = mmsi;
  report.type = 1;
  report.time = start + after;
  report.position = GeoPoint::from_degrees(latitude_deg, 6);
  report.speed_over_ground_m_s = 5;
  return report;
}
AisReport name(std::uint32_t mmsi, std::optional<Duration> after, const std::string& name) {
  AisReport report;
  report.mmsi = mmsi;
  report.type = 5;
  if (after) report.time = start + *after;
  report.identity.name = name;
  return report;
}
double latitude(const LastHeard& heard) { return heard.position.point.latitude_deg(); }

TEST(HeardVessels, OfWhatComesLaterNeitherPlaceNorNameIsKnown) {
  HeardVessels vessels;
  EXPECT_TRUE(vessels.known_at(start).empty());
  EXPECT_FALSE(vessels.last_received(start));
  for (int minute = 0; minute < 60; ++minute)
    vessels.add(position(1, minutes(minute), 50 + minute * 0.01));
  vessels.add(name(1, minutes(30), "LATE NAME"));
  EXPECT_TRUE(vessels.known_at(start - seconds(1)).empty());
  EXPECT_FALSE(vessels.last_received(start - seconds(1)));
  const auto early = vessels.known_at(start + minutes(29) + seconds(59));
  ASSERT_EQ(early.size(), 1U);
  EXPECT_NEAR(latitude(early[0]), 50.29, 1e-9);
  EXPECT_FALSE(early[0].identity.name);
  EXPECT_EQ(vessels.known_at(start + minutes(30))[0].identity.name, "LATE NAME");
  EXPECT_EQ(vessels.last_received(start + minutes(29) + seconds(59)), start + minutes(29));
}

TEST(HeardVessels, AReportThatWasPassedOnLateIsNotKnownBeforeItCame) {
  HeardVessels vessels;
  vessels.add(position(1, seconds(0), 50));
  AisReport late = position(1, seconds(50), 51);
  late.utc_second = 10;
  vessels.add(late);
  EXPECT_NEAR(latitude(vessels.known_at(start + seconds(40))[0]), 50, 1e-9);
  const LastHeard then = vessels.known_at(start + seconds(50))[0];
  EXPECT_NEAR(latitude(then), 51, 1e-9);
  EXPECT_EQ(then.position.time, start + seconds(10)) << "where it was forty seconds ago";
}

TEST(HeardVessels, ToBeToldAgainChangesNothing) {
  Rng rng(2, "tests/heard_vessels");
  std::vector<AisReport> reports;
  for (int i = 0; i < 300; ++i) {
    const auto mmsi = static_cast<std::uint32_t>(rng.uniform(1, 6));
    const Duration after = seconds(10 * i);
    reports.push_back(i % 7 == 0 ? name(mmsi, after, "N" + std::to_string(i % 21))
                                 : position(mmsi, after, rng.uniform(40, 60)));
  }
  HeardVessels once, again;
  for (const AisReport& report : reports) once.add(report);
  for (std::size_t end = 10; end <= reports.size(); end += 10)
    for (std::size_t i = end > 40 ? end - 40 : 0; i < end; ++i) again.add(reports[i]);
  for (int minute = -1; minute < 60; ++minute) {
    const UtcTime at = start + minutes(minute);
    const auto a = once.known_at(at), b = again.known_at(at);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].position, b[i].position);
      EXPECT_EQ(a[i].identity, b[i].identity) << minute;
    }
    EXPECT_EQ(once.last_received(at), again.last_received(at));
  }
}

TEST(HeardVessels, StationsAndAircraftAreNoVesselsAndTellThatTheReceiverLives) {
  HeardVessels vessels;
  AisReport station = position(2, seconds(5), 50);
  station.speaker = ingest::AisClass::base_station;
  vessels.add(station);
  EXPECT_TRUE(vessels.known_at(start + minutes(1)).empty());
  EXPECT_EQ(vessels.last_received(start + minutes(1)), start + seconds(5));
}

TEST(HeardVessels, ACoarsePlaceCountsOnlyForWhoTellsNoFinerOne) {
  HeardVessels vessels;
  AisReport coarse = position(1, seconds(0), 50);
  coarse.type = 27;
  vessels.add(coarse);
  EXPECT_EQ(vessels.known_at(start).size(), 1U);
  vessels.add(position(1, seconds(10), 51));
  coarse.time = start + seconds(20);
  vessels.add(coarse);
  EXPECT_NEAR(latitude(vessels.known_at(start + seconds(30))[0]), 51, 1e-9);
}

TEST(HeardVessels, OfTooManyTheOlderHalfIsForgotten) {
  HeardVessels vessels(1000);
  for (int i = 0; i < 5000; ++i) vessels.add(position(1, seconds(i), 50));
  EXPECT_EQ(vessels.known_at(start + seconds(6000)).size(), 1U);
  EXPECT_TRUE(vessels.known_at(start + seconds(100)).empty());
  for (std::uint32_t i = 1; i < 5000; ++i) vessels.add(name(i, std::nullopt, "NOBODY"));
  EXPECT_LE(vessels.known_at(start + seconds(6000)).size(), 1U);
}

}  // namespace
}  // namespace slackwater::tests::heard_vessels_test

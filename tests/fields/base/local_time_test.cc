#include "fields/base/local_time.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::local_time_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

UtcTime utc(const char* text) { return parse_utc(text); }

TEST(LocalTime, InParisClocksGoForwardAtOneUtcOnTheLastSundayOfMarch) {
  const TimeZone paris = TimeZone::named("Europe/Paris");
  EXPECT_EQ(paris.text(utc("2025-03-30T00:59:00Z")), "2025-03-30 01:59 CET");
  EXPECT_EQ(paris.text(utc("2025-03-30T01:00:00Z")), "2025-03-30 03:00 CEST");
  EXPECT_EQ(paris.offset_at(utc("2025-03-30T00:59:59Z")), hours(1));
  EXPECT_EQ(paris.offset_at(utc("2025-03-30T01:00:00Z")), hours(2));
}

TEST(LocalTime, InParisClocksGoBackAtOneUtcOnTheLastSundayOfOctober) {
  const TimeZone paris = TimeZone::named("Europe/Paris");
  // The hour from 02:00 comes twice; the abbreviation tells which.
  EXPECT_EQ(paris.text(utc("2025-10-26T00:30:00Z")), "2025-10-26 02:30 CEST");
  EXPECT_EQ(paris.text(utc("2025-10-26T01:30:00Z")), "2025-10-26 02:30 CET");
}

TEST(LocalTime, SouthOfTheEquatorSummerIsInJanuary) {
  const TimeZone sydney = TimeZone::named("Australia/Sydney");
  EXPECT_EQ(sydney.text(utc("2025-01-15T12:00:00Z")), "2025-01-15 23:00 AEDT");
  EXPECT_EQ(sydney.text(utc("2025-07-15T12:00:00Z")), "2025-07-15 22:00 AEST");
  EXPECT_EQ(sydney.text(utc("2025-04-05T15:59:00Z")), "2025-04-06 02:59 AEDT");
  EXPECT_EQ(sydney.text(utc("2025-04-05T16:00:00Z")), "2025-04-06 02:00 AEST");
}

TEST(LocalTime, OfZonesWithHalfHoursAndWithoutSummerTime) {
  EXPECT_EQ(TimeZone::named("Asia/Kolkata").offset_at(utc("2025-06-01T00:00:00Z")), minutes(330));
  EXPECT_EQ(TimeZone::named("UTC").offset_at(utc("2025-06-01T00:00:00Z")), minutes(0));
}

TEST(LocalTime, ListsTheChangesOverAStretch) {
  const TimeZone paris = TimeZone::named("Europe/Paris");
  const auto changes = paris.changes(utc("2025-03-29T00:00:00Z"), utc("2025-10-27T00:00:00Z"));
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0], (ClockChange{utc("2025-03-29T00:00:00Z"), hours(1), "CET"}));
  EXPECT_EQ(changes[1], (ClockChange{utc("2025-03-30T01:00:00Z"), hours(2), "CEST"}));
  EXPECT_EQ(changes[2], (ClockChange{utc("2025-10-26T01:00:00Z"), hours(1), "CET"}));
  EXPECT_EQ(paris.changes(utc("2025-06-01T00:00:00Z"), utc("2025-06-04T00:00:00Z")).size(), 1U);
}

TEST(LocalTime, AnUnknownZoneIsRefusedWithTheOneThatIsMeant) {
  for (const auto& [found, meant] : std::vector<std::pair<std::string, std::string>>{
           {"Europe/Pariss", "Europe/Paris"}, {"paris", "Europe/Paris"}, {"Mars/Olympus", ""}}) {
    try {
      static_cast<void>(TimeZone::named(found));
      FAIL() << found;
    } catch (const Error& problem) {
      EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
      EXPECT_NE(problem.message().find("'" + found + "'"), std::string::npos);
      if (!meant.empty()) {
        EXPECT_NE(problem.message().find("did you mean '" + meant + "'"), std::string::npos)
            << problem.message();
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::local_time_test

#include "fields/base/time.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::time_test {
namespace {

using namespace std::chrono_literals;

TEST(UtcTimeText, RoundTripsThroughItsOwnText) {
  for (const char* const text :
       {"1970-01-01T00:00:00Z", "2024-02-29T23:59:59Z", "1899-12-31T12:00:00Z",
        "2025-03-10T05:00:00.125Z", "0001-01-01T00:00:00Z"}) {
    EXPECT_EQ(format_utc(parse_utc(text)), text);
  }
}

TEST(UtcTimeText, ReadsShorterFormsAndTheEndOfTheDay) {
  EXPECT_EQ(parse_utc("2025-03-10T05:00Z"), parse_utc("2025-03-10T05:00:00Z"));
  EXPECT_EQ(parse_utc("2025-03-09T24:00:00Z"), parse_utc("2025-03-10T00:00:00Z"));
}

TEST(UtcTimeText, RefusesWhatIsNotAUtcTime) {
  for (const char* const text :
       {"", "2025-03-10", "2025-03-10T05:00:00", "2025-02-29T00:00:00Z", "2025-13-01T00:00:00Z",
        "2025-03-10T25:00:00Z", "2025-03-10T05:60:00Z", "2025-03-10T05:00:00+01:00",
        "2025-03-10T24:00:01Z", "2025-03-10T05:00:00.Z", "yesterday"}) {
    try {
      static_cast<void>(parse_utc(text));
      FAIL() << text;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      // An example, or what this time would be in UTC.
      EXPECT_NE(error.message().find(":00Z"), std::string::npos) << error.message();
    }
  }
}

TEST(DurationText, ReadsDaysHoursAndMinutes) {
  EXPECT_EQ(parse_duration("72h"), 72h);
  EXPECT_EQ(parse_duration("1d12h"), 36h);
  EXPECT_EQ(parse_duration("90min"), 90min);
  for (const char* const text : {"", "72", "h", "-3h", "1.5h", "3 h", "1y"}) {
    EXPECT_THROW(static_cast<void>(parse_duration(text)), Error) << text;
  }
}

TEST(DayMembership, TheDayIsClosedAndAMeanMustLieInside) {
  const UtcDay day = parse_day("2021-10-13");
  const UtcTime midnight(day);
  EXPECT_TRUE(belongs_to_day(TimeCell::instant(midnight), day));
  EXPECT_TRUE(belongs_to_day(TimeCell::instant(midnight + 24h), day));
  EXPECT_FALSE(belongs_to_day(TimeCell::instant(midnight + 24h + 1s), day));
  EXPECT_TRUE(belongs_to_day({midnight + 23h, midnight + 24h}, day));
  EXPECT_FALSE(belongs_to_day({midnight + 23h, midnight + 25h}, day));
}

}  // namespace
}  // namespace slackwater::time_test

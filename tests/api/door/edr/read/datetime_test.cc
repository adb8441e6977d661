#include "api/door/edr/read/datetime.h"

#include "tests/api/door/edr/refusal.h"

namespace slackwater::api::edr::datetime_test {
namespace {

using tests::contains;
using tests::refusal_of;

std::string refusal(std::string_view text) {
  return refusal_of([&] { (void)parse_datetime(text); });
}

TEST(Datetime, EveryFormIsRead) {
  const std::pair<const char*, const char*> forms[] = {
      {"2025-03-09T06:00:00Z", "2025-03-09T06:00:00Z"},
      {"2025-03-09t06:00:00z", "2025-03-09T06:00:00Z"},
      {"2025-03-09T06:00Z", "2025-03-09T06:00:00Z"},
      {"2025-03-09T06:00:00.25Z", "2025-03-09T06:00:00.250Z"},
      {"2025-03-09T06:00:00+01:30", "2025-03-09T04:30:00Z"},
      {"2025-03-09T06:00:00 01:30", "2025-03-09T04:30:00Z"},
      {"2025-03-09T23:00:00-02:00", "2025-03-10T01:00:00Z"},
      {"2025-03-09", "2025-03-09T00:00:00Z/2025-03-10T00:00:00Z"},
      {"2025-03-09/2025-03-10", "2025-03-09T00:00:00Z/2025-03-11T00:00:00Z"},
      {"2025-03-09T00:00:00Z/2025-03-09T12:00:00Z", "2025-03-09T00:00:00Z/2025-03-09T12:00:00Z"},
      {"2025-03-09T00:00:00Z/2025-03-09T00:00:00Z", "2025-03-09T00:00:00Z"},
      {"../2025-03-09T12:00:00Z", "../2025-03-09T12:00:00Z"},
      {"/2025-03-09T12:00:00Z", "../2025-03-09T12:00:00Z"},
      {"2025-03-09T12:00:00Z/..", "2025-03-09T12:00:00Z/.."},
      {"2025-03-09/", "2025-03-09T00:00:00Z/.."},
      {"../2025-03-09", "../2025-03-10T00:00:00Z"},
      {"../..", "../.."},
  };
  for (const auto& [text, expected] : forms) {
    EXPECT_EQ(format_datetime(parse_datetime(text)), expected) << text;
  }
}

TEST(Datetime, AnIntervalHoldsBothItsEnds) {
  const TimeRange day = parse_datetime("2025-03-09");
  EXPECT_FALSE(day.is_instant());
  EXPECT_TRUE(day.contains(parse_utc("2025-03-09T00:00:00Z")));
  EXPECT_TRUE(day.contains(parse_utc("2025-03-10T00:00:00Z")));
  EXPECT_FALSE(day.contains(parse_utc("2025-03-10T00:00:00.001Z")));
  EXPECT_TRUE(parse_datetime("2025-03-09/..").contains(parse_utc("9999-01-01T00:00:00Z")));
  EXPECT_TRUE(parse_datetime("2025-03-09T06:00:00Z").is_instant());
}

TEST(Datetime, WhatIsNoTimeIsRefused) {
  for (const char* text : {"",
                           "/",
                           "now",
                           "2025",
                           "2025-03",
                           "2025-02-29",
                           "2025-13-01",
                           "2025-03-09T06",
                           "2025-03-09T25:00:00Z",
                           "2025-03-09T06:60:00Z",
                           "2025-03-09 06:00:00Z",
                           "2025-03-09T06:00:00+24:00",
                           "2025-03-09T06:00:00+1:00",
                           "2025-03-09T06:00:00+0100",
                           "20250309T060000Z",
                           "2025-03-09Z",
                           "2025-03-09+01:00",
                           "-2025-03-09",
                           "..",
                           "../",
                           "/..x",
                           "2025-03-09/P1D",
                           "2025-03-09/2025-03-10/2025-03-11",
                           "2025-03-09,2025-03-10",
                           "///",
                           "2025-03-09T06:00:00ZZ",
                           "2025-03-09T06:00:00.Z",
                           "1741500000",
                           "NaN",
                           "+01:00"}) {
    const std::string message = refusal(text);
    EXPECT_TRUE(contains(message, "datetime: found '")) << text;
    EXPECT_TRUE(contains(message, "2025-03-09T06:00:00Z")) << text;
  }
  EXPECT_TRUE(contains(refusal("2025-03-09T06:00:00"), "Z or an offset is missing"));
  EXPECT_TRUE(contains(refusal(std::string_view("2025-03-09\0", 11)), "found '2025-03-09.'"));
}

TEST(Datetime, AnIntervalThatRunsBackwardsIsRefused) {
  EXPECT_TRUE(
      contains(refusal("2025-03-10T00:00:00Z/2025-03-09T23:59:59Z"), "ends after it starts"));
}

TEST(Datetime, LongTextIsRefused) {
  EXPECT_TRUE(contains(refusal(std::string(1'000'000, '0')), "at most 128 bytes"));
}

}  // namespace
}  // namespace slackwater::api::edr::datetime_test

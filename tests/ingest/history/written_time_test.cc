#include "ingest/history/written_time.h"

#include <gtest/gtest.h>

namespace slackwater::ingest::written_time_test {
namespace {

TEST(WrittenTime, AllFormsOfOneInstant) {
  const UtcTime instant = parse_utc("2002-01-01T11:30:00Z");
  for (const char* text :
       {"2002-01-01T11:30Z", "2002-01-01 11:30:00Z", "2002-01-01T11:30:00.000Z",
        "2002-01-01T12:30+01:00", "2002-01-01 12:30:00+0100", "2002-01-01T12:30+01",
        "2002-01-01T06:00:00-05:30", "2002-01-01 11:30:00 UTC", "2002-01-01 11:30:00+00:00"}) {
    const auto time = read_written_time(text);
    ASSERT_TRUE(time.has_value()) << text;
    ASSERT_TRUE(time->offset.has_value()) << text;
    EXPECT_EQ(time->utc(), instant) << text;
  }
}

TEST(WrittenTime, ATimeWithoutAZoneSaysSo) {
  for (const char* text : {"2002-01-01T00:00", "2002-01-01 00:00:00", "2002-01-01"}) {
    const auto time = read_written_time(text);
    ASSERT_TRUE(time.has_value()) << text;
    EXPECT_FALSE(time->offset.has_value()) << text;
    EXPECT_EQ(time->clock, parse_utc("2002-01-01T00:00:00Z"));
  }
  EXPECT_EQ(read_written_time("2002-12-31T24:00Z")->utc(), parse_utc("2003-01-01T00:00:00Z"));
}

TEST(WrittenTime, WhatIsNoTimeIsNone) {
  for (const char* text :
       {"", "noon", "2002", "2002-13-01T00:00Z", "2002-02-30T00:00Z", "01/02/2002 00:00",
        "2002-01-01T25:00Z", "2002-01-01T24:01Z", "2002-01-01T10:60Z", "2002-01-01T10Z",
        "2002-01-01T10:00:61Z", "2002-01-01T10:00 CET", "2002-01-01T10:00+15:00",
        "2002-01-01T10:00Z ", "2002-01-01T10:00Zulu", "2002-01-01T10:00+1"})
    EXPECT_FALSE(read_written_time(text).has_value()) << text;
}

}  // namespace
}  // namespace slackwater::ingest::written_time_test

#include "api/report/time_text.h"

#include <gtest/gtest.h>

namespace slackwater::api {
namespace {

TEST(PageClock, TellsUtcAloneWithoutAZone) {
  const PageClock clock;
  EXPECT_EQ(clock.stamp(parse_utc("2025-03-10T06:29:31Z")), "Mon 10 Mar 06:30");
  EXPECT_EQ(clock.clock(parse_utc("2025-03-10T23:59:31Z")), "00:00");
  EXPECT_EQ(clock.note(), "Times are UTC.");
}

TEST(PageClock, TellsLocalTimeBesideUtcAndItsDayWhereThatIsAnother) {
  const PageClock clock(TimeZone::named("Europe/Paris"));
  EXPECT_EQ(clock.clock(parse_utc("2025-03-30T00:30:00Z")), "00:30 (01:30 CET)");
  EXPECT_EQ(clock.clock(parse_utc("2025-03-30T01:30:00Z")), "01:30 (03:30 CEST)");
  EXPECT_EQ(clock.stamp(parse_utc("2025-03-10T23:30:00Z")), "Mon 10 Mar 23:30 (Tue 00:30 CET)");
  EXPECT_EQ(clock.note(), "Times are UTC, in brackets local time (Europe/Paris).");
}

}  // namespace
}  // namespace slackwater::api

#include "api/show/report/time_text.h"

#include <gtest/gtest.h>

namespace slackwater::api::time_text_test {
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

TEST(PageClock, TellsAStretchOnceInEachClock) {
  const UtcTime from = parse_utc("2025-03-29T23:10:00Z");
  EXPECT_EQ(PageClock().clocks(from, from + std::chrono::minutes(50)), "23:10–24:00");
  const PageClock paris(TimeZone::named("Europe/Paris"));
  EXPECT_EQ(paris.clocks(parse_utc("2025-03-10T06:30:00Z"), parse_utc("2025-03-10T07:10:00Z")),
            "06:30–07:10 (07:30–08:10 CET)");
  EXPECT_EQ(paris.clocks(from, from + std::chrono::hours(2)),
            "23:10–01:10 (Sun 00:10–03:10 CET/CEST)");
}

}  // namespace
}  // namespace slackwater::api::time_text_test

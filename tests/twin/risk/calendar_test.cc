#include "twin/risk/workability/calendar.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"

namespace slackwater::twin::calendar_test {
namespace {

constexpr Duration hour = std::chrono::hours(1);

TEST(Calendar, MonthsHoldTheirDaysAndLeapYearsTheTwentyNinth) {
  const StepClock clock{parse_utc("2003-11-10T07:00:00Z"), hour, 24 * 150};
  const std::vector<MonthSteps> months = months_of(clock, std::nullopt);
  ASSERT_EQ(months.size(), 6U);
  EXPECT_EQ(months[0].steps.steps(), 24U * 21 - 7);
  EXPECT_EQ(months[1].steps.steps(), 24U * 31);
  EXPECT_EQ(months[2].year, 2004);
  EXPECT_EQ(months[2].month, 1);
  EXPECT_EQ(months[3].steps.steps(), 24U * 29);
  EXPECT_EQ(months.back().steps.end, clock.steps);
}

/// New year in Berlin is at 23:00 UTC; in a year of summer time nothing is lost or counted twice.
TEST(Calendar, MonthsOfAZoneBeginAtItsMidnight) {
  const StepClock clock{parse_utc("2001-12-31T20:00:00Z"), hour, 24 * 366};
  const std::vector<MonthSteps> months = months_of(clock, TimeZone::named("Europe/Berlin"));
  EXPECT_EQ(months[0].steps, (StepRange{0, 3}));
  EXPECT_EQ(months[3].month, 3);
  EXPECT_EQ(months[3].steps.steps(), 31U * 24 - 1) << "the clocks go forward";
  EXPECT_EQ(months[10].steps.steps(), 31U * 24 + 1) << "and back";
  std::size_t sum = 0;
  for (const MonthSteps& month : months) sum += month.steps.steps();
  EXPECT_EQ(sum, clock.steps);
}

TEST(Calendar, HoursAreHalfOpenAndGoOverMidnight) {
  const StepClock clock{parse_utc("2002-01-01T00:00:00Z"), hour, 48};
  EXPECT_EQ(steps_at(clock, parse_day_hours("6-18"), std::nullopt),
            (StepRanges{{6, 18}, {30, 42}}));
  EXPECT_EQ(steps_at(clock, parse_day_hours("20-4"), std::nullopt),
            (StepRanges{{0, 4}, {20, 28}, {44, 48}}));
  EXPECT_EQ(steps_at(clock, parse_day_hours("06:30-08:00"), std::nullopt),
            (StepRanges{{7, 8}, {31, 32}}));
  EXPECT_EQ(steps_at(clock, parse_day_hours("0-24"), std::nullopt), (StepRanges{{0, 48}}));
}

TEST(Calendar, HoursFollowSummerTime) {
  // 06:00 in Berlin is 05:00 UTC in winter, 04:00 from 31 March 2002 on.
  const StepClock clock{parse_utc("2002-03-30T00:00:00Z"), hour, 48};
  EXPECT_EQ(steps_at(clock, parse_day_hours("6-18"), TimeZone::named("Europe/Berlin")),
            (StepRanges{{5, 17}, {28, 40}}));
}

TEST(Calendar, HoursThatAreNoneAreRefused) {
  for (const char* text :
       {"", "6", "6-", "-18", "6-25", "6-6", "6:70-18", "six-ten", "24-6", "6-18h", "24:30-6"})
    EXPECT_THROW(static_cast<void>(parse_day_hours(text)), Error) << text;
}

TEST(Calendar, ADateComesOnceAYear) {
  const StepClock clock{parse_utc("2002-04-01T06:00:00Z"), hour, 24 * 365 * 3};
  const auto date = std::chrono::April / 1;
  const std::vector<YearDate> dates = dates_of(clock, date, std::nullopt);
  ASSERT_EQ(dates.size(), 2U) << "2002 begins after midnight of 1 April, 2005 after the end";
  EXPECT_EQ(format_utc(clock.time_of(dates[0].step)), "2003-04-01T00:00:00Z");
  EXPECT_EQ(format_utc(clock.time_of(dates[1].step)), "2004-04-01T00:00:00Z");
  const auto local = dates_of(clock, date, TimeZone::named("Europe/Berlin"));
  EXPECT_EQ(format_utc(clock.time_of(local[0].step)), "2003-03-31T22:00:00Z");
}

}  // namespace
}  // namespace slackwater::twin::calendar_test

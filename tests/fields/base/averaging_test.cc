#include "fields/base/numbers/averaging.h"

#include <gtest/gtest.h>

#include <vector>

namespace slackwater::averaging_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;
using std::chrono::seconds;

const UtcTime noon = parse_utc("2024-06-11T12:00:00Z");

std::vector<TimeCell> cells(Duration width) {
  std::vector<TimeCell> result;
  for (int i = 0; i < 5; ++i)
    result.push_back({noon + i * hours(24), noon + i * hours(24) + width});
  return result;
}

TEST(Averaging, IsTheUsualWidthOfTheCells) {
  EXPECT_EQ(averaging_of({}), Duration(0));
  for (const Duration width : {Duration(0), Duration(minutes(20)), Duration(hours(24))})
    EXPECT_EQ(averaging_of(cells(width)), width);
  std::vector<TimeCell> mostly = cells(hours(1));
  mostly.front() = {noon, noon + hours(24)};
  EXPECT_EQ(averaging_of(mostly), hours(1));
}

TEST(Averaging, SixHoursAndMoreHideTheTideWhateverTheRoundingOfTheirBounds) {
  for (const Duration width : {Duration(0), Duration(minutes(10)), Duration(hours(1)),
                               Duration(hours(3)), Duration(hours(5)) + minutes(58)})
    EXPECT_FALSE(hides_the_tide(width)) << width.count();
  for (const Duration width : {Duration(hours(6)) - seconds(1), Duration(hours(6)),
                               Duration(hours(12)), Duration(hours(24)), Duration(hours(25))})
    EXPECT_TRUE(hides_the_tide(width)) << width.count();
}

TEST(Averaging, IsSaidInPlainWords) {
  EXPECT_EQ(averaging_text(Duration(0)), "instants");
  EXPECT_EQ(averaging_text(hours(6)), "means over 6 h");
  EXPECT_EQ(averaging_text(hours(12)), "means over 12 h");
  EXPECT_EQ(averaging_text(hours(24)), "daily means");
  EXPECT_EQ(averaging_text(hours(25)), "daily means") << "the 25 hours of a tidal filter";
  EXPECT_EQ(averaging_text(hours(720)), "means over 720 h");
}

}  // namespace
}  // namespace slackwater::averaging_test

#include "api/show/report/slack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace slackwater::api::slack_test {
namespace {

using std::chrono::hours;
using std::chrono::minutes;

std::vector<UtcTime> hourly(std::size_t n) {
  std::vector<UtcTime> time;
  for (std::size_t i = 0; i < n; ++i)
    time.push_back(parse_utc("2025-03-10T00:00:00Z") + hours(static_cast<int>(i)));
  return time;
}

TEST(SlackWindows, BeginAndEndWhereTheLineCrossesTheThreshold) {
  const auto time = hourly(5);
  const auto windows = slack_windows(time, {1, 0.75, 0.25, 0.25, 1}, {}, 0.5);
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_EQ(windows[0].from, time[1] + minutes(30));
  EXPECT_EQ(windows[0].to, time[3] + minutes(20));
  EXPECT_FALSE(windows[0].is_cut_before || windows[0].is_cut_after);
  EXPECT_FALSE(windows[0].sure_from) << "no futures are known";
}

/// At each hour nine of ten futures are slack, but each has an hour of its own at which it is not:
/// an hour is sure, all of them are not.
TEST(SlackWindows, AreSureWhereNineOfTenFuturesStayBelowThroughout) {
  const auto time = hourly(6);
  const std::vector<double> likely{1, 0.25, 0.25, 0.25, 0.25, 1};
  std::vector<std::vector<double>> futures(20, likely);
  for (std::size_t f = 0; f < 8; ++f) futures[f][1 + f / 2] = 0.75;
  const auto apart = slack_windows(time, likely, futures, 0.5);
  ASSERT_EQ(apart.size(), 1U);
  EXPECT_EQ(apart[0].sure_from, time[1]);
  EXPECT_EQ(apart[0].sure_to, time[1]) << "two hours hold in 16 of 20";
  for (std::size_t f = 0; f < 8; ++f) futures[f] = likely;
  futures[0][4] = futures[1][4] = futures[2][4] = 0.75;
  const auto together = slack_windows(time, likely, futures, 0.5);
  EXPECT_EQ(together[0].sure_from, time[1]);
  EXPECT_EQ(together[0].sure_to, time[3]);
  futures.resize(9);
  EXPECT_FALSE(slack_windows(time, likely, futures, 0.5)[0].sure_from) << "too few";
}

/// By hand, all pairs of times: the longest stretch, the earliest of equal ones.
TEST(SlackWindows, AreSureForTheLongestOfAllStretches) {
  std::mt19937 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    const auto time = hourly(12);
    const std::size_t many = 10 + random() % 15;
    std::vector<std::vector<double>> futures(many, std::vector<double>(time.size()));
    for (auto& future : futures)
      for (double& speed_m_s : future) speed_m_s = random() % 12 == 0 ? 0.75 : 0.25;
    const auto found = slack_windows(time, std::vector<double>(time.size(), 0.25), futures, 0.5);
    ASSERT_EQ(found.size(), 1U);
    std::optional<std::pair<std::size_t, std::size_t>> longest;
    for (std::size_t from = 0; from < time.size(); ++from)
      for (std::size_t to = from; to < time.size(); ++to) {
        const auto stays = std::count_if(futures.begin(), futures.end(), [&](const auto& future) {
          return std::all_of(future.begin() + static_cast<std::ptrdiff_t>(from),
                             future.begin() + static_cast<std::ptrdiff_t>(to) + 1,
                             [](double speed_m_s) { return speed_m_s < 0.5; });
        });
        if (10 * static_cast<std::size_t>(stays) < 9 * many) continue;
        if (!longest || to - from > longest->second - longest->first) longest = {from, to};
      }
    ASSERT_EQ(found[0].sure_from.has_value(), longest.has_value()) << trial;
    if (!longest) continue;
    EXPECT_EQ(found[0].sure_from, time[longest->first]) << trial;
    EXPECT_EQ(found[0].sure_to, time[longest->second]) << trial;
  }
}

TEST(SlackWindows, CutByTheEndsOfTheSeriesSaySo) {
  const auto windows = slack_windows(hourly(3), {0.1, 0.9, 0.1}, {}, 0.5);
  ASSERT_EQ(windows.size(), 2U);
  EXPECT_TRUE(windows[0].is_cut_before);
  EXPECT_TRUE(windows[1].is_cut_after);
}

TEST(SlackWindows, MissingValuesAreNeverSlack) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto time = hourly(4);
  EXPECT_TRUE(slack_windows(time, {nan, nan, nan, nan}, {}, 0.5).empty());
  const auto windows = slack_windows(time, {nan, 0.1, nan, 0.9}, {}, 0.5);
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_EQ(windows[0].from, time[1]);
  EXPECT_TRUE(windows[0].is_cut_before && windows[0].is_cut_after);
}

}  // namespace
}  // namespace slackwater::api::slack_test

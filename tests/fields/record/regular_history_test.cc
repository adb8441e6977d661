#include "fields/record/regular_history.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/error.h"

namespace slackwater::regular_history_test {
namespace {

const UtcTime start = parse_utc("2002-01-01T00:00:00Z");

HistorySeries series_at(const std::vector<int>& minutes, const std::string& name = "a") {
  HistorySeries series;
  series.name = name;
  for (const int minute : minutes) {
    series.time.push_back(start + std::chrono::minutes(minute));
    series.value.push_back(minute);
  }
  return series;
}

std::string refusal(const std::vector<HistorySeries>& series) {
  try {
    static_cast<void>(on_regular_steps(series));
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

TEST(RegularHistory, WhatIsLeftOutIsMissing) {
  const RegularHistory history = on_regular_steps({{series_at({0, 60, 240, 300})}});
  EXPECT_EQ(history.clock, (StepClock{start, std::chrono::hours(1), 6}));
  const std::vector<double>& values = history.values.front();
  EXPECT_EQ(values[1], 60);
  EXPECT_TRUE(std::isnan(values[2]) && std::isnan(values[3]));
  EXPECT_EQ(values[4], 240);
}

TEST(RegularHistory, AValueHoldsOverItsOwnStep) {
  const std::vector<HistorySeries> both{series_at({0, 60, 120, 180, 240, 300}, "hourly"),
                                        series_at({0, 180, 720}, "three-hourly")};
  const RegularHistory history = on_regular_steps(both);
  ASSERT_EQ(history.clock.steps, 15U) << "the last three-hourly value counts to 15:00";
  const std::vector<double>& coarse = history.values[1];
  EXPECT_EQ(coarse[2], 0);
  EXPECT_EQ(coarse[5], 180);
  EXPECT_TRUE(std::isnan(coarse[6])) << "no longer than three hours";
  EXPECT_EQ(coarse[14], 720);
  EXPECT_TRUE(std::isnan(history.values[0][6]));
  EXPECT_EQ(history.own_step,
            (std::vector<Duration>{std::chrono::hours(1), std::chrono::hours(3)}));
  ASSERT_EQ(history.notes.size(), 1U);
  EXPECT_NE(history.notes[0].find("three-hourly is given every 3 h"), std::string::npos);
}

TEST(RegularHistory, HalfHoursApartMakeHalfHours) {
  const RegularHistory history =
      on_regular_steps({{series_at({0, 60, 120}), series_at({30, 90, 150}, "means")}});
  EXPECT_EQ(history.clock, (StepClock{start, std::chrono::minutes(30), 7}));
  EXPECT_TRUE(std::isnan(history.values[1][0]));
  EXPECT_EQ(history.values[1][2], 30);
  EXPECT_EQ(history.values[0][5], 120);
}

/// Hours as days in floating point, a minute off: they are hours still, over years.
TEST(RegularHistory, TimesMayStrayALittle) {
  HistorySeries series;
  for (int i = 0; i < 50000; ++i) {
    const float days = 20000.0F + static_cast<float>(i) / 24.0F;  // a resolution of 169 s
    series.time.push_back(
        UtcTime(Duration(std::llround(static_cast<double>(days) * 86'400'000.0))));
    series.value.push_back(i);
  }
  const RegularHistory history = on_regular_steps({{series}});
  EXPECT_EQ(history.clock.step, std::chrono::hours(1));
  ASSERT_EQ(history.clock.steps, 50000U);
  for (std::size_t i = 0; i < 50000; ++i) ASSERT_EQ(history.values[0][i], static_cast<double>(i));
}

TEST(RegularHistory, WhatIsNotRegularIsRefusedWithTheTime) {
  EXPECT_NE(refusal({series_at({0, 60, 147, 240})}).find("2002-01-01T02:27:00Z"),
            std::string::npos);
  EXPECT_NE(refusal({series_at({0})}).find("found one time"), std::string::npos);
  EXPECT_NE(refusal({series_at({0, 60, 120}), series_at({7, 67}, "b")}).find("share no step"),
            std::string::npos);
  EXPECT_NE(refusal({series_at({0, 1, 2'000'000'000})}).find("expected at most"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::regular_history_test

#include "api/ask/windows/unforecast.h"

#include <gtest/gtest.h>

namespace slackwater::api::unforecast_test {
namespace {

const UtcTime from = parse_utc("2025-03-04T00:00:00Z");

TaskWindows limited_by(std::initializer_list<twin::LimitVariable> variables) {
  TaskWindows task;
  for (const twin::LimitVariable variable : variables) {
    twin::Limit limit;
    limit.variable = variable;
    task.limits.push_back({"surveyor", "", limit});
  }
  task.limits.push_back({{}, "daylight", {}});
  return task;
}

/// Two days, the second of other sources than the first.
Snapshot forecast(DataStatus waves, DataStatus wind) {
  Snapshot s;
  s.columns.resize(2);
  for (int h = 0; h <= 48; ++h) {
    s.time.push_back(from + std::chrono::hours(h));
    s.columns[1].sea_source.push_back(h <= 24 ? DataStatus::forecast : waves);
    s.columns[1].wind_source.push_back(h <= 24 ? DataStatus::forecast : wind);
  }
  return s;
}

std::string said(const Snapshot& s, const TaskWindows& task, int begin_h, int end_h) {
  return unforecast(s, task, from + std::chrono::hours(begin_h), from + std::chrono::hours(end_h));
}

using enum twin::LimitVariable;

TEST(Unforecast, IsAKeptSeaForWhoIsLimitedByWavesThen) {
  const Snapshot s = forecast(DataStatus::persisted, DataStatus::forecast);
  EXPECT_EQ(said(s, limited_by({significant_wave_height}), 30, 33),
            "the waves are the last known sea, kept");
  EXPECT_EQ(said(s, limited_by({significant_wave_height}), 10, 24), "");
  EXPECT_NE(said(s, limited_by({significant_wave_height}), 20, 25), "") << "its end is kept";
  EXPECT_EQ(said(s, limited_by({wind_speed, current_speed}), 30, 33), "");
}

TEST(Unforecast, IsAWindThatPersistsAndTheWavesThatItRaises) {
  const Snapshot s = forecast(DataStatus::modelled, DataStatus::persisted);
  for (const twin::LimitVariable variable : {wind_speed, wind_speed_10m, gust_speed})
    EXPECT_EQ(said(s, limited_by({variable}), 30, 33), "the wind is the last known one, fading");
  EXPECT_EQ(said(s, limited_by({significant_wave_height}), 30, 33),
            "the waves are computed from a wind that is the last known one, fading");
  EXPECT_EQ(said(s, limited_by({current_speed}), 30, 33), "");
  const Snapshot blown = forecast(DataStatus::modelled, DataStatus::forecast);
  EXPECT_EQ(said(blown, limited_by({significant_wave_height}), 30, 33), "")
      << "waves that are computed from a forecast wind are forecast";
  EXPECT_EQ(said(Snapshot(), limited_by({significant_wave_height}), 0, 3), "");
}

TEST(Unforecast, IsWorthLessThanAGo) {
  EXPECT_EQ(twin::verdict_of(most_worth_unforecast({}), {}), twin::Verdict::marginal);
  EXPECT_EQ(most_worth_unforecast({0, 0}), 0);
}

}  // namespace
}  // namespace slackwater::api::unforecast_test

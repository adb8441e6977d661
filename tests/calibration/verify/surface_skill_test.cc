#include "calibration/verify/surface_skill.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calibration/verify/current_skill.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::surface_skill_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const UtcTime issued = end_of_day + hours(5);

/// A wind that grows by 1 m/s an hour: how old a value is, is how far it is off.
TEST(SurfaceSkill, PersistenceHoldsTheWindOfTheIssueAndIsJudgedAfterIt) {
  tests::KnownSeriesForTests sea;
  sea.wind(tests::analysis_of("wind"),
           tests::instants(end_of_day - days(2), end_of_day + hours(24)), [](UtcTime time, double) {
             return Horizontal{50 + hours_between(end_of_day, time), 0};
           });
  Snapshot forecast;
  forecast.day = day;
  forecast.issued = issued;
  forecast.columns.resize(1);
  for (int h = 0; h <= 24; ++h) {
    forecast.time.push_back(end_of_day + hours(h));
    forecast.columns[0].wind_m_s.emplace_back(50 + h, 0);
    forecast.columns[0].wind_source.push_back(DataStatus::forecast);
  }
  VerifyOptions options;
  options.leads = {{0, 24}};
  const std::vector<SkillEntry> entries =
      score_surface(sea.data, forecast, end_of_day, options, SkillEntry{});
  bool is_seen = false;
  for (const SkillEntry& entry : entries) {
    if (entry.method != Method::persistence) continue;
    is_seen = true;
    EXPECT_EQ(entry.vector.n, 19U) << "from 06:00 to 24:00";
    double squares = 0;
    for (int h = 1; h <= 19; ++h) squares += h * h;
    EXPECT_NEAR(entry.vector.rmse_m_s, std::sqrt(squares / 19), 1e-9);
  }
  EXPECT_TRUE(is_seen);
}

}  // namespace
}  // namespace slackwater::calibration::surface_skill_test

// What past forecasts were worth, in words, by the rule of the verdict.
#include "api/show/morning/recent_skill_text.h"

#include <gtest/gtest.h>

namespace slackwater::tests::recent_skill_test {
namespace {

using namespace calibration;
using std::chrono::days;

SkillEntry waves(int day, Method method, double rmse_m, double ours_m) {
  SkillEntry entry;
  entry.variable = wave_variable;
  entry.site = "here";
  entry.day = parse_day("2025-03-01") + days(day);
  entry.issued = UtcTime(entry.day) + days(1);
  entry.lead = {0, 24};
  entry.method = method;
  ScalarScore score;
  score.n = 24;
  score.rmse = rmse_m;
  entry.scalar = score;
  if (method != Method::forecast) entry.forecast_rmse = ours_m;
  return entry;
}

std::vector<SkillEntry> ten_days(double ours_m, double theirs_m) {
  std::vector<SkillEntry> entries;
  for (int day = 0; day < 10; ++day) {
    const double wobble = 1 + 0.02 * (day % 3);
    entries.push_back(waves(day, Method::forecast, ours_m * wobble, ours_m));
    entries.push_back(waves(day, Method::persistence, theirs_m * wobble, ours_m * wobble));
  }
  return entries;
}

TEST(RecentSkill, SaysWhatIsBetterWhatIsWorseAndWhatNobodyCanTell) {
  const auto better = api::trust_of(ten_days(0.2, 0.4), WindPolicy::best);
  ASSERT_EQ(better.size(), 1U) << "currents and wind were not scored";
  EXPECT_EQ(
      api::text_of(better.front()),
      "wave height 0.20 m over 10 forecasts, 50 % less than the best simple method (persistence, "
      "0.41 m)");
  const auto worse = api::trust_of(ten_days(0.4, 0.2), WindPolicy::best);
  EXPECT_NE(api::text_of(worse.front()).find("WORSE than"), std::string::npos);
  const auto same = api::trust_of(ten_days(0.2, 0.2), WindPolicy::best);
  EXPECT_NE(api::text_of(same.front()).find("within noise of"), std::string::npos);
  EXPECT_TRUE(api::trust_of({}, WindPolicy::best).empty());
  EXPECT_TRUE(api::trust_of(ten_days(0.2, 0.4), WindPolicy::persist).empty());
}

TEST(RecentSkill, AForecastWithoutARivalIsNotPraised) {
  std::vector<SkillEntry> alone;
  for (int day = 0; day < 10; ++day) alone.push_back(waves(day, Method::forecast, 0.2, 0.2));
  EXPECT_EQ(api::text_of(api::trust_of(alone, WindPolicy::best).front()),
            "wave height 0.20 m over 10 forecasts (no simple method to compare with)");
}

TEST(RecentSkill, TheNewestDayStandsByItself) {
  std::vector<SkillEntry> entries = ten_days(0.2, 0.4);
  entries.push_back(waves(10, Method::forecast, 0.9, 0.9));
  entries.push_back(waves(10, Method::persistence, 0.3, 0.9));
  const auto newest = api::newest_day_of(entries, WindPolicy::best);
  ASSERT_EQ(newest.size(), 2U);
  const auto trust = api::trust_of(newest, WindPolicy::best);
  ASSERT_EQ(trust.size(), 1U);
  EXPECT_DOUBLE_EQ(trust.front().verdict.forecast.score.rmse, 0.9);
  EXPECT_EQ(trust.front().verdict.outcome, Outcome::beaten);
}

}  // namespace
}  // namespace slackwater::tests::recent_skill_test

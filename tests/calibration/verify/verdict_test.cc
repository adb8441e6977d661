#include "calibration/verify/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::calibration {
namespace {

/// The error of a method for the day of June 2024 that is given, lead 0-24 h, all depths.
SkillEntry entry_of(int day, Method method, double rmse_m_s, WindPolicy wind = WindPolicy::best) {
  SkillEntry entry;
  entry.variable = current_variable;
  entry.site = "site";
  entry.day = parse_day("2024-06-01") + std::chrono::days(day - 1);
  entry.issued = UtcTime(entry.day) + std::chrono::hours(29);
  entry.wind = wind;
  entry.method = method;
  entry.band = DepthBand{0, whole_column_m, false};
  entry.vector.n = 10;
  entry.vector.rmse_m_s = rmse_m_s;
  return entry;
}

TEST(Verdict, TheBestBaselineIsTheOneOfTheSmallestErrorOverTheSetOfPairs) {
  const auto verdict =
      verdict_of({entry_of(1, Method::forecast, 0.3), entry_of(2, Method::forecast, 0.4),
                  entry_of(1, Method::persistence, 0.1), entry_of(2, Method::persistence, 0.9),
                  entry_of(1, Method::day_mean, 0.4), entry_of(2, Method::day_mean, 0.4)},
                 WindPolicy::best);
  ASSERT_TRUE(verdict && verdict->best);
  EXPECT_EQ(verdict->best->method, Method::day_mean);
  EXPECT_EQ(verdict->best->pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->best->rmse_m_s, 0.4);
  EXPECT_DOUBLE_EQ(verdict->forecast.score.rmse, std::sqrt(0.125));
  EXPECT_EQ(verdict->best->forecast_rmse_m_s, verdict->forecast.score.rmse);
  EXPECT_FALSE(verdict->is_beaten());
}

TEST(Verdict, AnEqualBaselineDoesNotBeatTheForecast) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.3),
                                  entry_of(1, Method::same_hour, 0.3)};
  EXPECT_FALSE(verdict_of(entries, WindPolicy::best)->is_beaten());
  entries.back().vector.rmse_m_s = 0.299;
  EXPECT_TRUE(verdict_of(entries, WindPolicy::best)->is_beaten());
}

TEST(Verdict, ADifferenceThatNoTableShowsIsATie) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.3),
                                  entry_of(1, Method::same_hour, 0.3)};
  EXPECT_EQ(verdict_of(entries, WindPolicy::best)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = std::nextafter(0.3, 0.0);
  EXPECT_EQ(verdict_of(entries, WindPolicy::best)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = 0.3004;
  EXPECT_EQ(verdict_of(entries, WindPolicy::best)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = 0.301;
  EXPECT_EQ(verdict_of(entries, WindPolicy::best)->outcome, Outcome::ahead);
}

TEST(Verdict, OverManyDaysADifferenceWithinNoiseIsATieAndASteadyOneIsNot) {
  // A day is won, a day is lost, by far more than the mean difference of 1 cm/s.
  std::vector<SkillEntry> noisy;
  std::vector<SkillEntry> steady;
  for (int day = 1; day <= 8; ++day) {
    noisy.push_back(entry_of(day, Method::forecast, 0.30));
    noisy.push_back(entry_of(day, Method::day_mean, day % 2 == 0 ? 0.20 : 0.36));
    steady.push_back(entry_of(day, Method::forecast, 0.30));
    steady.push_back(entry_of(day, Method::day_mean, 0.29));
  }
  EXPECT_EQ(verdict_of(noisy, WindPolicy::best)->outcome, Outcome::tie);
  EXPECT_EQ(verdict_of(steady, WindPolicy::best)->outcome, Outcome::beaten);
}

TEST(Verdict, TheOneToSayIsThatOfMostPairs) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.1, WindPolicy::best),
                                  entry_of(1, Method::forecast, 0.3, WindPolicy::persist)};
  EXPECT_EQ(main_verdict(entries)->wind, WindPolicy::best) << "the first of equals";
  entries.push_back(entry_of(2, Method::forecast, 0.3, WindPolicy::persist));
  EXPECT_EQ(main_verdict(entries)->wind, WindPolicy::persist);
  EXPECT_FALSE(main_verdict({}));
}

TEST(Verdict, TheOracleIsNoRivalAndTheProviderIs) {
  const auto verdict =
      verdict_of({entry_of(1, Method::forecast, 0.3), entry_of(1, Method::oracle_mean, 0.1),
                  entry_of(1, Method::provider, 0.2)},
                 WindPolicy::best);
  EXPECT_EQ(verdict->best->method, Method::provider);
  EXPECT_TRUE(verdict->is_beaten());
}

TEST(Verdict, ABaselineIsHeldAgainstTheForecastOverTheDaysThatBothHave) {
  // The provider's forecasts came on the two calm days alone: over all its pairs it has 0.10, we
  // have 0.26 over all of ours, and yet we were better whenever both spoke.
  std::vector<SkillEntry> entries{
      entry_of(1, Method::forecast, 0.08), entry_of(2, Method::forecast, 0.08),
      entry_of(3, Method::forecast, 0.36), entry_of(4, Method::forecast, 0.36),
      entry_of(1, Method::provider, 0.10), entry_of(2, Method::provider, 0.10)};
  for (int day = 1; day <= 4; ++day) entries.push_back(entry_of(day, Method::persistence, 0.5));
  const auto verdict = verdict_of(entries, WindPolicy::best);
  ASSERT_EQ(verdict->best->method, Method::provider) << "1.25 times our error, persistence 1.9";
  EXPECT_EQ(verdict->best->pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->best->rmse_m_s, 0.10);
  EXPECT_DOUBLE_EQ(verdict->best->forecast_rmse_m_s, 0.08);
  EXPECT_LT(verdict->best->rmse_m_s, verdict->forecast.score.rmse);
  EXPECT_FALSE(verdict->is_beaten());
}

TEST(Verdict, OneLuckyDayIsNoRival) {
  std::vector<SkillEntry> entries;
  for (int day = 1; day <= 5; ++day) {
    entries.push_back(entry_of(day, Method::forecast, 0.1));
    entries.push_back(entry_of(day, Method::day_mean, 0.2));
  }
  entries.push_back(entry_of(1, Method::provider, 0.01));
  entries.push_back(entry_of(2, Method::provider, 0.01));
  EXPECT_EQ(verdict_of(entries, WindPolicy::best)->best->method, Method::day_mean);
  entries.push_back(entry_of(3, Method::provider, 0.01));
  const auto verdict = verdict_of(entries, WindPolicy::best);
  EXPECT_EQ(verdict->best->method, Method::provider) << "three of five are more than half";
  EXPECT_EQ(verdict->best->pairs, 3U);
  EXPECT_TRUE(verdict->is_beaten());
}

TEST(Verdict, WindPoliciesAreNotMixed) {
  const std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.1, WindPolicy::best),
                                        entry_of(1, Method::day_mean, 0.2, WindPolicy::best),
                                        entry_of(1, Method::forecast, 0.3, WindPolicy::persist),
                                        entry_of(1, Method::day_mean, 0.2, WindPolicy::persist)};
  const std::vector<Verdict> verdicts = verdicts_of(entries);
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].wind, WindPolicy::best);
  EXPECT_FALSE(verdicts[0].is_beaten());
  EXPECT_EQ(verdicts[1].wind, WindPolicy::persist);
  EXPECT_TRUE(verdicts[1].is_beaten());
  EXPECT_EQ(verdicts[1].forecast.score.rmse, 0.3);
  EXPECT_FALSE(verdict_of(entries, WindPolicy::forecast));
}

TEST(Verdict, JudgesTheWidestBandAndTheFirstDayOfLeadWhateverStandsFirst) {
  const auto at = [](SkillEntry entry, double from_m, double to_m, double from_h, double to_h) {
    entry.band = DepthBand{from_m, to_m, false};
    entry.lead = {from_h, to_h};
    return entry;
  };
  const SkillEntry ours = entry_of(1, Method::forecast, 0.3);
  const SkillEntry other = entry_of(1, Method::forecast, 0.9);
  SkillEntry bed = other;
  bed.band = DepthBand{0, 50, true};
  SkillEntry column = at(other, 5, 20, 0, 24);
  column.column = 0;
  const auto verdict =
      verdict_of({at(other, 0, 5, 0, 24), bed, column, at(other, 5, 20, 24, 48),
                  at(other, 5, 20, 0, 1), at(ours, 5, 20, 0, 24), at(other, 20, 35, 0, 24)},
                 WindPolicy::best);
  ASSERT_TRUE(verdict);
  EXPECT_EQ(verdict->forecast.score.rmse, 0.3);
  EXPECT_EQ(verdict->forecast.score.pairs, 1U) << "bands of one width are not pooled";
  EXPECT_FALSE(verdict->best);
  EXPECT_EQ(verdict->outcome, Outcome::alone);
}

}  // namespace
}  // namespace slackwater::calibration

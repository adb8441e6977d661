#include "calibration/verify/verdict.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slackwater::calibration::verdict_test {
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

/// Each baseline with our own error beside it, over all that we have that day.
std::vector<SkillEntry> beside(std::vector<SkillEntry> entries) {
  for (SkillEntry& theirs : entries) {
    if (theirs.method == Method::forecast) continue;
    for (const SkillEntry& ours : entries) {
      if (ours.method == Method::forecast && ours.day == theirs.day && ours.wind == theirs.wind &&
          ours.origin == theirs.origin)
        theirs.forecast_rmse = ours.vector.rmse_m_s;
    }
  }
  return entries;
}

std::optional<Verdict> judged(const std::vector<SkillEntry>& entries) {
  return verdict_of(beside(entries), WindPolicy::best);
}

TEST(Verdict, TheBestBaselineIsTheOneOfTheSmallestErrorOverTheSetOfPairs) {
  const auto verdict =
      judged({entry_of(1, Method::forecast, 0.3), entry_of(2, Method::forecast, 0.4),
              entry_of(1, Method::persistence, 0.1), entry_of(2, Method::persistence, 0.9),
              entry_of(1, Method::day_mean, 0.4), entry_of(2, Method::day_mean, 0.4)});
  ASSERT_TRUE(verdict && verdict->best);
  EXPECT_EQ(verdict->best->method, Method::day_mean);
  EXPECT_EQ(verdict->best->pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->best->rmse, 0.4);
  EXPECT_DOUBLE_EQ(verdict->forecast.score.rmse, std::sqrt(0.125));
  EXPECT_EQ(verdict->best->forecast_rmse, verdict->forecast.score.rmse);
  EXPECT_FALSE(verdict->is_beaten());
}

TEST(Verdict, AnEqualBaselineDoesNotBeatTheForecast) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.3),
                                  entry_of(1, Method::same_hour, 0.3)};
  EXPECT_FALSE(judged(entries)->is_beaten());
  entries.back().vector.rmse_m_s = 0.299;
  EXPECT_TRUE(judged(entries)->is_beaten());
}

TEST(Verdict, ADifferenceThatNoTableShowsIsATie) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.3),
                                  entry_of(1, Method::same_hour, 0.3)};
  EXPECT_EQ(judged(entries)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = std::nextafter(0.3, 0.0);
  EXPECT_EQ(judged(entries)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = 0.3004;
  EXPECT_EQ(judged(entries)->outcome, Outcome::tie);
  entries.back().vector.rmse_m_s = 0.301;
  EXPECT_EQ(judged(entries)->outcome, Outcome::ahead);
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
  EXPECT_EQ(judged(noisy)->outcome, Outcome::tie);
  EXPECT_EQ(judged(steady)->outcome, Outcome::beaten);
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
      judged({entry_of(1, Method::forecast, 0.3), entry_of(1, Method::oracle_mean, 0.1),
              entry_of(1, Method::provider, 0.2)});
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
  const auto verdict = judged(entries);
  ASSERT_EQ(verdict->best->method, Method::provider) << "1.25 times our error, persistence 1.9";
  EXPECT_EQ(verdict->best->pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->best->rmse, 0.10);
  EXPECT_DOUBLE_EQ(verdict->best->forecast_rmse, 0.08);
  EXPECT_LT(verdict->best->rmse, verdict->forecast.score.rmse);
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
  EXPECT_EQ(judged(entries)->best->method, Method::day_mean);
  entries.push_back(entry_of(3, Method::provider, 0.01));
  const auto verdict = judged(entries);
  EXPECT_EQ(verdict->best->method, Method::provider) << "three of five are more than half";
  EXPECT_EQ(verdict->best->pairs, 3U);
  EXPECT_TRUE(verdict->is_beaten());
}

TEST(Verdict, WithinAPairABaselineIsHeldAgainstTheValuesThatBothHave) {
  // It lacks the deep levels, on which we are bad: over those that it has we are the better one.
  SkillEntry theirs = entry_of(1, Method::same_hour, 0.20);
  theirs.forecast_rmse = 0.15;
  const auto verdict = verdict_of({entry_of(1, Method::forecast, 0.30), theirs}, WindPolicy::best);
  EXPECT_EQ(verdict->outcome, Outcome::ahead);
  EXPECT_EQ(verdict->best->forecast_rmse, 0.15);
  EXPECT_EQ(verdict->forecast.score.rmse, 0.30) << "our own stands over all its values";
}

TEST(Verdict, ABaselineThatIsHeldAgainstNothingOfOursIsNoRival) {
  const auto verdict = verdict_of(
      {entry_of(1, Method::forecast, 0.3), entry_of(1, Method::same_hour, 0.1)}, WindPolicy::best);
  EXPECT_EQ(verdict->outcome, Outcome::alone);
}

TEST(Verdict, TwoForecastsOfOneDayAreOnePairAndTheFirstIssuedCounts) {
  std::vector<SkillEntry> entries =
      beside({entry_of(1, Method::forecast, 0.3), entry_of(1, Method::day_mean, 0.2),
              entry_of(2, Method::forecast, 0.3), entry_of(2, Method::day_mean, 0.2)});
  std::vector<SkillEntry> again =
      beside({entry_of(1, Method::forecast, 0.01), entry_of(1, Method::day_mean, 0.2)});
  for (SkillEntry& e : again) e.issued += std::chrono::days(3);
  entries.insert(entries.begin(), again.begin(), again.end());
  const auto verdict = verdict_of(entries, WindPolicy::best);
  EXPECT_EQ(verdict->forecast.score.pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->forecast.score.rmse, 0.3);
  EXPECT_EQ(verdict->best->pairs, 2U);
  EXPECT_DOUBLE_EQ(verdict->best->forecast_rmse, 0.3);
}

TEST(Verdict, IssuedForecastsAndHindcastsAreJudgedApartAndTheIssuedOnesFirst) {
  std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.3),
                                  entry_of(1, Method::day_mean, 0.2)};
  for (int day = 1; day <= 3; ++day) {
    entries.push_back(entry_of(day, Method::forecast, 0.1));
    entries.push_back(entry_of(day, Method::day_mean, 0.2));
    for (std::size_t i = entries.size() - 2; i < entries.size(); ++i)
      entries[i].origin = ForecastOrigin::hindcast;
  }
  entries = beside(entries);
  EXPECT_EQ(main_verdict(entries)->origin, ForecastOrigin::forecast) << "whatever the pairs";
  EXPECT_TRUE(main_verdict(entries)->is_beaten());
  const std::vector<Verdict> both = verdicts_of(entries);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].origin, ForecastOrigin::hindcast);
  EXPECT_EQ(both[1].forecast.score.pairs, 3U);
  EXPECT_EQ(both[1].outcome, Outcome::ahead);
}

/// Six days on which we are much better, then six of a hair worse: twelve independent days like
/// these would be enough for a verdict, two spells of weather are not.
TEST(Verdict, ARunOfDaysIsNoEvidenceOfManyDays) {
  std::vector<SkillEntry> entries;
  for (int day = 1; day <= 12; ++day) {
    entries.push_back(entry_of(day, Method::forecast, 0.30));
    entries.push_back(entry_of(day, Method::day_mean, day <= 6 ? 0.37 : 0.299));
  }
  EXPECT_EQ(judged(entries)->outcome, Outcome::tie);
}

TEST(Verdict, WindPoliciesAreNotMixed) {
  const std::vector<SkillEntry> entries{entry_of(1, Method::forecast, 0.1, WindPolicy::best),
                                        entry_of(1, Method::day_mean, 0.2, WindPolicy::best),
                                        entry_of(1, Method::forecast, 0.3, WindPolicy::persist),
                                        entry_of(1, Method::day_mean, 0.2, WindPolicy::persist)};
  const std::vector<Verdict> verdicts = verdicts_of(beside(entries));
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
}  // namespace slackwater::calibration::verdict_test

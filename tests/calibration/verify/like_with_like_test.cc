// Every error stands beside our own over the very same values, whatever a baseline lacks.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>

#include "calibration/verify/score_forecast.h"
#include "calibration/verify/skill_set.h"
#include "calibration/verify/verdict.h"
#include "tests/support/known_error_for_tests.h"

namespace slackwater::calibration::like_with_like_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using tests::KnownSeriesForTests;

const UtcDay first_day = parse_day("2024-06-01");
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> levels{0, 10, 20};

/// The water stands at 1 m/s east on D and turns to 1.2 m/s on every day after: persistence errs by
/// 0.2 m/s wherever it has a value.
double truth_m_s(UtcTime time, UtcDay day) { return time <= UtcTime(day) + days(1) ? 1.0 : 1.2; }

/// Our error: 0.1 m/s at the surface and at 10 m, 0.5 at 20 m.
double our_error_m_s(double depth_m) { return depth_m < 15 ? 0.1 : 0.5; }

/// A record of these days up to a day after D; the deepest level begins only after D.
KnownSeriesForTests record(UtcDay from, UtcDay day, bool deepest_known = false) {
  KnownSeriesForTests known;
  known.current(
      tests::analysis_of("currents"), tests::instants(UtcTime(from), UtcTime(day) + days(2)),
      levels, [=](UtcTime time, double depth_m) {
        const bool is_missing = !deepest_known && depth_m > 15 && time <= UtcTime(day) + days(1);
        return is_missing ? Horizontal(nan, nan) : Horizontal(truth_m_s(time, day), 0);
      });
  return known;
}

Snapshot our_forecast(const KnownSeriesForTests& known, UtcDay day, bool only_shallow = false) {
  return tests::forecast_of_known_error("site", day, UtcTime(day) + hours(29), known.data.point,
                                        levels, [=](UtcTime time, double depth_m) {
                                          if (only_shallow && depth_m > 15)
                                            return Horizontal(nan, nan);
                                          return Horizontal(
                                              truth_m_s(time, day) + our_error_m_s(depth_m), 0);
                                        });
}

std::vector<SkillEntry> skill_of(KnownSeriesForTests known, const Snapshot& snapshot) {
  std::vector<ColumnData> columns;
  columns.push_back(known.data);
  const SiteData data = tests::site_of(std::move(columns));
  VerifyOptions options;
  options.leads = {{0, 24}};
  return score_forecast(data, snapshot, {"currents"}, options).entries;
}

const SkillEntry* find(const std::vector<SkillEntry>& entries, Method method,
                       const DepthBand& band = {0, whole_column_m, false},
                       const LeadBin& lead = {0, 24}) {
  for (const SkillEntry& e : entries)
    if (e.method == method && e.band == band && e.lead == lead) return &e;
  return nullptr;
}

TEST(LikeWithLike, ABaselineThatLacksALevelIsHeldAgainstUsOnTheOthers) {
  auto known = record(first_day, first_day);
  const Snapshot ours = our_forecast(known, first_day);
  const auto entries = skill_of(std::move(known), ours);
  const SkillEntry* forecast = find(entries, Method::forecast);
  const SkillEntry* persistence = find(entries, Method::persistence);
  ASSERT_TRUE(forecast && persistence);
  EXPECT_EQ(forecast->vector.n, 72U) << "our own stands over all its values";
  EXPECT_NEAR(forecast->vector.rmse_m_s, std::sqrt((0.01 + 0.01 + 0.25) / 3), 1e-9);
  EXPECT_FALSE(forecast->forecast_rmse);
  EXPECT_EQ(persistence->vector.n, 48U);
  EXPECT_NEAR(persistence->vector.rmse_m_s, 0.2, 1e-9);
  ASSERT_TRUE(persistence->forecast_rmse);
  EXPECT_NEAR(*persistence->forecast_rmse, 0.1, 1e-9) << "not 0.3, which is over 20 m too";
  // Each hour of lead and each band alike.
  const SkillEntry* hour = find(entries, Method::persistence, {0, whole_column_m, false}, {5, 6});
  ASSERT_TRUE(hour && hour->forecast_rmse);
  EXPECT_NEAR(*hour->forecast_rmse, 0.1, 1e-9);
  EXPECT_FALSE(find(entries, Method::persistence, {20, 50, false})) << "it has nothing there";
  EXPECT_TRUE(find(entries, Method::forecast, {20, 50, false}));
  // And the verdict is by these: ahead, although 0.2 is less than our 0.3 over all levels.
  const auto verdict = verdict_of(entries, WindPolicy::best);
  EXPECT_GT(verdict->forecast.score.rmse, 0.25);
  ASSERT_TRUE(verdict->best);
  EXPECT_EQ(verdict->outcome, Outcome::ahead);
}

TEST(LikeWithLike, ValuesThatWeLackAreNoBaselinesMerit) {
  auto known = record(first_day, first_day, true);
  const Snapshot ours = our_forecast(known, first_day, true);
  const auto entries = skill_of(std::move(known), ours);
  const SkillEntry* persistence = find(entries, Method::persistence);
  ASSERT_TRUE(persistence);
  EXPECT_EQ(persistence->vector.n, 48U);
  EXPECT_EQ(persistence->vector.n, find(entries, Method::forecast)->vector.n);
  // Where we have nothing at all it stands alone, and says so.
  const SkillEntry* deep = find(entries, Method::persistence, {20, 50, false});
  ASSERT_TRUE(deep);
  EXPECT_EQ(deep->vector.n, 24U);
  EXPECT_FALSE(deep->forecast_rmse);
}

TEST(LikeWithLike, OverTheSameValuesOurErrorIsThatOfOurOwnRowToTheLastBit) {
  auto known = record(first_day, first_day, true);
  const Snapshot ours = our_forecast(known, first_day);
  const auto entries = skill_of(std::move(known), ours);
  std::size_t compared = 0;
  for (const SkillEntry& e : entries) {
    const SkillEntry* forecast = find(entries, Method::forecast, *e.band, e.lead);
    if (e.method == Method::forecast || e.vector.n != forecast->vector.n) continue;
    EXPECT_EQ(*e.forecast_rmse, forecast->vector.rmse_m_s) << name_of(e.method);
    ++compared;
  }
  EXPECT_GT(compared, 20U);
}

/// A record that begins twelve days before the first of four days D: tide-harmonic, which needs
/// fifteen, is there for the last two.
TEST(LikeWithLike, ABaselineOfSomeDaysHasItsOwnPairsAndOurErrorOverThem) {
  const std::vector<double> error_m_s{0.4, 0.4, 0.1, 0.2};
  std::vector<SkillEntry> entries;
  for (int i = 0; i < 4; ++i) {
    const UtcDay day = first_day + days(12 + i);
    KnownSeriesForTests known = record(first_day, day, true);
    const Snapshot ours = tests::forecast_of_known_error(
        "site", day, UtcTime(day) + hours(29), known.data.point, levels, [&](UtcTime time, double) {
          return Horizontal(truth_m_s(time, day) + error_m_s[static_cast<std::size_t>(i)], 0);
        });
    for (SkillEntry& e : skill_of(std::move(known), ours)) entries.push_back(std::move(e));
  }
  std::map<Method, SkillSet> sets;
  for (const SkillSet& set :
       sets_of(whole_current(entries, WindPolicy::best, ForecastOrigin::forecast)).sets)
    sets[set.of.method] = set;
  const SkillSet& ours = sets.at(Method::forecast);
  const SkillSet& tide = sets.at(Method::tide_harmonic);
  EXPECT_EQ(ours.score.pairs, 4U);
  EXPECT_EQ(tide.score.pairs, 2U);
  EXPECT_EQ(tide.first_day, first_day + days(14));
  EXPECT_NEAR(*tide.forecast_rmse, std::sqrt((0.01 + 0.04) / 2), 1e-9);
  EXPECT_NEAR(ours.score.rmse, std::sqrt((0.16 + 0.16 + 0.01 + 0.04) / 4), 1e-9);
  EXPECT_TRUE(is_part_of(tide, ours));
  EXPECT_FALSE(is_part_of(sets.at(Method::persistence), ours));
  EXPECT_DOUBLE_EQ(*sets.at(Method::persistence).forecast_rmse, ours.score.rmse);
}

TEST(SkillSets, ADayIsOnePairAndDaysOfABaselineAloneAreLeftOut) {
  const auto entry_of = [](int day, Method method, double rmse_m_s) {
    SkillEntry e;
    e.variable = current_variable;
    e.day = first_day + days(day);
    e.issued = UtcTime(e.day) + hours(29);
    e.method = method;
    e.band = DepthBand{0, whole_column_m, false};
    e.vector.n = 10;
    e.vector.rmse_m_s = rmse_m_s;
    return e;
  };
  SkillEntry again = entry_of(0, Method::forecast, 0.01);
  again.issued += days(4);
  SkillEntry lone = entry_of(1, Method::same_hour, 0.9);
  SkillEntry beside = entry_of(0, Method::same_hour, 0.4);
  beside.forecast_rmse = 0.3;
  const SkillSets sets = sets_of({again, entry_of(0, Method::forecast, 0.3), lone, beside});
  ASSERT_EQ(sets.sets.size(), 2U);
  EXPECT_EQ(sets.sets[0].score.pairs, 1U);
  EXPECT_EQ(sets.sets[0].score.rmse, 0.3) << "the one issued first";
  EXPECT_EQ(sets.sets[1].score.pairs, 1U);
  EXPECT_EQ(sets.sets[1].score.rmse, 0.4);
  EXPECT_EQ(sets.of_entry, (std::vector<std::size_t>{0, 0, 1, 1}));
}

}  // namespace
}  // namespace slackwater::calibration::like_with_like_test

#include "calibration/verify/skill_entry.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "api/show/report/skill_json.h"
#include "api/show/report/skill_table.h"
#include "calibration/verify/method_tallies.h"
#include "calibration/verify/skill_set.h"
#include "fields/base/error.h"

namespace slackwater::api::skill_entry_test {
namespace {

using calibration::Method;
using calibration::SkillEntry;
using nlohmann::json;
const UtcTime end_of_d = parse_utc("2024-06-02T00:00:00Z");

SkillEntry entry_of(const char* day, Method method, double rmse) {
  SkillEntry entry;
  entry.variable = calibration::current_variable;
  entry.site = "site";
  entry.day = parse_day(day);
  entry.method = method;
  entry.band = calibration::DepthBand{0, calibration::whole_column_m, false};
  entry.vector.n = 10;
  entry.vector.rmse_m_s = rmse;
  return entry;
}

TEST(DepthBand, NearTheBedIsCountedFromTheBed) {
  const calibration::DepthBand near_bed = calibration::standard_bands().back();
  ASSERT_TRUE(near_bed.above_bed);
  EXPECT_TRUE(calibration::holds(near_bed, 31, 35));
  EXPECT_TRUE(calibration::holds(near_bed, 30, 35));
  EXPECT_FALSE(calibration::holds(near_bed, 29.9, 35));
  EXPECT_FALSE(calibration::holds(near_bed, 31, 100));
  EXPECT_TRUE(calibration::holds(near_bed, 36, 35))
      << "a level below the bed's figure stands on the bed";
  EXPECT_TRUE(calibration::holds({5, 20, false}, 20, 35));
}

TEST(HourOfLead, TheInstantAtTheEndOfAnHourBelongsToIt) {
  using std::chrono::minutes;
  EXPECT_FALSE(calibration::hour_of_lead(end_of_d, end_of_d));
  EXPECT_EQ(calibration::hour_of_lead(end_of_d, end_of_d + minutes(1)), 0U);
  EXPECT_EQ(calibration::hour_of_lead(end_of_d, end_of_d + minutes(60)), 0U);
  EXPECT_EQ(calibration::hour_of_lead(end_of_d, end_of_d + minutes(61)), 1U);
  EXPECT_EQ(calibration::hour_of_lead(end_of_d, end_of_d + minutes(24 * 60)), 23U);
}

/// One method, one band, the error of each of 24 hours as given.
template <typename ErrorAt>
calibration::TalliesByMethod day_of(ErrorAt error_at) {
  calibration::MethodTallies tallies(1, 24);
  for (std::size_t h = 0; h < 24; ++h) {
    const double error = error_at(h);
    tallies.add(0, h, calibration::contribution_of({error, 0}, {0, 0}), error * error);
  }
  calibration::TalliesByMethod methods;
  methods.emplace(Method::forecast, tallies);
  return methods;
}

TEST(EntriesOf, AreTheLeadBinsAndEachHourOfTheFirstBand) {
  calibration::VerifyOptions options;
  options.leads = {{0, 24}};
  const auto entries = calibration::entries_of(
      day_of([](std::size_t h) { return 0.01 * static_cast<double>(h + 1); }),
      {{0, calibration::whole_column_m, false}}, options, SkillEntry{}, true);
  ASSERT_EQ(entries.size(), 25U);
  EXPECT_EQ(entries[0].vector.n, 24U);
  ASSERT_TRUE(entries[0].interval);
  EXPECT_LE(entries[0].interval->low, entries[0].vector.rmse_m_s);
  EXPECT_GE(entries[0].interval->high, entries[0].vector.rmse_m_s);
  for (std::size_t h = 0; h < 24; ++h) {
    EXPECT_EQ(entries[h + 1].lead.to_h, static_cast<double>(h + 1));
    EXPECT_NEAR(entries[h + 1].vector.rmse_m_s, 0.01 * static_cast<double>(h + 1), 1e-15);
  }
  options.by_hour = false;
  EXPECT_EQ(calibration::entries_of(day_of([](std::size_t) { return 0.1; }), {{0, 1, false}},
                                    options, SkillEntry{}, true)
                .size(),
            1U);
}

TEST(SkillJson, NamesTheBandByWhatItCountsAndCarriesTheSet) {
  auto first = entry_of("2024-06-01", Method::forecast, 0.3);
  auto second = entry_of("2024-06-02", Method::forecast, 0.4);
  auto bed = entry_of("2024-06-02", Method::forecast, 0.2);
  bed.band = calibration::DepthBand{0, 5, true};
  const json list = json::parse(skill_json({first, second, bed}));
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[0]["depth_m"], json::array({0.0, 1e5}));
  EXPECT_FALSE(list[0].contains("height_above_bed_m"));
  EXPECT_EQ(list[2]["height_above_bed_m"], json::array({0.0, 5.0}));
  EXPECT_FALSE(list[2].contains("depth_m"));
  EXPECT_EQ(list[0]["set"]["pairs"], 2);
  EXPECT_NEAR(list[0]["set"]["rmse_m_s"].get<double>(), std::sqrt(0.125), 1e-7);
  EXPECT_EQ(list[0]["set"], list[1]["set"]);
  EXPECT_EQ(list[2]["set"]["pairs"], 1);
  EXPECT_TRUE(list[2]["set"]["interval_95"].is_null());
}

TEST(SkillJson, CountsWavesInMetresUnderKeysThatSaySo) {
  SkillEntry waves;
  waves.variable = calibration::wave_variable;
  waves.day = parse_day("2024-06-01");
  waves.scalar = calibration::ScalarScore{10, 0.3, -0.1, 0.2, 0.15};
  SkillEntry next = waves;
  next.day = parse_day("2024-06-02");
  next.scalar->rmse = 0.4;
  const json list = json::parse(skill_json({waves, next}));
  EXPECT_EQ(list[0]["unit"], "m");
  EXPECT_EQ(list[0]["rmse"], 0.3);
  EXPECT_NEAR(list[0]["set"]["rmse"].get<double>(), std::sqrt(0.125), 1e-7);
  EXPECT_NEAR(list[0]["set"]["bias"].get<double>(), -0.1, 1e-7);
  EXPECT_EQ(list[0].dump().find("_m_s"), std::string::npos) << "a height is no speed";
  EXPECT_EQ(json::parse(skill_json({entry_of("2024-06-01", Method::forecast, 0.3)}))[0]["unit"],
            "m s-1");
}

TEST(SkillJson, CarriesOriginOurErrorOverTheSameValuesAndWhetherPairsAreFew) {
  std::vector<SkillEntry> entries;
  for (int day = 1; day <= 5; ++day) {
    auto ours = entry_of("2024-06-01", Method::forecast, 0.3);
    ours.day += std::chrono::days(day);
    entries.push_back(ours);
  }
  auto theirs = entries.back();
  theirs.method = Method::tide_harmonic;
  theirs.vector.rmse_m_s = 0.2;
  theirs.forecast_rmse = 0.1;
  entries.push_back(theirs);
  auto past = entries.front();
  past.origin = ForecastOrigin::hindcast;
  entries.push_back(past);
  const json list = json::parse(skill_json(entries));
  EXPECT_EQ(list[0]["origin"], "forecast");
  EXPECT_EQ(list[0]["set"]["pairs"], 5) << "a hindcast is of another set";
  EXPECT_EQ(list[0]["set"]["few"], false);
  EXPECT_TRUE(list[0]["set"]["interval_95"].is_array());
  EXPECT_TRUE(list[0]["forecast_rmse_m_s"].is_null());
  EXPECT_EQ(list[5]["forecast_rmse_m_s"], 0.1);
  EXPECT_EQ(list[5]["set"]["forecast_rmse_m_s"], 0.1);
  EXPECT_EQ(list[5]["set"]["few"], true);
  EXPECT_TRUE(list[5]["set"]["interval_95"].is_null());
  EXPECT_EQ(list[6]["origin"], "hindcast");
}

/// Our error of two days over two days, and that of a baseline on the calm one beside ours on it.
std::vector<SkillEntry> baseline_of_one_day_of_two() {
  auto calm = entry_of("2024-06-01", Method::forecast, 0.1);
  auto storm = entry_of("2024-06-02", Method::forecast, 0.5);
  auto theirs = entry_of("2024-06-01", Method::tide_harmonic, 0.2);
  theirs.forecast_rmse = 0.1;
  return {calm, storm, theirs};
}

TEST(SkillTable, ABaselineOfFewerDaysHasWhatWeHaveOnThemBeneathItAndIsNotFirst) {
  const auto entries = baseline_of_one_day_of_two();
  const std::string brief = short_skill_table(entries, WindPolicy::best);
  const auto forecast = brief.find("> forecast            2      0.361");
  const auto tide = brief.find("tide-harmonic       1      0.200");
  const auto there = brief.find("forecast there             0.100");
  ASSERT_NE(tide, std::string::npos) << brief;
  ASSERT_NE(forecast, std::string::npos) << brief;
  EXPECT_LT(forecast, tide) << "it has twice our error where it was made\n" << brief;
  EXPECT_LT(tide, there) << brief;
  EXPECT_NE(brief.find("few"), std::string::npos) << brief;
  const std::string full = skill_table(entries);
  EXPECT_LT(full.find("> forecast"), full.find("tide-harmonic       1")) << full;
  EXPECT_NE(full.find("0.2000   0.1000               few"), std::string::npos) << full;
}

TEST(SkillTable, AnHourOfABaselineOfFewerDaysHasOursBesideIt) {
  auto entries = baseline_of_one_day_of_two();
  for (SkillEntry& e : entries) e.lead = {3, 4};
  const std::string table = hourly_table(entries);
  EXPECT_NE(table.find("tide-harmonic forecast there"), std::string::npos) << table;
  EXPECT_NE(table.find("0.2000         0.1000"), std::string::npos) << table;
}

TEST(SkillTable, PutsTheBestFirstAndLeavesHoursToTheirOwnTable) {
  auto ours = entry_of("2024-06-01", Method::forecast, 0.3);
  auto better = entry_of("2024-06-01", Method::day_mean, 0.2);
  better.forecast_rmse = 0.3;
  auto hour = entry_of("2024-06-01", Method::forecast, 0.9);
  hour.lead = {3, 4};
  const std::string table = skill_table({ours, better, hour});
  EXPECT_LT(table.find("day-mean"), table.find("> forecast"));
  EXPECT_EQ(table.find("0.9000"), std::string::npos);
  EXPECT_NE(hourly_table({ours, better, hour}).find("0.9000"), std::string::npos);
}

TEST(ParseBands, RefusesWhatDoesNotAscend) {
  EXPECT_EQ(calibration::parse_bands("0,5,20").size(), 2U);
  for (const char* const text : {"5", "5,5", "20,5", "a,b", "0,5x", "-1,5"})
    EXPECT_THROW((void)calibration::parse_bands(text), Error) << text;
}

}  // namespace
}  // namespace slackwater::api::skill_entry_test

#include "api/show/report/verify_page.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "api/show/report/verdict_text.h"

namespace slackwater::api::verify_page_test {
namespace {

using calibration::Method;
using calibration::SkillEntry;
using nlohmann::json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SkillEntry entry(Method method, double rmse, const calibration::DepthBand& band, double lead_h) {
  SkillEntry e;
  e.variable = calibration::current_variable;
  e.site = "bay";
  e.day = parse_day("2025-03-09");
  e.issued = parse_utc("2025-03-10T05:00:00Z");
  e.band = band;
  e.lead = {lead_h - 24, lead_h};
  e.method = method;
  e.vector.n = 10;
  e.vector.rmse_m_s = rmse;
  if (method != Method::forecast) e.forecast_rmse = 0.1;
  e.truth = "PRODUCT";
  return e;
}

/// Scores in no order, and a trace on levels of which the last lies below the bed at 35 m.
calibration::Verification bay() {
  const calibration::DepthBand all{0, calibration::whole_column_m, false};
  const calibration::DepthBand top{0, 5, false};
  const calibration::DepthBand near_bed{0, 5, true};
  calibration::Verification v;
  for (const double lead_h : {48.0, 24.0}) {
    for (const auto& band : {near_bed, top, all}) {
      v.entries.push_back(entry(Method::persistence, 0.2, band, lead_h));
      v.entries.push_back(entry(Method::oracle_mean, 0.01, band, lead_h));
      v.entries.push_back(entry(Method::same_hour, 0.05, band, lead_h));
      v.entries.push_back(entry(Method::forecast, 0.1, band, lead_h));
    }
  }
  calibration::ForecastTrace trace;
  trace.day = parse_day("2025-03-09");
  trace.issued = parse_utc("2025-03-10T05:00:00Z");
  trace.point = GeoPoint::from_degrees(48.85, -2.55);
  trace.water_depth_m = 35;
  trace.time = {parse_utc("2025-03-10T01:00:00Z")};
  trace.depth_m = {0, 30, 60};
  trace.forecast_m_s = {{0.1, 0}, {0.1, 0}, {nan, nan}};
  trace.truth_m_s = {{0.2, 0}, {0.1, 0}, {nan, nan}};
  trace.misfit[{trace.time[0], 0}] = {0.01, 1};
  trace.misfit[{trace.time[0], 30}] = {0.04, 1};
  v.traces = {trace};
  return v;
}

SkillPage page_of_bay() {
  Site site;
  site.id = "bay";
  site.name = "Bay";
  site.point = GeoPoint::from_degrees(48.85, -2.55);
  return verify_page(site, bay(), "now");
}

TEST(VerifyPage, TablesGoDownByDepthAndLeadAndTheSmallestErrorComesFirst) {
  const ReportTable table = page_of_bay().tables.at(0);
  ASSERT_EQ(table.rows.size(), 24U);
  std::vector<std::string> bands;
  for (const auto& row : table.rows)
    if (bands.empty() || bands.back() != row[0]) bands.push_back(row[0]);
  EXPECT_EQ(bands, (std::vector<std::string>{"all depths", "0-5 m", "0-5 m above the bed"}));
  for (std::size_t block = 0; block < 6; ++block) {
    std::vector<std::string> methods;
    for (std::size_t i = 4 * block; i < 4 * block + 4; ++i) methods.push_back(table.rows[i][2]);
    EXPECT_EQ(methods,
              (std::vector<std::string>{"same-hour", "forecast", "persistence", "oracle-mean"}));
    EXPECT_EQ(table.rows[4 * block][1], block % 2 == 0 ? "0-24 h" : "24-48 h");
  }
  EXPECT_EQ(table.marked_rows, (std::vector<std::size_t>{1, 5, 9, 13, 17, 21}));
}

/// Fourteen columns were wider than the page, and the last four were cut off.
TEST(VerifyPage, NoTableIsWiderThanAPage) {
  for (const ReportTable& table : page_of_bay().tables) EXPECT_LE(table.columns.size(), 9U);
}

TEST(VerifyPage, TheMisfitIsDrawnDownToTheBedAndNoFarther) {
  const std::string html = skill_page_html(page_of_bay(), "/* library */");
  const std::string open = "id=\"report-data\">";
  const std::size_t from = html.find(open) + open.size();
  const json policy =
      json::parse(html.substr(from, html.find("</script>", from) - from)).at("policies").at(0);
  EXPECT_EQ(policy["tracks"][0]["bed"], 35);
  EXPECT_EQ(policy["tracks"][0]["depth"], (json{0, 30})) << "60 m is a level of the product alone";
  EXPECT_EQ(policy["tracks"][0]["misfit"], (json{0.1, 0.2}));
  EXPECT_EQ(policy["pooled"]["bed"], 35);
}

TEST(VerifyPage, TheFirstSentenceSaysHowItComparesWithItsBestBaseline) {
  const std::string headline = page_of_bay().headline;
  EXPECT_NE(headline.find("best baseline same-hour"), std::string::npos) << headline;
  EXPECT_NE(headline.find("The baseline was nearer, on too few days to say which is better."),
            std::string::npos)
      << headline;
}

TEST(VerifyPage, WhoIsBetterIsSaidFromFivePairsOn) {
  calibration::Verdict verdict;
  verdict.best = calibration::BestBaseline{calibration::Method::persistence, 5, 0.1, 0.2};
  verdict.outcome = calibration::Outcome::beaten;
  EXPECT_EQ(outcome_text(verdict), "THE FORECAST DOES NOT BEAT IT.");
  verdict.outcome = calibration::Outcome::ahead;
  EXPECT_EQ(outcome_text(verdict), "The forecast is better.");
  verdict.best->pairs = 4;
  EXPECT_EQ(outcome_text(verdict),
            "The forecast was nearer, on too few days to say which is better.");
}

TEST(VerifyPage, SaysOursBesideEachRowAndThatPairsAreFew) {
  const ReportTable table = page_of_bay().tables.at(0);
  ASSERT_EQ(table.columns.at(6), "Forecast there (m/s)");
  EXPECT_EQ(table.rows.at(0).at(6), "0.1000");
  EXPECT_EQ(table.rows.at(1).at(6), "") << "the forecast's own row";
  EXPECT_EQ(table.rows.at(0).at(5), "few");
  EXPECT_NE(page_of_bay().headline.find("1 pair of days (few: no interval)"), std::string::npos);
}

TEST(VerifyPage, ABaselineOfFewerDaysIsALineInPartWithOursBesideIt) {
  calibration::Verification v;
  const calibration::DepthBand all{0, calibration::whole_column_m, false};
  for (int day = 0; day < 2; ++day) {
    SkillEntry ours = entry(Method::forecast, day == 0 ? 0.1 : 0.5, all, 24);
    ours.lead = {3, 4};
    ours.day += std::chrono::days(day);
    v.entries.push_back(ours);
  }
  SkillEntry theirs = v.entries.front();
  theirs.method = Method::tide_harmonic;
  theirs.vector.rmse_m_s = 0.2;
  theirs.forecast_rmse = 0.1;
  v.entries.push_back(theirs);
  Site site;
  site.id = site.name = "bay";
  const SkillPage page = verify_page(site, v, "now");
  ASSERT_EQ(page.policies.size(), 1U);
  const auto& lines = page.policies[0].by_lead;
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0].method, "forecast");
  EXPECT_EQ(lines[1].method, "tide-harmonic (in part)");
  EXPECT_EQ(lines[2].method, "forecast beside tide-harmonic");
  EXPECT_EQ(lines[2].rmse_m_s, std::vector<double>{0.1});
}

TEST(VerifyPage, HindcastsStandApart) {
  calibration::Verification v = bay();
  for (SkillEntry e : bay().entries) {
    e.origin = ForecastOrigin::hindcast;
    v.entries.push_back(e);
  }
  Site site;
  site.id = site.name = "bay";
  const SkillPage page = verify_page(site, v, "now");
  ASSERT_EQ(page.policies.size(), 2U);
  EXPECT_EQ(page.policies[0].wind, "best");
  EXPECT_EQ(page.policies[1].wind, "best, hindcasts");
  EXPECT_TRUE(page.policies[1].tracks.empty()) << "the trace is of the forecast that was issued";
  EXPECT_EQ(page.tables.at(0).rows.size(), 24U);
}

TEST(VerifyPage, WestIsWest) { EXPECT_EQ(page_of_bay().site, "48.8500 N 2.5500 W"); }

}  // namespace
}  // namespace slackwater::api::verify_page_test

#include "api/show/report/skill_page.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "fields/base/check.h"

namespace slackwater::api::skill_page_test {
namespace {

using nlohmann::json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

SkillPage small_page() {
  SkillPage page;
  page.title = "Skill";
  page.headline = "Forecast 0.05 m/s.";
  SkillPolicy policy;
  policy.wind = "best";
  policy.by_lead = {{.method = "forecast",
                     .lead_h = {1, 2},
                     .rmse_m_s = {0.04, 0.06},
                     .low_m_s = {nan, 0.05},
                     .high_m_s = {nan, 0.07}}};
  policy.probability = {0.1, 0.5, 0.9};
  policy.below = {0.12, 0.5, 0.88};
  policy.pit = {0.5, 0.5};
  policy.pooled_lead_h = {1, 2};
  policy.pooled_depth_m = {0, 10};
  policy.pooled_misfit_m_s = {0.1, 0.2, nan, 0.4};
  SkillTrack track;
  track.label = "2024-06-01";
  track.time = {parse_utc("2024-06-02T01:00:00Z"), parse_utc("2024-06-02T02:00:00Z")};
  track.depth_m = {0, 10};
  track.misfit_m_s = {0.1, 0.2, nan, 0.4};
  track.drawn_depth_m = {0};
  track.forecast_m_s = {{0.1, 0.2}, {nan, nan}};
  track.truth_m_s = {{0.2, 0.1}, {0.3, 0}};
  policy.tracks = {track};
  page.policies = {policy};
  page.tables = {
      {.title = "Scores", .note = "", .columns = {"a"}, .rows = {{"1"}}, .highlighted_row = {}}};
  return page;
}

json data_of(const std::string& html) {
  const std::string mark = "id=\"report-data\">";
  const auto from = html.find(mark) + mark.size();
  return json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST(SkillPage, CarriesItsNumbersAndMissingOnesAreNull) {
  const json data = data_of(skill_page_html(small_page(), "/* library */"));
  const json& policy = data["policies"][0];
  EXPECT_EQ(policy["lines"][0]["rmse"], json::array({0.04, 0.06}));
  EXPECT_TRUE(policy["lines"][0]["low"][0].is_null());
  EXPECT_EQ(policy["below"][2], 0.88);
  EXPECT_TRUE(policy["tracks"][0]["misfit"][2].is_null());
  EXPECT_TRUE(policy["tracks"][0]["forecast"]["east"][1].is_null());
  EXPECT_EQ(policy["tracks"][0]["truth"]["east"][1], 0.3);
}

TEST(SkillPage, EveryPlotHasATitleAndEveryChoiceALabel) {
  const std::string html = skill_page_html(small_page(), "/* library */");
  for (const char* const id :
       {"skill-by-lead", "reliability", "pit", "hodograph-0", "misfit", "pooled-misfit"}) {
    const auto at = html.find("<div id=\"" + std::string(id) + "\"");
    ASSERT_NE(at, std::string::npos) << id;
    EXPECT_NE(html.substr(at, 120).find("aria-label=\""), std::string::npos) << id;
  }
  for (const char* const id : {"policy", "track"})
    EXPECT_NE(html.find("<label for=\"" + std::string(id) + "\">"), std::string::npos) << id;
}

TEST(SkillPage, SaysInBoldThatABaselineIsBetter) {
  SkillPage page = small_page();
  EXPECT_EQ(skill_page_html(page, "x").find("does not beat"), std::string::npos);
  page.beaten = true;
  EXPECT_NE(skill_page_html(page, "x").find("<strong>The forecast does not beat"),
            std::string::npos);
}

TEST(SkillPage, TextFromOutsideNeverBecomesMarkup) {
  SkillPage page = small_page();
  const std::string evil = "</script><img src=x onerror=\"alert('1')\">&";
  page.title = page.site = page.headline = page.place = evil;
  page.policies[0].wind = page.policies[0].tracks[0].label = evil;
  page.policies[0].by_lead[0].method = evil;
  const std::string html = skill_page_html(page, "/* library */");
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(data_of(html)["policies"][0]["wind"], evil);
}

TEST(SkillPage, WithoutThePlottingLibraryTheTablesStand) {
  const std::string html = skill_page_html(small_page(), "");
  EXPECT_NE(html.find("This page has no plots"), std::string::npos);
  EXPECT_NE(html.find("<h2>Scores</h2>"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(SkillPage, ArraysThatDoNotFitAreABug) {
  SkillPage page = small_page();
  page.policies[0].tracks[0].misfit_m_s.pop_back();
  EXPECT_THROW((void)skill_page_html(page, "x"), ContractViolation);
  page = small_page();
  page.policies[0].by_lead[0].low_m_s.clear();
  EXPECT_THROW((void)skill_page_html(page, "x"), ContractViolation);
}

}  // namespace
}  // namespace slackwater::api::skill_page_test

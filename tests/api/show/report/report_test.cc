#include "api/show/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "api/show/report/assets.h"
#include "api/show/report/plot_data.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::report_test {
namespace {

using nlohmann::json;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ReportInput small_report() {
  ReportInput input;
  input.title = "Current forecast";
  input.headline = "Slack at 06:10.";
  const UtcTime start = parse_utc("2025-03-10T00:00:00Z");
  input.profile =
      ReportProfile{.time = {start, start + std::chrono::hours{1}},
                    .depth_m = {0, 10, 30},
                    .water_depth_m = 35,
                    .current_m_s = {{0.3, 0}, {0.2, 0}, {0.1, 0}, {0, 0.3}, {0, 0.2}, {nan, nan}},
                    .sigma_m_s = {},
                    .truth_m_s = {},
                    .hodograph_time = start};
  input.skill = {
      {.method = "forecast",
       .lead = "0-24 h",
       .rmse_m_s = 0.05,
       .interval_95_m_s = std::pair{0.04, 0.06}},
      {.method = "persistence", .lead = "0-24 h", .rmse_m_s = 0.2, .interval_95_m_s = {}}};
  input.tables = {{.title = "Skill",
                   .note = "",
                   .columns = {"method", "RMSE (m/s)"},
                   .rows = {{"forecast", "0.050"}},
                   .highlighted_row = {}}};
  return input;
}

/// The JSON that the page's script reads.
json data_of(const ReportInput& input) { return json::parse(plot_data_json(input)); }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Report, TextFromOutsideNeverBecomesMarkup) {
  ReportInput input = small_report();
  const std::string evil = "</script><img src=x onerror=\"alert('1')\">&";
  input.title = input.site = input.headline = input.skill_note = input.generated = evil;
  input.facts = {{evil, evil}};
  input.attributions = {evil};
  input.tables[0] = {
      .title = evil, .note = evil, .columns = {evil}, .rows = {{evil}}, .highlighted_row = {}};
  input.skill[0].method = evil;
  input.skill[0].lead = evil;
  const std::string html = report_html(input, "/* library */");
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(count(html, "</script>"), 3U);                // data, library, page script
  EXPECT_EQ(data_of(input)["skill"][0]["method"], evil);  // and yet it arrives whole
}

TEST(Report, BytesThatAreNotUtf8DoNotStopThePage) {
  ReportInput input = small_report();
  input.skill[0].method = "caf\xe9";
  EXPECT_NO_THROW((void)report_html(input, "/* library */"));
}

TEST(Report, OpensWithoutANetwork) {
  const std::string html = report_html(small_report());
  for (const char* fetches : {"<link", "src=\"http", "<script src", "@import", "url(http"}) {
    EXPECT_EQ(html.substr(0, 20000).find(fetches), std::string::npos) << fetches;
  }
  EXPECT_NE(html.find("id=\"report-data\""), std::string::npos);
}

TEST(Report, WithoutThePlottingLibraryItSaysSoAndShowsTheNumbers) {
  const std::string html = report_html(small_report(), "");
  EXPECT_NE(html.find("This page has no plots"), std::string::npos);
  EXPECT_NE(html.find("0.30 to 090"), std::string::npos);  // flows east at the surface
  EXPECT_NE(html.find("0.050"), std::string::npos);
  EXPECT_EQ(html.find("<script"), std::string::npos);
}

TEST(Report, MissingValuesAreNullAndNeverZero) {
  const json data = data_of(small_report());
  EXPECT_TRUE(data["profile"]["current"]["east"][5].is_null());
  EXPECT_EQ(data["profile"]["current"]["north"][3], 0.3);
  const std::string html = report_html(small_report(), "");
  EXPECT_EQ(html.find("nan"), std::string::npos);
}

TEST(Report, DepthMeanIsTheTrapezoidOverTheLevelsThatHaveValues) {
  const json mean = data_of(small_report())["profile"]["mean"];
  EXPECT_NEAR(mean["east"][0].get<double>(), (10 * 0.25 + 20 * 0.15) / 30, 1e-4);
  EXPECT_NEAR(mean["north"][1].get<double>(), 0.25, 1e-4);  // 30 m has none
}

TEST(Report, DegradedIsSaidInWords) {
  ReportInput input = small_report();
  EXPECT_EQ(report_html(input, "x").find("Degraded forecast."), std::string::npos);
  input.degraded = true;
  EXPECT_NE(report_html(input, "x").find("Degraded forecast."), std::string::npos);
}

TEST(Report, ArraysThatDoNotFitAreABug) {
  ReportInput input = small_report();
  input.profile->current_m_s.pop_back();
  EXPECT_THROW((void)report_html(input), ContractViolation);
  input = small_report();
  input.series_time = input.profile->time;
  input.series = {{.title = "Wind",
                   .axis = "speed (m/s)",
                   .lines = {{.name = "forecast", .values = {1}, .low = {}, .high = {}}},
                   .towards_deg = {}}};
  EXPECT_THROW((void)report_html(input), ContractViolation);
  input = small_report();
  input.tables[0].rows = {{"one cell"}};
  EXPECT_THROW((void)report_html(input), ContractViolation);
}

TEST(Report, IsWrittenWholeOrRefusedWithTheFileNamed) {
  const tests::TemporaryFolder folder;
  const auto file = folder / "out/report.html";
  write_report(small_report(), file);
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  EXPECT_EQ(text.str(), report_html(small_report()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "out"),
                          std::filesystem::directory_iterator()),
            1);
  try {
    write_report(small_report(), file / "below_a_file.html");
    FAIL() << "a file cannot be a folder";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unavailable);
    EXPECT_NE(error.message().find("below_a_file.html"), std::string::npos);
  }
}

TEST(ReportAssets, AreThoseOfTheTree) {
  EXPECT_NE(report_common_script().find("report-data"), std::string_view::npos);
  EXPECT_NE(report_style().find("var(--rule)"), std::string_view::npos);
  // No script element may be closed from inside.
  for (const std::string_view script : {report_common_script(), report_script(), skill_script()}) {
    EXPECT_EQ(script.find("</script"), std::string_view::npos);
    EXPECT_FALSE(script.empty());
  }
  EXPECT_EQ(report_plotting_library().find("</script"), std::string_view::npos);
}

}  // namespace
}  // namespace slackwater::api::report_test

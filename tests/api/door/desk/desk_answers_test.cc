// What `serve` answers about a site is what the commands answer, to the last number.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/api/door/desk/desk_served.h"
#include "tests/support/contains.h"

namespace slackwater::tests::desk_answers_test {
namespace {

using nlohmann::json;

class DeskAnswers : public DeskServed {};

/// What tells when it was asked, to the millisecond, or where a page of its own lies.
json without(json answer, std::initializer_list<const char*> keys) {
  for (const char* key : keys) answer.erase(key);
  return answer;
}

TEST_F(DeskAnswers, WindowsAreThoseOfTheCommand) {
  EXPECT_EQ(got("/sites/farm/windows"), told({"windows", "--site", "farm"}));
  EXPECT_EQ(
      got("/sites/farm/windows?task=cp_anode&turbine=T1&every=1h&contingency=15min&shift="
          "06:00-18:00&timezone=Europe/Paris&members=3&waves=forecast&go=0.8&marginal=0.4"),
      told({"windows",     "--site",     "farm",         "--task",        "cp_anode", "--turbine",
            "T1",          "--every",    "1h",           "--contingency", "15min",    "--shift",
            "06:00-18:00", "--timezone", "Europe/Paris", "--members",     "3",        "--waves",
            "forecast",    "--go",       "0.8",          "--marginal",    "0.4"}));
  const json two = got("/sites/farm/windows?task=cp_anode,scour_survey");
  EXPECT_EQ(two.at("tasks").size(), 2U);
  EXPECT_EQ(two, got("/sites/farm/windows?task=cp_anode&task=scour_survey"));
}

TEST_F(DeskAnswers, TheReportIsThatOfTheCommand) {
  const json report = got("/sites/farm/report?day=2025-03-03");
  EXPECT_EQ(report, without(told({"report", "--site", "farm", "--day", "2025-03-03", "--html",
                                  path("report.html")}),
                            {"page"}));
  EXPECT_EQ(report.at("schema"), "morning/1");
  EXPECT_FALSE(report.at("plan").is_null());
  const json now = got("/sites/farm/report");
  ASSERT_FALSE(now.at("today").is_null()) << "the hours that are left of the day of the issue";
  EXPECT_EQ(now.at("today").at("from"), "2025-03-04T06:30:00Z") << "the server's clock shows 06:10";
}

TEST_F(DeskAnswers, ThePageOfTheReportIsTheOneThatWasMadeLast) {
  const std::filesystem::path folder = made_->store() / "reports" / "farm";
  const std::string address = "/sites/farm/report.html";
  const HttpReply page = reply(address);
  ASSERT_EQ(page.status, 200) << page.body;
  EXPECT_EQ(page.body, read_bytes(folder / "2025-03-05.html"))
      << "of the day after the last issue, not of the one before";
  EXPECT_TRUE(contains(page.field("content-type"), "text/html"));
  EXPECT_TRUE(contains(page.field("content-security-policy"), "default-src 'none'"));
  std::ofstream(folder / "2025-03-05_1200.html") << "issued again at noon";
  std::ofstream(folder / "2025-03-06.html") << "of a day that this clock has not come to";
  std::ofstream(folder / "2025-03-07.pdf") << "no page";
  EXPECT_EQ(reply(address).body, "issued again at noon");
  for (const char* name : {"2025-03-05_1200.html", "2025-03-06.html", "2025-03-07.pdf"})
    std::filesystem::remove(folder / name);
  const json sites = got("/sites").at("sites");
  EXPECT_EQ(sites[0].at("report_page"), address);
  EXPECT_EQ(sites[1].at("report_page"), nullptr);
  EXPECT_EQ(reply("/sites/bare/report.html").status, 404);
  EXPECT_EQ(reply("/sites/..%2Ffarm/report.html").status, 400);
}

TEST_F(DeskAnswers, PlanSkillSourcesAndDecisionsAreThoseOfTheCommands) {
  EXPECT_EQ(
      got("/sites/farm/plan?time-limit=20"),
      told({"plan", (made_->store() / "plans" / "farm.yaml").string(), "--time-limit", "20"}));
  EXPECT_EQ(got("/sites/farm/verification"), told({"verify", "--site", "farm"}));
  EXPECT_GT(got("/sites/farm/verification").size(), 10U);
  EXPECT_EQ(without(got("/sites/farm/sources?day=2025-03-03"), {"issued"}),
            without(told({"site", "sources", "farm", "--day", "2025-03-03", "--at",
                          "2025-03-04T06:10:00Z"}),
                    {"issued"}));
  EXPECT_EQ(
      without(got("/sites/farm/decisions"), {"known_by"}),
      without(told({"decisions", "--site", "farm", "--at", "2025-03-04T06:10:00Z"}), {"known_by"}));
}

TEST_F(DeskAnswers, ThePastIsThatOfTheCommands) {
  EXPECT_EQ(
      got("/sites/farm/workability?limit=sea_water_speed%3C%3D0.3&duration=2h&depth=5&start-hours="
          "6-18"),
      told({"workability", "--site", "farm", "--limit", "sea_water_speed<=0.3", "--duration", "2h",
            "--depth", "5", "--start-hours", "6-18"}));
  EXPECT_EQ(got("/sites/farm/climate?what=roses&of=current&sectors=8&depth=5"),
            told({"climate", "--site", "farm", "--roses", "--of", "current", "--sectors", "8",
                  "--depth", "5"}));
}

TEST_F(DeskAnswers, SlackIsWhereTheCurrentIsSlow) {
  const json told = got("/sites/farm/slack?depth=5&below=0.1");
  ASSERT_FALSE(told.at("slack").empty()) << told;
  const json& first = told.at("slack").at(0);
  const std::string from = first.at("from"), to = first.at("to");
  EXPECT_LT(from, to);
  const json series =
      got("/collections/currents/locations/farm?z=5&f=CoverageJSON&datetime=" + from + "/" + to);
  const json& speeds = series.at("ranges").at("sea_water_speed").at("values");
  for (const json& speed : speeds) EXPECT_LT(speed.get<double>(), 0.1) << "likely below 0.1 m/s";
  EXPECT_GE(got("/sites/farm/slack?below=9&depth=5").at("slack").size(), 1U);
  EXPECT_EQ(got("/sites/farm/slack?below=9&depth=5").at("slack").at(0).at("ends_after"), true);
}

TEST_F(DeskAnswers, SitesSayHowTheirForecastsAre) {
  const json all = got("/sites");
  EXPECT_EQ(all.at("now").get<std::string>().substr(0, 14), "2025-03-04T06:") << "as --at said";
  ASSERT_EQ(all.at("sites").size(), 2U) << all;
  const json& farm = all.at("sites")[0];
  EXPECT_EQ(farm.at("id"), "farm");
  EXPECT_EQ(farm.at("status"), "degraded") << "nobody forecast its wind: " << farm;
  EXPECT_EQ(farm.at("forecast").at("issued"), "2025-03-04T05:00:00Z");
  const json& bare = all.at("sites")[1];
  EXPECT_EQ(bare.at("status"), "no_forecast");
  EXPECT_TRUE(contains(bare.at("in_words").get<std::string>(), "slackwater forecast --site"));
}

TEST_F(DeskAnswers, ADescriptionThatCannotBeReadIsToldAndTheForecastAnswers) {
  const std::filesystem::path file = made_->store() / "sites" / "farm.yaml";
  const std::string yaml = read_bytes(file);
  std::ofstream(file) << yaml << "no_such_key: 1\n";
  const json farm = got("/sites/farm");
  EXPECT_TRUE(contains(farm.at("trouble").get<std::string>(), "no_such_key")) << farm;
  EXPECT_FALSE(farm.at("columns").empty());
  const json line = got("/sites").at("sites").at(0);
  EXPECT_TRUE(contains(line.at("in_words").get<std::string>(), "cannot be read")) << line;
  std::ofstream(file) << yaml;
  EXPECT_EQ(got("/sites/farm").at("trouble"), "");
}

TEST_F(DeskAnswers, ASiteSaysWhatLiesThere) {
  const json farm = got("/sites/farm");
  EXPECT_EQ(farm.at("turbines").at(0).at("id"), "T1");
  EXPECT_EQ(farm.at("turbines").at(0).at("foundation"), "monopile");
  EXPECT_EQ(farm.at("tasks").at(0).at("id"), "scour_survey");
  EXPECT_NE(farm.at("tasks").at(0).at("name"), "scour_survey") << "the sheet has a name for people";
  ASSERT_FALSE(farm.at("columns").empty());
  const std::string location = farm.at("columns").at(0).at("location");
  EXPECT_EQ(reply("/collections/currents/locations/" + location).status, 200);
  EXPECT_EQ(got("/sites/bare").at("forecast"), nullptr);
}

TEST_F(DeskAnswers, ASiteSaysItsChartDatumOrThatItStatesNone) {
  EXPECT_EQ(got("/sites/farm").at("chart_datum"), nullptr);
  const std::filesystem::path file = made_->store() / "sites" / "farm.yaml";
  const std::string yaml = read_bytes(file);
  std::ofstream(file)
      << yaml << "chart_datum: {name: LAT, below_mean_sea_level_m: 5.93, source: a chart}\n";
  EXPECT_EQ(got("/sites/farm").at("chart_datum"),
            json({{"name", "LAT"}, {"below_mean_sea_level_m", 5.93}, {"source", "a chart"}}));
  std::ofstream(file) << yaml;
}

TEST_F(DeskAnswers, ASiteSaysTheNamedPortsOfItsPlan) {
  EXPECT_EQ(got("/sites/farm").at("ports"), json::array()) << "its plan names none";
  const std::filesystem::path file = made_->store() / "plans" / "farm.yaml";
  const std::string plan = read_bytes(file);
  const std::string vessel = "  - {id: ctv1, crews: 1, speed_kn: 20, hours: 00:00-24:00";
  const std::string at = ", port: {name: Emden, latitude_deg: 53.34, longitude_deg: 7.19}}\n";
  std::string with_port = plan;
  with_port.replace(with_port.find(vessel) + vessel.size(), 2,
                    at + "  - {id: ctv2, crews: 1, speed_kn: 20, hours: 00:00-24:00" + at);
  std::ofstream(file) << with_port;
  const json ports = got("/sites/farm").at("ports");
  ASSERT_EQ(ports.size(), 1U) << "of two vessels once: " << ports;
  EXPECT_EQ(ports[0].at("name"), "Emden");
  EXPECT_NEAR(ports[0].at("latitude_deg").get<double>(), 53.34, 1e-12);
  EXPECT_NEAR(ports[0].at("longitude_deg").get<double>(), 7.19, 1e-12);
  std::ofstream(file) << "no plan: [";
  EXPECT_EQ(got("/sites/farm").at("ports"), json::array());
  std::ofstream(file) << plan;
  EXPECT_EQ(got("/sites/bare").at("ports"), json::array());
}

TEST_F(DeskAnswers, AnAnswerIsKeptUntilTheStoreChanges) {
  const HttpReply first = reply("/sites/farm/windows");
  const std::string tag = first.field("etag");
  ASSERT_FALSE(tag.empty());
  EXPECT_EQ(reply("/sites/farm/windows", "If-None-Match: " + tag + "\r\n").status, 304);
  const std::string plan = read_bytes(made_->store() / "plans" / "farm.yaml");
  const json before = got("/sites/farm/plan");
  std::ofstream(made_->store() / "plans" / "farm.yaml") << plan << "# another line\n";
  EXPECT_EQ(got("/sites/farm/plan"), before);
  std::ofstream(made_->store() / "plans" / "farm.yaml") << "name: Renamed\n"
                                                        << plan.substr(plan.find('\n') + 1);
  EXPECT_TRUE(contains(got("/sites/farm/plan").dump(), "Renamed"));
  std::ofstream(made_->store() / "plans" / "farm.yaml") << plan;
}

struct Refusal {
  const char* target;
  int status;
  const char* words;
};

TEST_F(DeskAnswers, WhatCannotBeAnsweredIsRefusedInOneSentence) {
  for (const Refusal& wrong : {
           Refusal{"/sites/nowhere", 404, "nowhere"},
           Refusal{"/sites/nowhere/windows", 404, "nowhere"},
           Refusal{"/sites/bare/windows", 400, "site bare lists none"},
           Refusal{"/sites/bare/windows?task=cp_anode", 404, "bare"},
           Refusal{"/sites/bare/plan", 404, "expected one in the store's plans/bare.yaml"},
           Refusal{"/sites/farm%2Eyaml/windows", 404, "farm.yaml"},
           Refusal{"/sites/farm/windows?task=/etc/passwd", 400, "expected an id"},
           Refusal{"/sites/farm/windows?task=..", 400, "expected an id"},
           Refusal{"/sites/farm/windows?task=no_such_task", 404, "no_such_task"},
           Refusal{"/sites/farm/windows?forecast=/tmp/x.nc", 400, "found 'forecast'"},
           Refusal{"/sites/farm/windows?alpha=/tmp/x.yaml", 400, "found 'alpha'"},
           Refusal{"/sites/farm/windows?every=0min", 400, "every: found 0min"},
           Refusal{"/sites/farm/windows?every=1h&every=2h", 400, "expected it once"},
           Refusal{"/sites/farm/windows?from=tomorrow", 400, "from: "},
           Refusal{"/sites/farm/windows?members=many", 400, "members: found 'many'"},
           Refusal{"/sites/farm/windows?members=1e9", 400, "from 1 to 1000"},
           Refusal{"/sites/farm/windows?members=2.5", 400, "a whole number"},
           Refusal{"/sites/farm/windows?waves=high", 400, "error or forecast"},
           Refusal{"/sites/farm/windows?go=0.3&marginal=0.6", 400, "found marginal above go"},
           Refusal{"/sites/farm/windows?shift=", 400, "shift"},
           Refusal{"/sites/farm/windows?task=a,,b", 400, "commas"},
           Refusal{"/sites/farm/report?day=2031-01-01", 404, "2031-01-01"},
           Refusal{"/sites/farm/plan?chance=2", 400, "from 0 to 1"},
           Refusal{"/sites/farm/verification?from=then", 400, "from: "},
           Refusal{"/sites/farm/sources?horizon=1min", 400, "expected 1h to 15d"},
           Refusal{"/sites/farm/sources?wind=strong", 400, "wind: "},
           Refusal{"/sites/farm/workability?duration=2h", 400, "limit"},
           Refusal{"/sites/farm/workability?limit=sea_water_speed%3C%3D0.3", 400, "duration"},
           Refusal{"/sites/farm/workability?limit=x.yaml&duration=2h", 400, "limit: "},
           Refusal{"/sites/farm/climate?of=rain", 400, "of: "},
           Refusal{"/sites/farm/climate?what=hopes", 400, "roses, scatter or extremes"},
           Refusal{"/sites/farm/climate?return-period=0", 400, "from 0.1 to"},
           Refusal{"/sites/nowhere/slack", 404, "GET /sites"},
           Refusal{"/sites/farm/slack?depth=5000", 404, "a smaller depth"},
           Refusal{"/sites/farm/slack?longitude=10&latitude=10", 404, "nearer to a column"},
           Refusal{"/sites/farm/slack?longitude=10", 400, "latitude"},
           Refusal{"/sites/farm/slack?below=0", 400, "from 0.01"},
           Refusal{"/missions/0123456789abcdef", 404, "GET /missions"},
       }) {
    const HttpReply no = reply(wrong.target);
    EXPECT_EQ(no.status, wrong.status) << wrong.target << "\n" << no.body;
    EXPECT_EQ(no.field("content-type"), "application/problem+json") << wrong.target;
    EXPECT_TRUE(contains(no.body, wrong.words)) << wrong.target << "\n" << no.body;
    EXPECT_FALSE(contains(no.body, made_->store().string())) << wrong.target << "\n" << no.body;
  }
}

}  // namespace
}  // namespace slackwater::tests::desk_answers_test

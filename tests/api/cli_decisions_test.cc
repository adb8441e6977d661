// `slackwater decide` and `slackwater decisions`: who decided what on which forecast, and what
// came, on a sea that is a formula.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/support/contains.h"
#include "tests/support/farm_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_decisions_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

/// The survey of scour, of its limits that on the waves alone.
std::string waves_sheet() {
  std::istringstream lines(read_bytes(source_folder() / "data/tasks/scour_survey.yaml"));
  std::string sheet, line;
  while (std::getline(lines, line))
    if (line.find("        - {current_speed") == std::string::npos &&
        line.find("        - {wind_speed") == std::string::npos &&
        line.find("        - {least_water") == std::string::npos)
      sheet += line + "\n";
  return sheet;
}

/// Six days of products, whose last hour is 23:00 on 6 March; forecasts issued at 05:00 on the 4th
/// and on the 5th, for three days each. Decisions are of the 5th and the 6th.
class DecisionsCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<StoreForTests>();
    made_->ingest_days(parse_day("2025-03-01"), 6);
    made_->write("farm.yaml", farm_at_the_site(*made_));
    made_->write("waves.yaml", waves_sheet());
    for (const char* day : {"2025-03-03", "2025-03-04"}) {
      const UtcTime issued = UtcTime(parse_day(day)) + std::chrono::hours(29);
      const ProgramResult made =
          made_->run({"forecast", "--site", farm(), "--day", day, "--at", format_utc(issued)});
      ASSERT_EQ(made.exit_code, 0) << made.err;
    }
    const ProgramResult said = made_->run(
        {"windows", "--site", farm(), "--task", task(), "--day", "2025-03-04", "--json"});
    ASSERT_EQ(said.exit_code, 0) << said.err;
    windows_ = json::parse(said.out);
    const json& of = windows_.at("tasks")[0];
    work_ = std::chrono::round<Duration>(std::chrono::duration<double, std::ratio<3600>>(
        of.at("duration_h").get<double>() + of.at("contingency_h").get<double>()));
    std::filesystem::copy(made_->store(), made_->file("undecided"),
                          std::filesystem::copy_options::recursive);
  }
  static void TearDownTestSuite() { made_.reset(); }
  /// Each test begins where nothing was decided.
  void SetUp() override {
    ASSERT_GT(work_.count(), 0);
    std::filesystem::remove_all(made_->store());
    std::filesystem::copy(made_->file("undecided"), made_->store(),
                          std::filesystem::copy_options::recursive);
  }

  static std::string farm() { return made_->path("farm.yaml"); }
  static std::string task() { return made_->path("waves.yaml"); }
  static ProgramResult run(Arguments arguments) { return made_->run(arguments); }

  static ProgramResult decide(const std::string& start, const std::string& what, Arguments more) {
    Arguments arguments{"decide", "--site", farm(), "--start", start, what};
    if (std::find(more.begin(), more.end(), "--task") == more.end())
      more.insert(more.end(), {"--task", task()});
    if (std::find(more.begin(), more.end(), "--by") == more.end())
      more.insert(more.end(), {"--by", "A. Name"});
    if (std::find(more.begin(), more.end(), "--at") == more.end())
      more.insert(more.end(), {"--at", "2025-03-05T05:30:00Z"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  static json decided(UtcTime start, const std::string& what, Arguments more = {}) {
    more.emplace_back("--json");
    const ProgramResult made = decide(format_utc(start), what, std::move(more));
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return json::accept(made.out) ? json::parse(made.out) : json();
  }
  static json decisions(Arguments more = {}) {
    Arguments arguments{"decisions", "--site", farm(), "--json"};
    if (std::find(more.begin(), more.end(), "--at") == more.end())
      more.insert(more.end(), {"--at", "2025-03-20T00:00:00Z"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult told = run(arguments);
    EXPECT_EQ(told.exit_code, 0) << told.err;
    return json::accept(told.out) ? json::parse(told.out) : json();
  }
  static json with_id(const json& answer, const json& id) {
    for (const json& one : answer.at("decisions"))
      if (one.at("id") == id) return one;
    ADD_FAILURE() << "no decision " << id;
    return {};
  }

  /// The highest waves from a start to the end of its work, by the formula.
  static double highest_m(UtcTime start) {
    double most_m = 0;
    for (UtcTime time = start; time <= start + work_; time += std::chrono::minutes(5))
      most_m = std::max(
          most_m, WaterForTests::significant_height_m({time, 0, WaterForTests::site_latitude_deg,
                                                       WaterForTests::site_longitude_deg}));
    return most_m;
  }
  /// Starts from 06:00 on, each half hour: on the 5th all work ends below 1.46 m, on the 6th all of
  /// it is in more than 1.54 m.
  static UtcTime holding(int nth) { return start_on("2025-03-05", nth); }
  static UtcTime breaking(int nth) { return start_on("2025-03-06", nth); }
  static UtcTime start_on(const char* day, int nth) {
    return UtcTime(parse_day(day)) + std::chrono::hours(6) + nth * std::chrono::minutes(30);
  }

  inline static std::unique_ptr<StoreForTests> made_;
  inline static json windows_;
  inline static Duration work_{0};
};

/// Looked back on, when she could leave port is no question; whether she had the sea for it is.
TEST_F(DecisionsCommand, OfASiteWithAVesselAreHeldAgainstHerWaysToo) {
  const UtcTime start = parse_utc("2025-03-05T05:30:00Z");
  ASSERT_LT(highest_m(start), 1.46);
  const json made = decided(start, "--go");
  const auto came_with = [&](const std::string& height_m) {
    made_->write("boat.yaml", "name: Boat\ntransfer: 15min\nlimits: [{significant_wave_height_m: " +
                                  height_m + "}]\n");
    made_->write("brought.yaml",
                 farm_at_the_site(*made_, "access: {vessel: " + made_->path("boat.yaml") +
                                              ", passage: 60min}\n"));
    const ProgramResult told = run({"decisions", "--site", made_->path("brought.yaml"), "--json",
                                    "--at", "2025-03-20T00:00:00Z"});
    EXPECT_EQ(told.exit_code, 0) << told.err;
    return with_id(json::parse(told.out), made.at("id"));
  };
  EXPECT_EQ(came_with("19").at("came").at("outcome"), "held") << "she left before the issue";
  const json rough = came_with("0.1").at("came");
  EXPECT_EQ(rough.at("outcome"), "did_not_hold");
  EXPECT_EQ(rough.at("broken"), "significant wave height at most 0.1 m (Boat)");
  EXPECT_LT(rough.at("broken_at"), "2025-03-05T05:00:00Z") << "on her way out";
}

TEST_F(DecisionsCommand, SayWhatCameAsTheFormulaOfTheSeaDoes) {
  std::vector<std::pair<json, bool>> asked;
  for (const int nth : {0, 14})
    for (const char* what : {"--go", "--no-go"}) {
      ASSERT_LT(highest_m(holding(nth)), 1.46);
      ASSERT_GT(highest_m(breaking(nth)), 1.54);
      asked.emplace_back(decided(holding(nth), what).at("id"), true);
      asked.emplace_back(decided(breaking(nth), what).at("id"), false);
    }
  const json answer = decisions();
  for (const auto& [id, holds] : asked) {
    const json one = with_id(answer, id);
    SCOPED_TRACE(one.dump());
    EXPECT_EQ(one.at("came").at("outcome"), holds ? "held" : "did_not_hold");
    EXPECT_NEAR(one.at("work_h").get<double>(), hours_of(work_), 1e-6);
    if (holds) continue;
    EXPECT_TRUE(contains(one.at("came").at("broken"), "wave height at most 1.5 m"));
    const UtcTime at = parse_utc(one.at("came").at("broken_at").get<std::string>());
    const UtcTime start = parse_utc(one.at("start").get<std::string>());
    EXPECT_GE(at, start);
    EXPECT_LE(at, start + work_);
  }
}

TEST_F(DecisionsCommand, RecordWhatWindowsSaysOfTheStartAndOnWhichForecast) {
  for (const json& start : windows_.at("tasks")[0].at("starts")) {
    const UtcTime time = parse_utc(start.at("start").get<std::string>());
    if (time.time_since_epoch() % std::chrono::hours(8) != Duration(0)) continue;
    const json made = decided(time, "--no-go");
    // The JSON of windows has six decimals.
    EXPECT_NEAR(made.at("said").at("probability").get<double>(),
                start.at("probability").get<double>(), 1e-6)
        << start;
    EXPECT_EQ(made.at("forecast").at("sha256"), windows_.at("forecast").at("sha256"));
    EXPECT_EQ(made.at("forecast").at("issued"), "2025-03-05T05:00:00Z");
    EXPECT_EQ(made.at("turbine"), "T1");
  }
  // Before the newer one was issued, the older one was there.
  const json before = decided(breaking(0), "--go", {"--at", "2025-03-05T04:59:00Z"});
  EXPECT_EQ(before.at("forecast").at("issued"), "2025-03-04T05:00:00Z");
}

TEST_F(DecisionsCommand, OfAStartBetweenTheHalfHoursAreRecordedToo) {
  const UtcTime start = holding(3);
  const double before = decided(start, "--go").at("said").at("probability");
  const double after =
      decided(start + std::chrono::minutes(30), "--go").at("said").at("probability");
  const json between = decided(start + std::chrono::minutes(10), "--go");
  const double found = between.at("said").at("probability");
  EXPECT_GE(found, std::min(before, after) - 0.1);
  EXPECT_LE(found, std::max(before, after) + 0.1);
  EXPECT_EQ(with_id(decisions(), between.at("id")).at("came").at("outcome"), "held");
}

TEST_F(DecisionsCommand, ALaterOneCountsAndTheEarlierStays) {
  const UtcTime start = holding(2);
  const json first = decided(start, "--go", {"--note", "at dawn", "--hand-over", "tow at noon"});
  EXPECT_TRUE(first.at("in_place_of").is_null());
  const json second = decided(start, "--no-go", {"--by", "B. Other"});
  EXPECT_EQ(second.at("in_place_of"), first.at("id"));
  const json answer = decisions({"--task", task()});
  EXPECT_FALSE(with_id(answer, first.at("id")).at("counts"));
  EXPECT_EQ(with_id(answer, first.at("id")).at("note"), "at dawn");
  EXPECT_EQ(with_id(answer, first.at("id")).at("hand_over"), "tow at noon");
  EXPECT_TRUE(with_id(answer, second.at("id")).at("counts"));
  const ProgramResult told = decide(format_utc(start), "--go", {});
  EXPECT_TRUE(contains(told.out, "it counts in place of decision")) << told.err;
  EXPECT_TRUE(contains(told.out, "no-go by B. Other, which is kept"));
}

TEST_F(DecisionsCommand, AreNotKnownBeforeTheTruthIsIn) {
  const json made = decided(breaking(3), "--go");
  const json early = decisions({"--at", "2025-03-06T00:30:00Z"});
  const json one = with_id(early, made.at("id"));
  EXPECT_EQ(one.at("came").at("outcome"), "not_known_yet");
  EXPECT_TRUE(contains(one.at("came").at("why"), "2025-03-0"));
  EXPECT_GT(early.at("record").at("goes_not_known"), 0);
  EXPECT_TRUE(contains(early.at("record").at("text"), "is not known so far"));
  const ProgramResult told = run({"decisions", "--site", farm(), "--at", "2025-03-06T00:30:00Z"});
  EXPECT_TRUE(contains(told.out, "came: not known yet: "));
  // Recorded after the moment that is asked about: listed, and counted for nothing.
  const json before = decisions({"--at", "2025-03-05T05:29:00Z"});
  for (const char* key : {"goes_known", "days_lost", "days_not_known"})
    EXPECT_EQ(before.at("record").at(key), 0) << key;
}

TEST_F(DecisionsCommand, WhoseWorkEndsAfterTheForecastSayWhyNothingIsKnown) {
  // The forecast holds to the midnight after 7 March.
  const json made = decided(parse_utc("2025-03-07T23:30:00Z"), "--go");
  EXPECT_TRUE(made.at("said").at("probability").is_null());
  EXPECT_TRUE(contains(made.at("said").at("why_nothing"), "ends after the forecast"));
  EXPECT_NE(with_id(decisions(), made.at("id")).at("came").at("outcome"), "held");
}

TEST_F(DecisionsCommand, RecordedLateSaySo) {
  const UtcTime start = holding(1);
  const ProgramResult told = decide(format_utc(start), "--go", {"--at", "2025-03-09T12:00:00Z"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "recorded late, "));
  EXPECT_TRUE(contains(told.out, " h after the start"));
  const json answer = decisions();
  std::size_t late = 0;
  for (const json& one : answer.at("decisions"))
    if (one.at("recorded_at") == "2025-03-09T12:00:00Z") {
      ++late;
      EXPECT_TRUE(one.at("late"));
      EXPECT_FALSE(one.at("recorded_by_clock")) << "it was stated";
      // The forecast that was there when the work began, not one from after it.
      EXPECT_LE(parse_utc(one.at("forecast").at("issued").get<std::string>()), start);
    }
  EXPECT_EQ(late, 1U);
}

TEST_F(DecisionsCommand, AreRefusedInOneClearSentence) {
  const std::string start = "2025-03-06T07:30Z";
  const auto refused = [&](const Arguments& more, int code, const Arguments& words,
                           const std::string& at = "2025-03-06T07:30Z") {
    expect_refusal(decide(at, "--go", more), code, words);
  };
  refused({"--no-go"}, 2, {"both --go and --no-go", "expected one of"});
  expect_refusal(run({"decide", "--site", farm(), "--task", task(), "--start", start, "--by", "A",
                      "--at", "2025-03-05T06:00:00Z"}),
                 2, {"found no decision", "expected one of --go and --no-go"});
  refused({"--by", "  "}, 2, {"--by", "found no name"});
  refused({"--by", std::string(201, 'x')}, 2, {"--by", "201 characters", "at most 200"});
  refused({"--by", "A\x1b[2J"}, 2, {"--by", "control character U+001B"});
  refused({"--by", "A \xe2\x80\xae"}, 2, {"--by", "control character U+202E"});
  refused({"--by", "A\xff"}, 2, {"--by", "no UTF-8"});
  refused({"--note", "one\ntwo"}, 2, {"--note", "control character U+000A"});
  refused({"--hand-over", "one\ntwo"}, 2, {"--hand-over", "control character U+000A"});
  refused({"--note", std::string(2001, 'x')}, 2, {"--note", "at most 2000"});
  refused({"--task", "scour_surfey"}, 4, {"scour_surfey", "did you mean 'scour_survey'"});
  refused({"--turbine", "T9"}, 4, {"--turbine: found T9", "expected one of T1"});
  refused({}, 2, {"--start", "whole minute"}, "2025-03-06T07:30:12Z");
  refused({}, 2, {"--start", "07:30"}, "2025-03-06 07:30");
  refused({}, 4, {"covers the start 2025-03-20T07:30:00Z", "holds from", "a newer forecast"},
          "2025-03-20T07:30Z");
  refused({"--at", "2025-03-03T06:00:00Z"}, 4, {"the first was issued later", "--at"});
  expect_refusal(
      run({"decide", "--site", "nowhere", "--task", task(), "--start", start, "--go", "--by", "A"}),
      4, {"nowhere"});
  expect_refusal(run({"decisions", "--site", farm(), "--csv", "table.txt"}), 2, {"--csv"});
}

TEST_F(DecisionsCommand, FillInTheSignOffOfTheMorningsPage) {
  const std::string name = "O'Neil & \"Sons\" <script>alert(1)</script>";
  // Recorded before the forecast of that morning, whose record counts it.
  decided(holding(5), "--go", {"--at", "2025-03-04T06:00:00Z"});
  const UtcTime start = breaking(4);
  const json made = decided(start, "--go", {"--by", name, "--note", "</table><b>"});
  const ProgramResult report =
      run({"report", "--site", farm(), "--task", task(), "--task", "cp_anode", "--day",
           "2025-03-04", "--html", made_->path("page.html"), "--json"});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  const std::string page = read_bytes(made_->path("page.html"));
  const std::size_t from = page.find("<section id=\"sign-off\"");
  ASSERT_NE(from, std::string::npos);
  const std::string block = page.substr(from, page.find("</section>", from) - from);
  EXPECT_TRUE(contains(block, "issued 2025-03-05T05:00:00Z"));
  EXPECT_TRUE(
      contains(block, windows_.at("forecast").at("sha256").get<std::string>().substr(0, 12)));
  EXPECT_TRUE(
      contains(block, "O&#39;Neil &amp; &quot;Sons&quot; &lt;script&gt;alert(1)&lt;/script&gt;"));
  EXPECT_FALSE(contains(page, "<script>alert"));
  EXPECT_TRUE(contains(block, "go, T1"));
  EXPECT_TRUE(contains(block, "Thu 6 Mar " + format_utc(start).substr(11, 5)));
  EXPECT_TRUE(contains(block, "<td class=\"box\"></td>")) << "the other task is open";
  EXPECT_TRUE(contains(block, "Decisions of the last 90 days: "));
  EXPECT_LT(from, page.find("id=\"answer\"")) << "it is signed on the first sheets";
  const json out = json::parse(report.out).at("decisions");
  std::size_t told = 0;
  for (const json& one : out.at("of_the_day")) told += one.at("id") == made.at("id") ? 1 : 0;
  EXPECT_EQ(told, 1U);
  EXPECT_EQ(out.at("record_days"), 90);
}

TEST_F(DecisionsCommand, ArePrintedForASpreadsheetThatRunsNothing) {
  decided(holding(1), "--go", {"--by", "=HYPERLINK(\"x\")", "--note", "calm, at last"});
  const std::string file = made_->path("table.csv");
  const std::size_t told = decisions({"--csv", file}).at("decisions").size();
  const std::string table = read_bytes(file);
  EXPECT_TRUE(table.starts_with("id,site,task,turbine,start,"));
  EXPECT_TRUE(contains(table, "\"'=HYPERLINK(\"\"x\"\")\""));
  EXPECT_TRUE(contains(table, "\"calm, at last\""));
  EXPECT_EQ(static_cast<std::size_t>(std::count(table.begin(), table.end(), '\n')), 1 + told);
}

TEST_F(DecisionsCommand, AreCountedByCheckAndKeptByPrune) {
  const auto counted = [] {
    return json::parse(run({"store", "check", "--quick", "--json"}).out).at("decisions").get<int>();
  };
  const int before = counted();
  decided(holding(0), "--go");
  EXPECT_EQ(counted(), before + 1);
  const ProgramResult told =
      run({"store", "prune", "--older-than", "2026-01-01", "--forecasts", "--dry-run"});
  EXPECT_EQ(told.exit_code, 0) << told.err;
  EXPECT_TRUE(contains(told.out, "which decisions rest on or which show what came of them"));
}

/// A page where nothing was decided has empty boxes and no record; a store without decisions says
/// so.
TEST(DecisionsOfNobody, LeaveTheBoxesEmpty) {
  StoreForTests made;
  made.ingest_days(parse_day("2025-03-01"), 3);
  made.write("farm.yaml", farm_at_the_site(made));
  made.write("waves.yaml", waves_sheet());
  const std::string farm = made.path("farm.yaml");
  expect_refusal(made.run({"decide", "--site", farm, "--task", made.path("waves.yaml"), "--start",
                           "2025-03-05T07:30Z", "--go", "--by", "A. Name"}),
                 4, {"found no issued forecast", "slackwater forecast"});
  ASSERT_EQ(made.run({"forecast", "--site", farm, "--at", "2025-03-04T05:00:00Z"}).exit_code, 0);
  const ProgramResult report =
      made.run({"report", "--site", farm, "--task", made.path("waves.yaml"), "--html",
                made.path("page.html"), "--json"});
  ASSERT_EQ(report.exit_code, 0) << report.err;
  EXPECT_TRUE(json::parse(report.out).at("decisions").is_null());
  const std::string page = read_bytes(made.path("page.html"));
  EXPECT_TRUE(contains(page, "<td class=\"box\"></td><td class=\"box\"></td>"));
  EXPECT_FALSE(contains(page, "Decisions of the last"));
  const ProgramResult none = made.run({"decisions", "--site", farm});
  EXPECT_EQ(none.exit_code, 0) << none.err;
  EXPECT_TRUE(contains(none.out, ": 0 decisions"));
}

}  // namespace
}  // namespace slackwater::tests::cli_decisions_test

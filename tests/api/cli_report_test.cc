// The morning report: `slackwater report`, and as the end of `slackwater forecast`.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/api/windows_command.h"
#include "tests/support/contains.h"

namespace slackwater::tests::cli_report_test {
namespace {

std::string plan_of(const std::string& site, const std::string& day = "") {
  return "name: One look\nsite: " + site + "\n" + day +
         "vessels:\n  - {id: ctv1, crews: 1, speed_kn: 20, hours: 00:00-24:00}\n"
         "crews:\n  - {id: blue, skills: [], shift: 00:00-24:00, vessel: ctv1}\n"
         "vehicles:\n  - {id: rov1, kind: rov, vessel: ctv1}\n"
         "tasks:\n  - {task: scour_survey, turbines: [T1], vehicles: [rov]}\n";
}

/// The windows' site and forecast; its tasks are asked for by name.
class ReportCommand : public WindowsCommand {
 protected:
  static ProgramResult report(Arguments arguments) {
    return report_of("farm.yaml", std::move(arguments));
  }
  /// A site of its own, whose forecasts are none of the others'.
  static void write_other_site(const std::string& name, const std::string& id) {
    write_farm(name, "tasks: [scour_survey]\n");
    std::string site = read_bytes(path(name));
    const std::size_t at = site.find("id: ") + 4;
    write(name, site.replace(at, site.find('\n', at) - at, id));
  }
  static ProgramResult report_of(const std::string& site, Arguments arguments) {
    arguments.insert(arguments.begin(), {"report", "--site", path(site)});
    return made_->run(arguments);
  }
};

TEST_F(ReportCommand, SaysOnOnePageWhatTheWindowsSay) {
  write("peek.yaml", peek(loose));
  write("never.yaml", peek(never));
  const Arguments tasks{"--task", path("peek.yaml"), "--task", path("never.yaml")};
  Arguments arguments = tasks;
  arguments.insert(arguments.end(), {"--html", path("page.html"), "--json"});
  const ProgramResult made = report(arguments);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json out = json::parse(made.out);
  EXPECT_EQ(out.at("schema"), "morning/1");
  EXPECT_EQ(out.at("day"), "2025-03-05");
  EXPECT_EQ(out.at("page"), path("page.html"));
  const json windows = answer(tasks);
  EXPECT_EQ(out.at("verdict"), windows.at("verdict"));
  for (std::size_t i = 0; i < 2; ++i) {
    const json& task = out.at("tasks")[i];
    EXPECT_EQ(task.at("verdict"), windows.at("tasks")[i].at("verdict"));
    double best = 0;
    for (const json& start : windows.at("tasks")[i].at("starts"))
      best = std::max(best, start.at("probability").get<double>());
    EXPECT_NEAR(task.at("best").at("probability").get<double>(), best, 1e-6);
  }
  const std::string page = read_bytes(path("page.html"));
  for (const char* part :
       {"Go for 1 of 2 tasks on Wed 5 Mar; 1 no-go.", "When each task can begin on Wed 5 Mar",
        "A peek at a pile", "current at most 0.02 m/s", "class=\"go\"", "Its checksum",
        "Nothing was flown"})
    EXPECT_TRUE(contains(page, part)) << part;
  EXPECT_LT(page.find("data-verdict=\"go\""), page.find("data-verdict=\"no-go\""))
      << "what can be done comes first";
  EXPECT_LT(page.find("id=\"gantt\""), page.find("id=\"answer\"")) << "the answer comes first";
}

TEST_F(ReportCommand, SaysWhatWouldChangeTheAnswer) {
  write("never.yaml", peek(never));
  const std::string page = path("help.html");
  const ProgramResult made = report({"--task", path("never.yaml"), "--html", page, "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json help = json::parse(made.out).at("tasks")[0].at("would_help");
  ASSERT_EQ(help.at("limits").size(), 1U) << "the waves stop nobody";
  EXPECT_TRUE(contains(help.at("limits")[0].at("without"), "current at most 0.02 m/s"));
  EXPECT_EQ(help.at("limits")[0].at("worker"), "eye");
  // All of the 25 futures hold the other limit.
  EXPECT_NEAR(help.at("limits")[0].at("probability").get<double>(), 25.5 / 26, 1e-9);
  EXPECT_TRUE(help.at("flown").is_null());
  EXPECT_TRUE(contains(read_bytes(page), "What would help: the best start without the limit"));

  write("go.yaml", peek(loose));
  const ProgramResult go = report({"--task", path("go.yaml"), "--html", page, "--json"});
  EXPECT_TRUE(json::parse(go.out).at("tasks")[0].at("would_help").is_null());
  EXPECT_FALSE(contains(read_bytes(page), "What would help"));
}

TEST_F(ReportCommand, FliesWhatIsNoGoOtherwise) {
  // Of two futures no start is more probable than 0.75: marginal, and no limit is to blame. It
  // loses a thruster and comes home with its work undone.
  std::string lame = peek(loose);
  lame.replace(lame.find("limits: ["), 9,
               "faults: [{fault: lost_thruster, thruster: 0, at_s: 150}]\n      limits: [");
  write("peek.yaml", lame);
  const ProgramResult made = report({"--task", path("peek.yaml"), "--from", "2025-03-05T06:00:00Z",
                                     "--to", "2025-03-05T07:00:00Z", "--members", "2", "--fly",
                                     "1min", "--html", path("otherwise.html"), "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json task = json::parse(made.out).at("tasks")[0];
  EXPECT_EQ(task.at("verdict"), "marginal");
  EXPECT_TRUE(task.at("would_help").at("limits").empty());
  const json flown = task.at("would_help").at("flown");
  EXPECT_EQ(flown.at("start"), task.at("best").at("start"));
  std::size_t changed = 0;
  for (const json& change : flown.at("changes")) {
    if (change.contains("impossible")) continue;
    ++changed;
    EXPECT_GE(change.at("flights"), 1);
    EXPECT_LE(change.at("done_as_is"), change.at("flights"));
    EXPECT_EQ(change.at("done").get<int>() - change.at("done_as_is").get<int>(),
              change.at("gained").get<int>() - change.at("lost").get<int>());
  }
  EXPECT_GE(changed, 3U) << flown;
  EXPECT_TRUE(contains(read_bytes(path("otherwise.html")), "with one thing changed"));
}

// Flown in dead calm it shows less than it asks for: no start of it could succeed.
TEST_F(ReportCommand, LeavesOutATaskThatCannotSeeWhatItAsksFor) {
  std::string blind = peek(loose);
  blind.replace(blind.find("    work:"), 9,
                "    inspection:\n      surfaces: [{kind: monopile}]\n      looks:\n        - "
                "{instrument: rov_camera, kinds: [monopile], detail_mm: 10, seen_at: 0.9}\n"
                "    work:");
  blind.replace(blind.find("id: peek"), 8, "id: blind");
  write("blind.yaml", blind);
  write("peek.yaml", peek(loose));
  const Arguments both{"--task",    path("peek.yaml"),
                       "--task",    path("blind.yaml"),
                       "--from",    "2025-03-05T06:00:00Z",
                       "--to",      "2025-03-05T07:00:00Z",
                       "--members", "2",
                       "--fly",     "1min",
                       "--html",    path("blind.html"),
                       "--json"};
  const ProgramResult made = report(both);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json said = json::parse(made.out);
  ASSERT_EQ(said.at("tasks").size(), 1U);
  EXPECT_TRUE(contains(said.at("tasks")[0].at("task").get<std::string>(), "peek.yaml"));
  ASSERT_EQ(said.at("left_out").size(), 1U);
  const std::string why = said.at("left_out")[0].dump();
  for (const char* words : {"blind", "flown in dead calm", "expected at least 90 %"})
    EXPECT_TRUE(contains(why, words)) << why;
  EXPECT_TRUE(contains(read_bytes(path("blind.html")), "flown in dead calm"));
}

TEST_F(ReportCommand, LiesInTheStoreWhereNothingElseIsSaid) {
  write("peek.yaml", peek(loose));
  write_farm("peeked.yaml", "tasks: [" + path("peek.yaml") + "]\n");
  const ProgramResult made = report_of("peeked.yaml", {"--verdict-exit"});
  EXPECT_EQ(made.exit_code, 10) << made.err;
  std::vector<std::string> pages;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(made_->store() / "reports"))
    if (entry.is_regular_file()) pages.push_back(entry.path().string());
  ASSERT_EQ(pages.size(), 1U);
  EXPECT_TRUE(contains(pages.front(), "/2025-03-05.html")) << pages.front();
  EXPECT_TRUE(contains(made.out, pages.front()));
  EXPECT_LE(std::count(made.out.begin(), made.out.end(), '\n'), 10);
  EXPECT_TRUE(made.out.starts_with("Go for the task on Wed 5 Mar.")) << made.out;
}

TEST_F(ReportCommand, HoldsThePlanOfTheDayOrSaysWhyThereIsNone) {
  const Arguments asked{"--task", "scour_survey", "--html", path("planned.html"), "--json"};
  Arguments with = asked;
  with.insert(with.end(), {"--plan", write("plan.yaml", plan_of(path("farm.yaml")))});
  ProgramResult made = report(with);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  json out = json::parse(made.out);
  EXPECT_EQ(out.at("plan").at("schema"), "plan/1");
  EXPECT_EQ(out.at("plan").at("jobs").size() + out.at("plan").at("left").size(), 1U);
  EXPECT_TRUE(contains(read_bytes(path("planned.html")), "What to do when: One look"));

  // Of yesterday, within the forecast, and of a day beyond it.
  for (const std::string day : {"2025-03-04", "2025-03-20"}) {
    with.back() = write("other.yaml", plan_of(path("farm.yaml"), "day: " + day + "\n"));
    made = report(with);
    ASSERT_EQ(made.exit_code, 0) << made.err;
    out = json::parse(made.out);
    EXPECT_TRUE(out.at("plan").is_null()) << day;
    EXPECT_TRUE(contains(out.at("no_plan"), day)) << out.at("no_plan");
    EXPECT_TRUE(contains(read_bytes(path("planned.html")), "There is no plan"));
  }

  // That of the site, by where it lies.
  std::filesystem::create_directories(made_->store() / "plans");
  const std::string id = out.at("site");
  write_bytes(made_->store() / "plans" / (id + ".yaml"), plan_of(path("farm.yaml")));
  EXPECT_FALSE(json::parse(report(asked).out).at("plan").is_null());
  Arguments none = asked;
  none.insert(none.end(), {"--plan", "none"});
  EXPECT_TRUE(json::parse(report(none).out).at("plan").is_null());
  std::filesystem::remove_all(made_->store() / "plans");
}

TEST_F(ReportCommand, WithoutChromiumThePageIsWrittenAndSaysWhatToInstall) {
  write("peek.yaml", peek(loose));
  const ProgramResult made = run_program(
      {"--store", made_->store().string(), "report", "--site", path("farm.yaml"), "--task",
       path("peek.yaml"), "--html", path("alone.html"), "--pdf", path("alone.pdf")},
      {{"PATH", "/nowhere"}});
  EXPECT_EQ(made.exit_code, 5);
  EXPECT_TRUE(contains(made.err, "apt install chromium")) << made.err;
  EXPECT_TRUE(std::filesystem::exists(path("alone.html")));
  EXPECT_FALSE(std::filesystem::exists(path("alone.pdf")));
}

TEST_F(ReportCommand, RefusesWhatItCannotAnswerAndWritesNothing) {
  const auto refuse = [&](Arguments arguments, int code, const std::vector<std::string>& words) {
    expect_refusal(report(std::move(arguments)), code, words);
  };
  const auto before = made_->digests();
  const std::string html = path("refused.html");
  refuse({"--task", "no_such_task", "--html", html}, 4, {"no_such_task"});
  refuse({"--task", "scour_survey"}, 2, {"--html", "this page needs its own file"});
  refuse({"--task", "scour_survey", "--task", "scour_survey", "--html", html}, 2, {"twice"});
  refuse({"--task", "scour_survey", "--turbine", "T1", "--turbine", "T1", "--html", html}, 2,
         {"T1 twice"});
  refuse({}, 2, {"--task", "lists none"});
  refuse({"--task", "scour_survey", "--html", path("page.pdf")}, 2, {"--html", ".html"});
  refuse({"--task", "scour_survey", "--pdf", path("page.html")}, 2, {"--pdf", ".pdf"});
  refuse({"--task", "scour_survey", "--html", html, "--plan", path("nowhere.yaml")}, 4,
         {"nowhere.yaml"});
  refuse({"--task", "scour_survey", "--html", html, "--day", "2025-01-01"}, 4, {"2025-01-01"});
  EXPECT_FALSE(std::filesystem::exists(html));
  EXPECT_EQ(made_->digests(), before);
}

TEST_F(ReportCommand, IsTheEndOfTheDailyJobWhereTheSiteListsTasks) {
  write_farm("tasked.yaml", "tasks: [scour_survey]\n");
  ASSERT_EQ(::chmod(made_->file("").c_str(), 0700), 0);
  const std::string teller =
      write("tell", "#!/bin/sh\ncat >> " + path("told.json") + "\necho >> " + path("times") + "\n");
  ASSERT_EQ(::chmod(teller.c_str(), 0700), 0);
  const std::string config = write("operator.yaml", "hook:\n  command: [" + teller + "]\n");
  ASSERT_EQ(::chmod(config.c_str(), 0600), 0);
  const auto forecast = [&](const std::string& at) {
    return run_program({"--store", made_->store().string(), "forecast", "--site",
                        path("tasked.yaml"), "--at", at, "--json"},
                       {{"SLACKWATER_OPERATOR", config}});
  };
  const ProgramResult first = forecast("2025-03-04T05:30:00Z");
  ASSERT_EQ(first.exit_code, 0) << first.err;
  const json morning = json::parse(first.out).at("morning");
  ASSERT_FALSE(morning.is_null()) << first.err;
  EXPECT_EQ(morning.at("day"), "2025-03-05");
  EXPECT_TRUE(std::filesystem::exists(morning.at("page").get<std::string>()));
  json told = json::parse(read_bytes(path("told.json")));
  EXPECT_EQ(told, morning) << "the hook hears what the answer says";
  EXPECT_TRUE(contains(first.err, "was told")) << first.err;

  // The same forecast again: nothing is told twice.
  const ProgramResult again = forecast("2025-03-04T05:30:00Z");
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(read_bytes(path("times")), "\n");

  // A file that others can write: the forecast stands, nothing is run.
  ASSERT_EQ(::chmod(config.c_str(), 0666), 0);
  const ProgramResult open = forecast("2025-03-04T05:45:00Z");
  ASSERT_EQ(open.exit_code, 0) << open.err;
  EXPECT_TRUE(contains(open.err, "writable for others")) << open.err;
  EXPECT_EQ(read_bytes(path("times")), "\n");
}

TEST_F(ReportCommand, OfSeveralDaysEveryTimeHasItsDay) {
  write("peek.yaml", peek(loose));
  const ProgramResult made = report({"--task", path("peek.yaml"), "--from", "2025-03-05T06:00:00Z",
                                     "--to", "2025-03-06T12:00:00Z", "--html", path("days.html")});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(contains(made.out, "from Wed 5 Mar 06:00 to Thu 6 Mar 12:00")) << made.out;
  EXPECT_TRUE(contains(made.out, "best Wed 5 Mar 06:00")) << made.out;
  const std::string page = read_bytes(path("days.html"));
  EXPECT_TRUE(contains(page, "begin from Wed 5 Mar 06:00 to Thu 6 Mar 12:00"));
  EXPECT_TRUE(contains(page, ">Thu 6 Mar</span>")) << "midnight on the clock above the pictures";
}

TEST_F(ReportCommand, AnEarlierReplayOfTheDayIsNotTold) {
  write_farm("tasked.yaml", "tasks: [scour_survey]\n");
  const ProgramResult later =
      made_->run({"forecast", "--site", path("tasked.yaml"), "--at", "2025-03-04T05:50:00Z"});
  ASSERT_EQ(later.exit_code, 0) << later.err;
  EXPECT_TRUE(contains(later.out, "The page: ")) << later.out;
  const ProgramResult earlier = made_->run(
      {"forecast", "--site", path("tasked.yaml"), "--at", "2025-03-04T05:20:00Z", "--json"});
  ASSERT_EQ(earlier.exit_code, 0) << earlier.err;
  EXPECT_TRUE(json::parse(earlier.out).at("morning").is_null());
  EXPECT_TRUE(contains(earlier.err, "is in force")) << earlier.err;
}

TEST_F(ReportCommand, TheNoonIssueHasANoonPageBesideTheMornings) {
  write_other_site("noon.yaml", "noon");
  const auto page_of = [&](const char* issued) {
    const ProgramResult made =
        made_->run({"forecast", "--site", path("noon.yaml"), "--at", issued, "--json"});
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return std::filesystem::path(json::parse(made.out).at("morning").at("page"));
  };
  const auto morning = page_of("2025-03-04T05:30:00Z");
  const std::string decided_by = read_bytes(morning);
  const auto noon = page_of("2025-03-04T12:30:00Z");
  EXPECT_EQ(morning.filename(), "2025-03-05.html");
  EXPECT_EQ(noon.filename(), "2025-03-05_1230.html");
  EXPECT_EQ(read_bytes(morning), decided_by) << "what people decided by stays";
  EXPECT_TRUE(contains(read_bytes(noon), "from Tue 4 Mar 12:30")) << "with the hours that are left";
}

TEST_F(ReportCommand, AForecastTooShortForTheMorningStandsAndSaysSo) {
  write_other_site("tasked.yaml", "short");
  const ProgramResult made = made_->run({"forecast", "--site", path("tasked.yaml"), "--at",
                                         "2025-03-04T06:30:00Z", "--horizon", "24h", "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_TRUE(json::parse(made.out).at("morning").is_null());
  EXPECT_TRUE(contains(made.err, "no morning report")) << made.err;
}

TEST_F(ReportCommand, OneTaskThatCannotBeWorkedOutLeavesTheDailyJobTheOthers) {
  write("peek.yaml", peek(loose));
  write_other_site("mixed.yaml", "mixed");
  std::string site = read_bytes(path("mixed.yaml"));
  const std::string tasks = "tasks: [scour_survey]";
  write("mixed.yaml", site.replace(site.find(tasks), tasks.size(),
                                   "tasks: [" + path("peek.yaml") + ", mooring_tendon]"));
  const std::filesystem::path plans = made_->store() / "plans";
  std::filesystem::create_directories(plans);
  write_bytes(plans / "mixed.yaml", "name: [broken\n");
  const ProgramResult made = made_->run(
      {"forecast", "--site", path("mixed.yaml"), "--at", "2025-03-04T05:40:00Z", "--json"});
  std::filesystem::remove_all(plans);
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json morning = json::parse(made.out).at("morning");
  ASSERT_FALSE(morning.is_null()) << made.err;
  EXPECT_EQ(morning.at("tasks").size(), 1U);
  ASSERT_EQ(morning.at("left_out").size(), 1U);
  EXPECT_EQ(morning.at("left_out")[0].at("task"), "mooring_tendon");
  EXPECT_EQ(morning.at("verdict"), "no-go") << "what nobody worked out is no go";
  EXPECT_TRUE(contains(morning.at("headline"), "1 not worked out")) << morning.at("headline");
  EXPECT_FALSE(morning.at("no_plan").is_null());
  EXPECT_TRUE(
      contains(read_bytes(morning.at("page").get<std::string>()), "It could not be worked out"));
}

/// As in the daily job: who asks by hand is not left without the others.
TEST_F(ReportCommand, LeavesOutATaskThatCannotBeWorkedOutWithItsReason) {
  write("peek.yaml", peek(loose));
  const ProgramResult made = report({"--task", path("peek.yaml"), "--task", "mooring_tendon",
                                     "--html", path("mixed.html"), "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json out = json::parse(made.out);
  EXPECT_EQ(out.at("tasks").size(), 1U);
  ASSERT_EQ(out.at("left_out").size(), 1U);
  EXPECT_EQ(out.at("left_out")[0].at("task"), "mooring_tendon");
  EXPECT_NE(out.at("left_out")[0].at("why"), "");
  EXPECT_TRUE(contains(read_bytes(path("mixed.html")), "It could not be worked out"));
}

TEST_F(ReportCommand, TheHookHearsToWhyThereIsNoReport) {
  write_other_site("tasked.yaml", "shorter");
  ASSERT_EQ(::chmod(made_->file("").c_str(), 0700), 0);
  const std::string teller = write("tell_why", "#!/bin/sh\ncat > " + path("why.json") + "\n");
  ASSERT_EQ(::chmod(teller.c_str(), 0700), 0);
  const std::string config = write("why_operator.yaml", "hook:\n  command: [" + teller + "]\n");
  ASSERT_EQ(::chmod(config.c_str(), 0600), 0);
  const ProgramResult made =
      run_program({"--store", made_->store().string(), "forecast", "--site", path("tasked.yaml"),
                   "--at", "2025-03-04T07:10:00Z", "--horizon", "24h"},
                  {{"SLACKWATER_OPERATOR", config}});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json told = json::parse(read_bytes(path("why.json")));
  EXPECT_TRUE(told.at("verdict").is_null());
  EXPECT_TRUE(contains(told.at("why"), "2025-03-05")) << told.at("why");
}

TEST_F(ReportCommand, AnAnswerThatCannotBeWrittenIsNoSuccess) {
  const int exit_code = std::system(("'" + program_path().string() + "' --store '" +
                                     made_->store().string() + "' report --site '" +
                                     path("farm.yaml") + "' --task scour_survey --json --html '" +
                                     path("full.html") + "' > /dev/full 2> /dev/null")
                                        .c_str());
  EXPECT_EQ(WEXITSTATUS(exit_code), 5);
}

TEST_F(ReportCommand, NoSiteMissionOrPlanCanNameAHook) {
  write_farm("hooked.yaml", "tasks: [scour_survey]\nhook: {command: [/bin/true]}\n");
  expect_refusal(made_->run({"report", "--site", path("hooked.yaml")}), 3, {"hook"});
  write_farm("plain.yaml", "tasks: [scour_survey]\n");
  const std::string plan =
      write("hooked_plan.yaml", plan_of(path("plain.yaml")) + "hook: {command: [/bin/true]}\n");
  expect_refusal(made_->run({"report", "--site", path("plain.yaml"), "--plan", plan}), 3, {"hook"});
}

}  // namespace
}  // namespace slackwater::tests::cli_report_test

// `slackwater windows`: when a task can be begun in an issued forecast, for people and for
// programs, and all that can be wrong with the question.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/api/windows_command.h"

namespace slackwater::tests::cli_windows_test {
namespace {

/// Runs of starts with a mark, as [first, last].
template <typename IsOpen>
std::vector<std::pair<std::string, std::string>> runs_of(const json& starts,
                                                         const IsOpen& is_open) {
  std::vector<std::pair<std::string, std::string>> runs;
  bool was_open = false;
  for (const json& start : starts) {
    const auto time = start.at("start").get<std::string>();
    if (is_open(start) && was_open) runs.back().second = time;
    if (is_open(start) && !was_open) runs.emplace_back(time, time);
    was_open = is_open(start);
  }
  return runs;
}
std::vector<std::pair<std::string, std::string>> intervals_of(const json& windows) {
  std::vector<std::pair<std::string, std::string>> out;
  for (const json& window : windows) out.emplace_back(window.at("from"), window.at("to"));
  return out;
}

TEST_F(WindowsCommand, LooksAtTheFirstFullDayAfterTheIssueInEveryMember) {
  const auto before = made_->digests();
  const json out = answer({"--task", "scour_survey"});
  EXPECT_EQ(made_->digests(), before) << "the store is only read";
  EXPECT_EQ(out.at("from"), "2025-03-05T00:00:00Z");
  EXPECT_EQ(out.at("to"), "2025-03-06T00:00:00Z");
  EXPECT_EQ(out.at("members"), 25);
  EXPECT_EQ(out.at("forecast").at("issued"), "2025-03-04T05:00:00Z");
  const json& task = out.at("tasks")[0];
  EXPECT_EQ(task.at("task"), "scour_survey");
  EXPECT_EQ(task.at("duration_h"), 1.5);
  EXPECT_EQ(task.at("contingency_h"), 0.5);
  const json& starts = task.at("starts");
  ASSERT_EQ(starts.size(), 48U);
  std::set<double> seen;
  for (const json& start : starts) {
    const auto held = start.at("futures_held").get<double>();
    const auto probability = start.at("probability").get<double>();
    const auto futures = start.at("futures").get<double>();
    EXPECT_EQ(futures, 1993) << "it is limited by waves";
    EXPECT_NEAR(probability, (held + 0.5) / (futures + 1), 1e-6);
    // Of as many members as there are beside the waves, to the nearest.
    EXPECT_LE(start.at("interval_95")[0].get<double>(), held / futures + 0.02);
    EXPECT_GE(start.at("interval_95")[1].get<double>(), held / futures - 0.02);
    EXPECT_TRUE(start.at("twin").is_null());
    EXPECT_TRUE(start.at("forbidden").is_null());
    const json& binding = start.at("binding");
    ASSERT_FALSE(binding.is_null());
    EXPECT_EQ(binding.at("exceeded"), held < futures);
    EXPECT_GE(binding.at("time"), start.at("start"));
    seen.insert(probability);
  }
  // Windows are the runs of starts, by each rule.
  EXPECT_EQ(intervals_of(task.at("windows")), runs_of(starts, [](const json& start) {
              return start.at("probability").get<double>() >= 0.5;
            }));
  EXPECT_EQ(intervals_of(task.at("windows_by_threshold")),
            runs_of(starts, [](const json& start) { return start.at("threshold").get<bool>(); }));
  const double best = *seen.rbegin();
  EXPECT_EQ(task.at("verdict"), best >= 0.5 ? "marginal" : "no-go")
      << "nobody forecast its wind: no start is a go";
  EXPECT_EQ(out.at("verdict"), task.at("verdict"));
  // The water visibility is not served, and says so.
  EXPECT_EQ(task.at("not_checked").size(), 1U);
  EXPECT_NE(task.at("not_checked")[0].get<std::string>().find("visibility under water"),
            std::string::npos);
}

TEST_F(WindowsCommand, PhasesFollowEachOtherAndFillThePlannedTime) {
  const json task = task_of({"--task", write("loose.yaml", peek(loose))});
  double at = 0;
  std::vector<std::string> names;
  for (const json& phase : task.at("phases")) {
    EXPECT_NEAR(phase.at("from_min").get<double>(), at, 1e-5);
    at = phase.at("to_min").get<double>();
    names.push_back(phase.at("phase"));
  }
  EXPECT_NEAR(at, 90, 1e-5);
  EXPECT_EQ(names, (std::vector<std::string>{"launch", "transit", "work", "return", "recovery"}));
}

TEST_F(WindowsCommand, TheVerdictIsTheExitCodeWhereThatIsAsked) {
  const std::string open = write("loose.yaml", peek(loose));
  const std::string shut = write("never.yaml", peek(never));
  EXPECT_EQ(run({"--task", open}).exit_code, 0);
  EXPECT_EQ(run({"--task", open, "--verdict-exit"}).exit_code, 10);
  EXPECT_EQ(run({"--task", open, "--go", "1", "--verdict-exit"}).exit_code, 11);
  EXPECT_EQ(run({"--task", shut, "--verdict-exit"}).exit_code, 12);
  EXPECT_EQ(run({"--task", open, "--task", shut, "--verdict-exit"}).exit_code, 12)
      << "the worst of the tasks";
  const json task = task_of({"--task", shut});
  EXPECT_EQ(task.at("verdict"), "no-go");
  EXPECT_EQ(task.at("windows").size(), 0U);
  for (const json& start : task.at("starts"))
    if (start.at("futures_held") == 0) {
      const json& binding = start.at("binding");
      EXPECT_NE(binding.at("limit").get<std::string>().find("current at most 0.02"),
                std::string::npos);
      EXPECT_TRUE(binding.at("exceeded").get<bool>());
    }
}

TEST_F(WindowsCommand, AreNoGoOnASeaThatNobodyForecast) {
  const ProgramResult result = run({"--task", write("waves.yaml", peek(loose_waves))});
  EXPECT_EQ(result.out.find("marginal"), 0U) << result.out;
  EXPECT_NE(result.out.find("P 1.00"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("computed from a wind that is the last known one, fading; no such "
                            "start is a go"),
            std::string::npos)
      << result.out;
  const json start = task_of({"--task", path("waves.yaml")}).at("starts")[0];
  EXPECT_NEAR(start.at("worth").get<double>(), 0.89, 1e-6);
  EXPECT_GT(start.at("probability").get<double>(), 0.99);
  EXPECT_FALSE(start.at("unforecast").is_null());
}

TEST_F(WindowsCommand, ALimitOfARecoveryBindsWhenTheRecoveryRuns) {
  // The slackest current of the day lies somewhere: begun so that the recovery falls there.
  const json work = task_of({"--task", write("w.yaml", peek("{current_speed_m_s: 0.15}")),
                             "--contingency", "0h", "--every", "10min"});
  const json recovery =
      task_of({"--task", write("r.yaml", peek("{current_speed_m_s: 0.15, phases: [recovery]}")),
               "--contingency", "0h", "--every", "10min"});
  std::size_t more = 0;
  for (std::size_t i = 0; i < work.at("starts").size(); ++i) {
    const auto all = work.at("starts")[i].at("futures_held").get<int>();
    const auto late = recovery.at("starts")[i].at("futures_held").get<int>();
    EXPECT_LE(all, late) << "a limit of all phases holds no more often than one of the last";
    more += late > all ? 1 : 0;
    const json& binding = recovery.at("starts")[i].at("binding");
    if (!binding.at("exceeded").get<bool>()) continue;
    const UtcTime start = parse_utc(recovery.at("starts")[i].at("start").get<std::string>());
    const UtcTime stop = parse_utc(binding.at("time").get<std::string>());
    EXPECT_GE(stop - start, std::chrono::minutes(80));
    EXPECT_LT(stop - start, std::chrono::minutes(90));
  }
  EXPECT_GT(more, 0U);
}

TEST_F(WindowsCommand, WavesErrInTheMembersUnlessTheyAreTakenAsForecast) {
  // The forecast's own height at noon, as a limit: as forecast all members agree.
  const std::string near = write("near.yaml", peek("{significant_wave_height_m: 1.0}"));
  const auto counts = [&](const std::string& waves) {
    std::set<int> held;
    const json task = task_of({"--task", near, "--waves", waves});
    for (const json& start : task.at("starts")) held.insert(start.at("futures_held").get<int>());
    return held;
  };
  for (const int held : counts("forecast")) EXPECT_TRUE(held == 0 || held == 25) << held;
  // Far more futures of the waves than members.
  const std::set<int> spread = counts("error");
  EXPECT_TRUE(
      std::any_of(spread.begin(), spread.end(), [](int held) { return held > 25 && held < 1993; }));
}

TEST_F(WindowsCommand, PracticeTakesItsFactorsFromATableOrSaysWhyItHasNone) {
  const std::string task = write("waves.yaml", peek("{significant_wave_height_m: 1.5}"));
  const json ours = answer({"--task", task});
  EXPECT_NE(ours.at("rules").at("alpha").get<std::string>().find("DNV-OS-H101"), std::string::npos);
  EXPECT_TRUE(ours.at("tasks")[0].at("windows_by_alpha").is_array());
  // Whatever practice lets begin, the threshold does.
  for (const json& start : ours.at("tasks")[0].at("starts"))
    EXPECT_TRUE(!start.at("alpha").get<bool>() || start.at("threshold").get<bool>());
  const json low = task_of({"--task", write("low.yaml", peek("{significant_wave_height_m: 0.8}"))});
  EXPECT_TRUE(low.at("windows_by_alpha").is_null());
  EXPECT_NE(low.at("no_alpha").get<std::string>().find("the table has no factor for limits below"),
            std::string::npos);
  const std::string head = "name: mine\nsource: me\nvariable: significant_wave_height_m\n";
  const std::string strict =
      write("strict.yaml", head + "limits: [1]\nrows: [{up_to_h: 72, alpha: [0.01]}]\n");
  const json mine = answer({"--task", task, "--alpha", strict});
  EXPECT_EQ(mine.at("rules").at("alpha"), "mine");
  EXPECT_EQ(mine.at("tasks")[0].at("windows_by_alpha").size(), 0U);
  const json errors = answer({"--task", task, "--alpha", "errors"});
  EXPECT_NE(errors.at("rules").at("alpha").get<std::string>().find("Wilcken"), std::string::npos);
  // From the start a period is shorter, and the factor no smaller.
  const json from_start = answer({"--task", task, "--alpha-from", "start"});
  for (std::size_t i = 0; i < 48; ++i)
    EXPECT_TRUE(!ours.at("tasks")[0].at("starts")[i].at("alpha").get<bool>() ||
                from_start.at("tasks")[0].at("starts")[i].at("alpha").get<bool>());
  expect_refused({"--task", task, "--alpha", write("bad.yaml", head + "limits: [1]\n")}, 3,
                 {"rows", "missing"});
  expect_refused({"--task", task, "--alpha", strict, "--alpha", strict}, 3, {"second table"});
  expect_refused({"--task", task, "--alpha", path("nowhere.yaml")}, 4, {"nowhere.yaml"});
  expect_refused({"--task", task, "--alpha", "errors", "--alpha", strict}, 2, {"--alpha"});
}

TEST_F(WindowsCommand, ShiftsAreOfTheLocalClockAndLightOfTheSun) {
  const std::string task = write("loose.yaml", peek(loose));
  const json shift = task_of({"--task", task, "--shift", "06:00-18:00", "--zone", "Europe/Paris"});
  // CET: from 05:00Z, and two hours before 17:00Z at the latest.
  ASSERT_EQ(shift.at("windows").size(), 1U);
  EXPECT_EQ(shift.at("windows")[0].at("from"), "2025-03-05T05:00:00Z");
  EXPECT_EQ(shift.at("windows")[0].at("to"), "2025-03-05T15:00:00Z");
  const json& early = shift.at("starts")[0].at("binding");
  EXPECT_NE(early.at("limit").get<std::string>().find("shift 06:00 to 18:00 Europe/Paris"),
            std::string::npos);
  EXPECT_TRUE(early.at("worker").is_null());
  const json light = task_of({"--task", task, "--light", "civil"});
  ASSERT_EQ(light.at("windows").size(), 1U);
  const json sheet = task_of({"--task", write("day.yaml", peek(loose, "daylight: civil\n"))});
  EXPECT_EQ(sheet.at("windows"), light.at("windows")) << "the sheet may ask for it";
  const json sun = task_of({"--task", task, "--light", "sun_up"});
  EXPECT_LT(light.at("windows")[0].at("from"), sun.at("windows")[0].at("from"));
  EXPECT_GT(light.at("windows")[0].at("to"), sun.at("windows")[0].at("to"));
  expect_refused({"--task", task, "--light", "moon"}, 2, {"--light", "civil"});
  expect_refused({"--task", task, "--shift", "noon"}, 2, {"--shift"});
  // A site's own hours, unless others are asked for.
  write_farm("by_day.yaml", "shift: 06:00-18:00\ntimezone: Europe/Paris\n");
  const auto windows_at = [&](Arguments more) {
    more.insert(more.begin(), {"--task", task, "--site", path("by_day.yaml")});
    return task_of(std::move(more)).at("windows");
  };
  EXPECT_EQ(windows_at({}), shift.at("windows"));
  EXPECT_EQ(windows_at({"--shift", "0-24"})[0].at("from"), "2025-03-05T00:00:00Z");
  write_farm("odd.yaml", "shift: noon\n");
  expect_refused({"--task", task, "--site", path("odd.yaml")}, 3, {"shift", "noon"});
  expect_refused({"--task", task, "--zone", "Europe/Pariss"}, 2, {"Europe/Paris"});
}

TEST_F(WindowsCommand, OtherHoursOfTheForecastMayBeAsked) {
  const std::string task = write("loose.yaml", peek(loose));
  const json task_json = task_of({"--task", task, "--from", "2025-03-04T06:00:00Z", "--to",
                                  "2025-03-04T12:00:00Z", "--every", "1h"});
  ASSERT_EQ(task_json.at("starts").size(), 6U);
  EXPECT_EQ(task_json.at("starts")[5].at("start"), "2025-03-04T11:00:00Z");
  // The forecast ends at midnight of the sixth: the last starts do not come home before that.
  const json late = task_of({"--task", task, "--from", "2025-03-06T12:00:00Z"});
  EXPECT_EQ(late.at("starts").back().at("start"), "2025-03-06T22:00:00Z");
  EXPECT_NE(late.at("notes")[0].get<std::string>().find("3 starts"), std::string::npos)
      << late.at("notes").dump();
  expect_refused({"--task", task, "--from", "2025-04-01T00:00:00Z"}, 3,
                 {"2025-04-01", "the forecast holds from 2025-03-04T00:00:00Z"});
  expect_refused({"--task", task, "--from", "2025-03-05T12:00:00Z", "--to", "2025-03-05T06:00:00Z"},
                 3, {"after the beginning"});
  expect_refused({"--task", task, "--from", "2025-03-06T23:00:00Z", "--to", "2025-03-07T00:00:00Z"},
                 3, {"ends after the forecast"});
  expect_refused({"--task", task, "--every", "0min"}, 2, {"--every"});
}

TEST_F(WindowsCommand, AFileOfAForecastAnswersAsTheStoreDoes) {
  const std::string task = write("w.yaml", peek("{current_speed_m_s: 0.3}"));
  const json stored = task_of({"--task", task});
  const json file = task_of({"--task", task, "--forecast", path("issued.nc")});
  EXPECT_EQ(file.at("starts"), stored.at("starts"));
}

TEST_F(WindowsCommand, DrawsFurtherMembersWithoutTouchingTheStore) {
  const auto before = made_->digests();
  const std::string task = write("w.yaml", peek("{current_speed_m_s: 0.3}"));
  const json out = answer({"--task", task, "--members", "30", "--every", "2h"});
  EXPECT_EQ(out.at("members"), 30);
  EXPECT_EQ(out.at("members_issued"), 25);
  EXPECT_EQ(made_->digests(), before);
}

TEST_F(WindowsCommand, AreasThatAreClosedForbidAStart) {
  std::string site = read_bytes(path("farm.yaml"));
  const auto number = [&](const std::string& key) {
    const std::size_t at = site.find(key + ": ") + key.size() + 2;
    return std::stod(site.substr(at));
  };
  const double lat = number("latitude_deg"), lon = number("longitude_deg");
  const auto corner = [&](double dlat, double dlon) {
    return "{latitude_deg: " + std::to_string(lat + dlat) +
           ", longitude_deg: " + std::to_string(lon + dlon) + "}";
  };
  write("closed.yaml", site +
                           "areas: [{id: terns, kind: exclusion, reason: breeding terns, "
                           "hours_utc: [6, 11], polygon: [" +
                           corner(-0.01, -0.01) + ", " + corner(0.01, -0.01) + ", " +
                           corner(0.01, 0.01) + ", " + corner(-0.01, 0.01) + "]}]\n");
  const json task =
      task_of({"--task", write("loose.yaml", peek(loose)), "--site", path("closed.yaml")});
  const json& starts = task.at("starts");
  // From 06:00 to 12:00; a task of two hours that begins at 04:00 ends as it closes.
  EXPECT_FALSE(starts[8].at("forbidden").is_null()) << starts[8].dump();
  EXPECT_TRUE(starts[7].at("forbidden").is_null()) << starts[7].dump();
  EXPECT_NE(starts[20].at("forbidden").get<std::string>().find("terns"), std::string::npos);
  EXPECT_EQ(starts[20].at("probability"), 0.0);
  EXPECT_FALSE(starts[20].at("threshold").get<bool>());
  EXPECT_TRUE(starts[24].at("forbidden").is_null());
  EXPECT_EQ(task.at("windows").size(), 2U);
}

TEST_F(WindowsCommand, SaysItInWordsTheAnswerFirst) {
  const ProgramResult open = run({"--task", write("loose.yaml", peek(loose))});
  EXPECT_EQ(open.exit_code, 0);
  EXPECT_EQ(open.out.find("go: Test site, starts from 2025-03-05 00:00 to 2025-03-06 00:00 UTC"),
            0U)
      << open.out;
  EXPECT_NE(open.out.find("A peek at a pile at T1, 1.5 h and 0.5 h of contingency"),
            std::string::npos)
      << open.out;
  EXPECT_NE(open.out.find("start 00:00 to 23:30   P 0.98   threshold 48/48   alpha"),
            std::string::npos)
      << open.out;
  const ProgramResult shut = run({"--task", write("never.yaml", peek(never))});
  EXPECT_EQ(shut.out.find("no-go"), 0U);
  EXPECT_NE(shut.out.find("stopped by current at most 0.02 m/s (eye)"), std::string::npos)
      << shut.out;
}

TEST_F(WindowsCommand, WhatNobodyKnowsIsAskedForOrAssumed) {
  const std::string task = write("see.yaml", peek("{least_visibility_m: 500}"));
  expect_refused({"--task", task}, 3, {"visibility at least 500 m", "--assume visibility_m="});
  const json seen = task_of({"--task", task, "--assume", "visibility_m=5000"});
  EXPECT_EQ(seen.at("assumed")[0], "visibility 5000 m");
  EXPECT_EQ(seen.at("verdict"), "go");
  EXPECT_EQ(task_of({"--task", task, "--assume", "visibility_m=400"}).at("verdict"), "no-go");
  expect_refused({"--task", task, "--assume", "current_speed_m_s=1"}, 3, {"cannot be assumed"});
}

TEST_F(WindowsCommand, RefusesWhatCannotBeAnswered) {
  const std::string task = write("loose.yaml", peek(loose));
  expect_refused({"--task", "scour_survy"}, 4, {"scour_survy", "did you mean 'scour_survey'"});
  expect_refused({}, 2, {"--task", "scour_survey"});
  expect_refused({"--task", task, "--turbine", "T9"}, 3, {"T9", "T1"});
  expect_refused({"--task", task, "--site", "nowhere"}, 4, {"nowhere"});
  expect_refused({"--task", task, "--day", "2025-02-01"}, 4, {"2025-02-01"});
  expect_refused({"--task", task, "--go", "0.4"}, 2, {"--marginal", "--go"});
  std::string longer = peek(loose);
  longer.replace(longer.find("value: 1.5"), 10, "value: 30");
  expect_refused({"--task", write("long.yaml", longer)}, 3, {"30.0 h", "longer than the day"});
  expect_refused({"--task", write("duration.yaml", peek(loose, "daylight: moon\n"))}, 3,
                 {"daylight", "civil"});
  std::string wrong = peek(loose);
  wrong.replace(wrong.find("kinds: [rov]"), 12, "kinds: [uav]");
  expect_refused({"--task", write("wrong.yaml", wrong)}, 3, {"expected uav"});
}

TEST_F(WindowsCommand, OnTheDayTheClocksGoForwardTheShiftBeginsAnHourEarlier) {
  const StoreForTests spring;
  spring.ingest_days(parse_day("2025-03-26"), 3);
  const std::string site = spring.write("farm.yaml", read_bytes(path("farm.yaml")));
  ASSERT_EQ(spring.run({"forecast", "--site", site, "--at", "2025-03-29T05:00:00Z"}).exit_code, 0);
  const ProgramResult result =
      spring.run({"windows", "--site", site, "--task", spring.write("loose.yaml", peek(loose)),
                  "--shift", "06:00-18:00", "--zone", "Europe/Paris", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json windows = json::parse(result.out).at("tasks")[0].at("windows");
  ASSERT_EQ(windows.size(), 1U);
  EXPECT_EQ(windows[0].at("from"), "2025-03-30T04:00:00Z") << "06:00 CEST";
  EXPECT_EQ(windows[0].at("to"), "2025-03-30T14:00:00Z");
}

}  // namespace
}  // namespace slackwater::tests::cli_windows_test

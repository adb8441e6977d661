// `slackwater workability`: the past of a place, for people and for programs, and all that can be
// wrong with it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/refusal.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_workability_test {
namespace {

using nlohmann::json;
using Arguments = std::vector<std::string>;

const std::string height = "sea_surface_wave_significant_height";

/// twin/docs/operations.md, section 3.
const std::string example =
    "time,sea_surface_wave_significant_height\n"
    "2002-01-01T00:00Z,1.2\n2002-01-01T01:00Z,1.2\n2002-01-01T02:00Z,1.2\n"
    "2002-01-01T03:00Z,1.8\n2002-01-01T04:00Z,1.0\n2002-01-01T05:00Z,1.0\n"
    "2002-01-01T06:00Z,1.0\n2002-01-01T07:00Z,1.0\n2002-01-01T08:00Z,1.9\n";

/// So many hours from 2002 on, calm from the sixth to the eighteenth of each day.
std::string daily_calm(int days) {
  std::string text = "time,Hs,wind\n";
  for (int day = 0; day < days; ++day) {
    for (int hour = 0; hour < 24; ++hour) {
      const UtcTime time = parse_utc("2002-01-01T00:00:00Z") + std::chrono::hours(24 * day + hour);
      text += format_utc(time) + (hour >= 6 && hour < 18 ? ",1.0,5\n" : ",2.0,5\n");
    }
  }
  return text;
}

class WorkabilityCommand : public testing::Test {
 protected:
  ProgramResult run(Arguments arguments) const {
    arguments.insert(arguments.begin(), "workability");
    return store_.run(arguments);
  }
  json answer(Arguments arguments) const {
    arguments.emplace_back("--json");
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  }
  /// Told in one line that holds the words, on stderr, and as JSON too.
  void expect_refused(const Arguments& arguments, int exit_code,
                      const std::vector<std::string>& words) const {
    expect_refusal(run(arguments), exit_code, words);
  }

  StoreForTests store_;
};

TEST_F(WorkabilityCommand, AnswersTheWorkedExampleWithTheKeysOfTheSchema) {
  const std::string file = store_.write("example.csv", example);
  const json found = answer({file, "--limit", height + "<=1.5", "--duration", "3h"});
  EXPECT_EQ(found.at("steps"), 9);
  EXPECT_EQ(found.at("missing_steps"), 0);
  EXPECT_DOUBLE_EQ(found.at("accessibility").get<double>(), 7.0 / 9);
  EXPECT_DOUBLE_EQ(found.at("workability").get<double>(), 3.0 / 9);
  EXPECT_EQ(found.at("windows"), 2);
  EXPECT_EQ(found.at("workable_windows"), 2);
  EXPECT_EQ(found.at("mean_window_h"), 3.5);
  EXPECT_EQ(found.at("longest_window_h"), 4);
  EXPECT_EQ(found.at("censored_steps"), 3);
  EXPECT_EQ(found.at("waiting_time_h"),
            (json{{"mean", 1.0}, {"p10", 0.0}, {"p50", 0.5}, {"p80", 2.0}, {"p90", 2.5}}));
  const json& january = found.at("by_month").at(0);
  EXPECT_EQ(january.at("month"), 1);
  EXPECT_EQ(found.at("by_year").at(0).at("year"), 2002);
  for (const char* key :
       {"steps", "missing_steps", "accessibility", "workability", "windows", "workable_windows",
        "mean_window_h", "longest_window_h", "censored_steps", "waiting_time_h", "persistence",
        "storms", "mean_storm_h", "longest_storm_h"})
    EXPECT_EQ(january.at(key), found.at(key)) << key;
  EXPECT_EQ(found.at("limits").at(0).at("holds"), found.at("accessibility"));
  EXPECT_EQ(found.at("gaps"), (json{{"count", 0}, {"longest_h", 0.0}, {"longest_from", nullptr}}));
}

TEST_F(WorkabilityCommand, WhatIsSaidToBeMissingIsNeverWorkable) {
  const std::string file = store_.write("example.csv", example);
  const Arguments asked{file, "--limit", height + "<=1.5", "--duration", "3h", "--missing", "1.2"};
  const json found = answer(asked);
  EXPECT_EQ(found.at("missing_steps"), 3);
  EXPECT_DOUBLE_EQ(found.at("accessibility").get<double>(), 4.0 / 9);
  const ProgramResult told = run(asked);
  EXPECT_NE(told.err.find("3 of 9 values (33.3 %)"), std::string::npos) << told.err;
  // A buoy's number for "not measured", which nobody named: it is no gale, and no calm either.
  std::string buoy = example;
  for (std::size_t at; (at = buoy.find(",1.2\n")) != std::string::npos;)
    buoy.replace(at, 5, ",9999\n");
  const std::string with_code = store_.write("buoy.csv", buoy);
  const json coded = answer({with_code, "--limit", height + "<=1.5", "--duration", "3h"});
  EXPECT_EQ(coded.at("missing_steps"), 3);
  EXPECT_EQ(coded.at("accessibility"), found.at("accessibility"));
}

TEST_F(WorkabilityCommand, TellsATiredPersonTheAnswerFirst) {
  const std::string file = store_.write("example.csv", example);
  const ProgramResult result = run({file, "--limit", height + "<=1.5", "--duration", "3h"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out.rfind("A task of 3 h could start 33.3 % of the time.\n", 0), 0U)
      << result.out;
  EXPECT_NE(result.out.find("9 steps of 1 h from 2002-01-01T00:00:00Z"), std::string::npos);
  EXPECT_NE(result.out.find("\nJan "), std::string::npos);
  EXPECT_NE(result.out.find("3 steps at the end have no start after them"), std::string::npos);
  const ProgramResult never = run({file, "--limit", height + "<=0.5", "--duration", "3h"});
  EXPECT_EQ(
      never.out.rfind(
          "A task of 3 h could never be done: there was no time at which all limits held.", 0),
      0U)
      << never.out;
}

/// A quarter of a day, workable at its beginning alone: nobody knows how long the rest would wait.
TEST_F(WorkabilityCommand, ARecordThatEndsBeforeTheNextStartSaysSo) {
  const std::string csv =
      store_.write("short.csv", "time," + height +
                                    "\n2002-01-01T00:00Z,1\n2002-01-01T01:00Z,1\n"
                                    "2002-01-01T02:00Z,2\n2002-01-01T03:00Z,2\n"
                                    "2002-01-01T04:00Z,2\n2002-01-01T05:00Z,2\n");
  const ProgramResult result = run({csv, "--limit", height + "<=1.5", "--duration", "1h"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out.find("There is no wait"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("For 67 % of the time the record ends before the next start comes"),
            std::string::npos)
      << result.out;
}

TEST_F(WorkabilityCommand, UnitsAreConvertedWithoutMovingWhatEqualsTheLimit) {
  const std::string metres = store_.write("m.csv", example);
  const std::string centimetres = store_.write(
      "cm.csv", "time,Hs\n2002-01-01T00:00Z,57\n2002-01-01T01:00Z,58\n2002-01-01T02:00Z,57\n");
  const auto windows = [&](const Arguments& arguments) {
    return answer(arguments).at("windows").get<int>();
  };
  EXPECT_EQ(windows({metres, "--limit", height + "<=120 cm", "--duration", "1h"}), 2);
  EXPECT_EQ(windows({metres, "--limit", height + "<120 cm", "--duration", "1h"}), 1);
  // In floating point 0.57 m is 56.99999999999999 cm.
  EXPECT_EQ(windows({centimetres, "--column", "Hs=" + height + ":cm", "--limit", height + "<=0.57",
                     "--duration", "1h"}),
            2);
}

TEST_F(WorkabilityCommand, StartsAreHeldToTheHours) {
  const std::string file = store_.write("daily.csv", daily_calm(10));
  const Arguments base{file,         "--column", "Hs=" + height + ":m", "--limit", height + "<=1.5",
                       "--duration", "10h"};
  EXPECT_EQ(answer(base).at("workable_starts"), 30) << "06, 07 and 08 of ten days";
  Arguments late = base;
  late.insert(late.end(), {"--start-hours", "7-18"});
  EXPECT_EQ(answer(late).at("workable_starts"), 20);
  Arguments local = late;  // 07:00 in Berlin is 06:00 UTC
  local.insert(local.end(), {"--timezone", "Europe/Berlin"});
  EXPECT_EQ(answer(local).at("workable_starts"), 30);
  EXPECT_EQ(answer(local).at("time_zone"), "Europe/Berlin");
  Arguments careful = base;
  careful.insert(careful.end(), {"--contingency", "2h"});
  EXPECT_EQ(answer(careful).at("workable_starts"), 10);
}

TEST_F(WorkabilityCommand, GapsAreCountedAsInaccessibleAndSaid) {
  std::string text = daily_calm(10);
  const auto from = text.find("2002-01-03T08");
  text.erase(from, text.find("2002-01-03T12") - from);
  const std::string file = store_.write("gap.csv", text);
  const Arguments arguments{file,         "--column", "Hs=" + height + ":m", "--limit", "Hs<=1.5",
                            "--duration", "6h"};
  const json found = answer(arguments);
  EXPECT_EQ(found.at("steps"), 240);
  EXPECT_EQ(found.at("missing_steps"), 4);
  EXPECT_EQ(found.at("gaps"),
            (json{{"count", 1}, {"longest_h", 4.0}, {"longest_from", "2002-01-03T08:00:00Z"}}));
  EXPECT_EQ(found.at("windows"), 11);
  EXPECT_EQ(found.at("workable_windows"), 10) << "two hours before the gap, six behind it";
  EXPECT_NE(run(arguments).out.find("4 of them missing in 1 gap, the longest 4 h from "
                                    "2002-01-03T08:00:00Z: they count as not accessible"),
            std::string::npos);
}

TEST_F(WorkabilityCommand, SeveralFilesAreJoined) {
  const std::string all = daily_calm(6);
  const std::string head = all.substr(0, all.find('\n') + 1);
  const auto cut = all.find("2002-01-04T00");
  const std::string first = store_.write("first.csv", all.substr(0, cut));
  const std::string second = store_.write("second.csv", head + all.substr(cut));
  const std::string whole = store_.write("whole.csv", all);
  const Arguments rest{"--column", "Hs=" + height + ":m", "--limit", "Hs<=1.5", "--duration",
                       "3h",       "--start-hours",       "6-9"};
  const auto ask = [&](Arguments files) {
    files.insert(files.end(), rest.begin(), rest.end());
    json found = answer(files);
    found.erase("source");
    return found;
  };
  EXPECT_EQ(ask({second, first}), ask({whole}));
  Arguments twice{first, whole};
  twice.insert(twice.end(), rest.begin(), rest.end());
  expect_refused(twice, 3, {"do not overlap", "2002-01-01T00:00:00Z"});
}

TEST_F(WorkabilityCommand, AsksTheStoreAtASite) {
  const UtcDay day = parse_day("2025-03-06");
  store_.ingest_days(day, 3);
  const json found = answer({"--site", store_.site(), "--limit", "sea_water_speed<=0.3", "--limit",
                             height + "<=3", "--depth", "10", "--duration", "2h"});
  EXPECT_GT(found.at("steps").get<int>(), 48);
  EXPECT_GT(found.at("windows").get<int>(), 3) << "slack water comes several times a day";
  const double slower = found.at("limits").at(0).at("holds").get<double>();
  EXPECT_GT(slower, 0.02);
  EXPECT_LT(slower, 0.98);
  expect_refused({"--site", store_.site(), "--limit", "sea_water_speed<=0.3", "--duration", "2h"},
                 3, {"--depth"});
  expect_refused({"--site", store_.site(), "--limit", "visibility_in_air>=500", "--duration", "2h"},
                 4, {"found no visibility_in_air", "sea_water_speed"});
}

TEST_F(WorkabilityCommand, ACampaignIsSimulatedInEveryYear) {
  const std::string file = store_.write("daily.csv", daily_calm(3 * 365));
  const std::string campaign = store_.write("campaign.yaml",
                                            "name: Two jobs\n"
                                            "begin: [04-01, 12-30]\n"
                                            "limits: [Hs<=1.5]\n"
                                            "tasks:\n"
                                            "  - {name: short, times: 3, duration: 5h}\n"
                                            "  - name: long\n"
                                            "    duration: 30h\n"
                                            "    split: {shortest_visit: 4h, lost: 2h}\n"
                                            "    working_hours: 6-18\n");
  const Arguments arguments{file, "--column", "Hs=" + height + ":m", "--campaign", campaign};
  const json found = answer(arguments);
  // Two short jobs of the first day end at 16:00, the third at 11:00 of the second. That leaves
  // seven hours, five of them work; the third day ten, the fourth ten, the fifth five: 13:00.
  const json& april = found.at("seasons").at(0);
  EXPECT_EQ(april.at("years"), 3);
  EXPECT_EQ(april.at("elapsed_h").at("p50"), 4 * 24 + 13);
  EXPECT_EQ(april.at("completion").at("p50"), "04-05");
  EXPECT_EQ(april.at("by_year").at(1).at("end"), "2003-04-05T13:00:00Z");
  const json& december = found.at("seasons").at(1);
  EXPECT_EQ(december.at("censored_years"), 1);
  EXPECT_EQ(december.at("completion").at("p90"), "01-03 +1y");
  EXPECT_EQ(found.at("work_h"), 45);
  const ProgramResult text = run(arguments);
  EXPECT_EQ(text.out.rfind("Two jobs: 45 h of work without the weather.\n", 0), 0U) << text.out;
  EXPECT_NE(text.out.find("the series ends before the campaign does: 1 of all campaigns"),
            std::string::npos);
}

TEST_F(WorkabilityCommand, ACampaignComparesFleets) {
  const std::string file = store_.write("daily.csv", daily_calm(60));
  const std::string campaign = store_.write("fleets.yaml",
                                            "name: Six jobs\n"
                                            "begin: [01-10]\n"
                                            "teams: [1, 2, 6]\n"
                                            "limits: [Hs<=1.5]\n"
                                            "tasks: [{name: job, times: 6, duration: 5h}]\n");
  const Arguments arguments{file, "--column", "Hs=" + height + ":m", "--campaign", campaign};
  const json seasons = answer(arguments).at("seasons");
  ASSERT_EQ(seasons.size(), 3U);
  // Two jobs a team and day, from 06:00 to 16:00: three days, then two with the third job of each
  // ending at 11:00, then one.
  const std::vector<int> elapsed_h{2 * 24 + 16, 24 + 11, 11};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(seasons[i].at("teams"), (std::vector<int>{1, 2, 6}[i]));
    EXPECT_EQ(seasons[i].at("elapsed_h").at("p50"), elapsed_h[i]);
  }
  const ProgramResult text = run(arguments);
  EXPECT_NE(text.out.find("teams  begun"), std::string::npos) << text.out;
}

TEST_F(WorkabilityCommand, BadCampaignsAreRefusedWithFileAndKey) {
  const std::string file = store_.write("example.csv", example);
  const auto refused = [&](const std::string& yaml, const std::vector<std::string>& words) {
    std::vector<std::string> all = words;
    all.emplace_back("bad.yaml");
    expect_refused({file, "--campaign", store_.write("bad.yaml", yaml)}, 3, all);
  };
  const std::string limits = "limits: [" + height + "<=1.5]\n";
  refused(limits, {"tasks"});
  refused("tasks: [{name: a, duration: 3h}]\n", {"limits"});
  refused(limits + "tasks: [{name: a, duration: 0h}]\n", {"duration"});
  refused(limits + "tasks: [{name: a, duration: 3h, limts: []}]\n", {"did you mean 'limits'"});
  refused(limits + "begin: [april]\ntasks: [{name: a, duration: 3h}]\n", {"04-01"});
  refused(limits + "tasks: [{name: a, duration: 3h, split: {shortest_visit: 1h, lost: 1h}}]\n",
          {"lost"});
  refused(limits + "teams: [0]\ntasks: [{name: a, duration: 3h}]\n", {"teams: found 0"});
  refused(limits + "teams: [1.5]\ntasks: [{name: a, duration: 3h}]\n", {"teams", "fraction"});
  refused(limits + "teams: [2, 2]\ntasks: [{name: a, duration: 3h}]\n", {"found 2 twice"});
  refused("limits: [Hs]\ntasks: [{name: a, duration: 3h}]\n", {"limits", "without <="});
  expect_refused({file, "--campaign", store_.path("none.yaml")}, 4, {"none.yaml"});
  expect_refused({file, "--campaign",
                  store_.write("long.yaml", limits + "tasks: [{name: a, duration: 3d}]\n")},
                 3, {"longer than the series"});
  expect_refused({file, "--campaign", store_.path("bad.yaml"), "--duration", "3h"}, 2,
                 {"--campaign"});
}

TEST_F(WorkabilityCommand, WhatCannotBeAskedIsRefused) {
  const std::string file = store_.write("example.csv", example);
  const std::string limit = height + "<=1.5";
  expect_refused({"--limit", limit, "--duration", "3h"}, 2, {"series", "--site"});
  expect_refused({file, "--duration", "3h"}, 2, {"--limit"});
  expect_refused({file, "--limit", limit}, 2, {"--duration"});
  expect_refused({file, "--limit", limit, "--duration", "0h"}, 2, {"--duration", "more than 0"});
  expect_refused({file, "--limit", limit, "--duration", "-3h"}, 2, {"--duration"});
  expect_refused({file, "--limit", limit, "--duration", "long"}, 2, {"--duration"});
  expect_refused({file, "--limit", limit, "--duration", "10h"}, 3,
                 {"longer than the series", "9 h"});
  expect_refused({file, "--limit", limit, "--duration", "8h", "--contingency", "2h"}, 3,
                 {"longer than the series"});
  expect_refused({file, "--limit", height, "--duration", "3h"}, 2, {"--limit", "without <="});
  expect_refused({file, "--limit", height + "<=nan", "--duration", "3h"}, 2, {"finite"});
  expect_refused({file, "--limit", height + "<=1,5", "--duration", "3h"}, 2, {"1.5"});
  expect_refused({file, "--limit", limit, "--duration", "3h", "--start-hours", "18"}, 2,
                 {"--start-hours"});
  expect_refused({file, "--limit", limit, "--duration", "3h", "--timezone", "Berlin"}, 2,
                 {"Europe/Berlin"});
  expect_refused({file, "--limit", limit, "--duration", "3h", "--column", "Hs"}, 2, {"--column"});
  expect_refused({file, "--limit", limit, "--duration", "3h", "--site", "x"}, 2, {"--site"});
  expect_refused({file, "--limit", limit, "--duration", "3h", "--from", "2003-01-01"}, 4,
                 {"--from"});
}

TEST_F(WorkabilityCommand, LimitsThatCannotBeAreRefused) {
  const std::string file = store_.write("example.csv", example);
  const auto refused = [&](const Arguments& limits, int exit_code,
                           const std::vector<std::string>& words) {
    Arguments arguments{file, "--duration", "3h"};
    for (const std::string& limit : limits) {
      arguments.emplace_back("--limit");
      arguments.push_back(limit);
    }
    expect_refused(arguments, exit_code, words);
  };
  refused({height + "<=-1"}, 3, {"can never hold", "0 and 35 m"});
  refused({height + ">=5000 cm"}, 3, {"can never hold"});
  refused({height + "<=1", height + ">=2"}, 3, {"can never hold together"});
  refused({height + "<1", height + ">=1"}, 3, {"can never hold together"});
  refused({height + "<=1.5 s"}, 3, {"'s', which does not convert to 'm'"});
  refused({height + "<=1.5 furlongs per blink"}, 3, {"does not convert"});
  refused({"sea_surface_wave_significant_hight<=1.5"}, 4, {"did you mean '" + height});
  refused({"wind_speed<=12"}, 4, {"found no wind_speed", "--column 'NAME=wind_speed:UNIT'"});
  const ProgramResult idle = run({file, "--duration", "3h", "--limit", height + "<=150"});
  EXPECT_EQ(idle.exit_code, 0);
  EXPECT_NE(idle.err.find("is never exceeded"), std::string::npos) << idle.err;
}

TEST_F(WorkabilityCommand, BadSeriesAreRefused) {
  const auto refused = [&](const std::string& text, const Arguments& more,
                           const std::vector<std::string>& words, int exit_code = 3) {
    Arguments arguments{store_.write("bad.csv", text), "--limit", height + "<=1.5", "--duration",
                        "1h"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    std::vector<std::string> all = words;
    all.emplace_back("bad.csv");
    expect_refused(arguments, exit_code, all);
  };
  const std::string head = "time," + height + "\n2002-01-01T00:00Z,1\n";
  refused(head, {}, {"found one time"});
  refused(head + "2002-01-01T01:00Z,1\n2002-01-01T02:20Z,1\n", {}, {"not regular"});
  refused(head + "2002-01-01T01:00Z,1\n", {"--column", "hight=" + height + ":m"},
          {"found no column 'hight'"}, 4);
  refused(head + "2002-01-01T01:00Z,1\n", {"--time-column", "when"}, {"'when'"});
  expect_refused({store_.path("none.csv"), "--limit", height + "<=1.5", "--duration", "1h"}, 4,
                 {"none.csv"});
}

/// Whatever a damaged file does to the library that reads it, it is one error.
TEST_F(WorkabilityCommand, ADamagedNetcdfIsOneError) {
  const std::string file = store_.path("damaged.nc");
  std::ofstream(file, std::ios::binary) << "\x89HDF\r\n\x1a\n" << std::string(4000, '\x07');
  expect_refused({file, "--limit", height + "<=1.5", "--duration", "1h"}, 3, {"damaged.nc"});
}

/// Published: hourly, 113952 hours, none missing (the index of the shared data).
TEST_F(WorkabilityCommand, ReadsTheAlphaVentusSeries) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::string file =
      (shared / "data/weather_windows/alpha_ventus_weather_2002_2014.csv").string();
  const json found = answer({file, "--assume-utc", "--column", "waveheight=" + height + ":m",
                             "--limit", height + "<=1.5", "--duration", "12h"});
  EXPECT_EQ(found.at("steps"), 113952);
  EXPECT_EQ(found.at("missing_steps"), 0);
  EXPECT_EQ(found.at("by_month").size(), 12U);
  EXPECT_EQ(found.at("by_year").size(), 13U);
  EXPECT_LT(found.at("by_month").at(0).at("workability").get<double>(),
            found.at("by_month").at(6).at("workability").get<double>())
      << "July is calmer than January";
}

}  // namespace
}  // namespace slackwater::tests::cli_workability_test

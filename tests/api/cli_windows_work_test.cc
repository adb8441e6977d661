// What becomes of the windows: work in several visits, flights of the twin, the plan of a day.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/api/windows_command.h"
#include "twin/risk/risk_cause.h"

namespace slackwater::tests::cli_windows_work_test {
namespace {

TEST_F(WindowsCommand, SplitWorkIsDoneOverSeveralVisits) {
  const auto sheet = [](const std::string& limits) {
    std::string text = peek(limits, "splittable: true\nleast_visit_h: 1\n");
    text.replace(text.find("value: 1.5"), 10, "value: 6.0");
    return text;
  };
  const json open = task_of({"--task", write("split.yaml", sheet(loose)), "--contingency", "0h"});
  EXPECT_EQ(open.at("split").at("least_visit_h"), 1.0);
  // Six hours of work and way are left until 18:00, or the step before, in one visit.
  ASSERT_EQ(open.at("windows").size(), 1U);
  EXPECT_EQ(open.at("windows")[0].at("from"), "2025-03-05T00:00:00Z");
  EXPECT_GE(open.at("windows")[0].at("to"), "2025-03-05T17:30:00Z");
  EXPECT_LE(open.at("windows")[0].at("to"), "2025-03-05T18:00:00Z");
  const json& late = open.at("starts").back().at("binding");
  EXPECT_EQ(late.at("limit"), "hours enough for the work by 2025-03-06T00:00:00Z");
  EXPECT_EQ(late.at("futures"), 25);
  // In one go six hours of a slack tide there are not.
  const std::string slack = "{current_speed_m_s: 0.3}";
  const json split = task_of({"--task", write("split.yaml", sheet(slack)), "--contingency", "0h"});
  std::string whole = peek(slack);
  whole.replace(whole.find("value: 1.5"), 10, "value: 6.0");
  const json at_once = task_of({"--task", write("whole.yaml", whole), "--contingency", "0h"});
  EXPECT_TRUE(at_once.at("split").is_null());
  const auto held = [](const json& task) {
    int sum = 0;
    for (const json& start : task.at("starts")) sum += start.at("futures_held").get<int>();
    return sum;
  };
  EXPECT_GT(held(split), held(at_once));
  expect_refused({"--task", write("bad.yaml", peek(loose, "least_visit_h: 1\n"))}, 3,
                 {"least_visit_h", "splittable"});
}

TEST_F(WindowsCommand, FliesTheStartsThatTheLimitsLeaveOpen) {
  const std::string at = "2025-03-05T06:00:00Z";
  const auto flown = [&](const std::string& limits) {
    return task_of({"--task", write("peek.yaml", peek(limits)), "--from", at, "--to",
                    "2025-03-05T08:00:00Z", "--members", "2", "--fly", "10min"});
  };
  const json open = flown(loose);
  ASSERT_EQ(open.at("starts").size(), 4U);
  // An hour apart, all of them in both futures, which are too few for a narrow interval.
  for (std::size_t i = 0; i < 4; ++i) {
    const json& twin = open.at("starts")[i].at("twin");
    ASSERT_EQ(twin.is_null(), i % 2 == 1) << i;
    if (twin.is_null()) continue;
    EXPECT_EQ(twin.at("flights"), 2);
    EXPECT_EQ(twin.at("probability"), 1);
    EXPECT_LT(twin.at("interval_95")[0].get<double>(), 0.5);
    EXPECT_GT(twin.at("duration_s").at("p50").get<double>(), 240);
    EXPECT_GT(twin.at("energy_wh").at("p90").get<double>(), 1);
    EXPECT_EQ(twin.at("risks").size(), twin::risk_cause_count);
  }
  const json shut = flown(never);
  for (const json& start : shut.at("starts")) EXPECT_TRUE(start.at("twin").is_null());
}

/// Nothing but the waves stops these flights. They are over sooner than the hour and a half, and
/// the contingency, throughout which the limit is held: where it holds the flight is done.
TEST_F(WindowsCommand, FliesInTheWavesThatTheLimitsAreHeldAgainst) {
  const auto start_of = [&](const std::string& waves) {
    return task_of({"--task", write("near.yaml", peek("{significant_wave_height_m: 2.0}")),
                    "--from", "2025-03-05T06:00:00Z", "--to", "2025-03-05T06:30:00Z", "--members",
                    "8", "--waves", waves, "--fly", "10min"})
        .at("starts")[0];
  };
  const json as_forecast = start_of("forecast"), errs = start_of("error");
  ASSERT_EQ(as_forecast.at("futures_held"), as_forecast.at("futures"));
  ASSERT_EQ(as_forecast.at("twin").at("probability"), 1);
  ASSERT_EQ(errs.at("futures"), 1993);
  const double held = 8 * errs.at("futures_held").get<double>() / 1993;
  const json& twin = errs.at("twin");
  const double done = twin.at("probability").get<double>() * twin.at("flights").get<double>();
  EXPECT_GT(held, 0);
  EXPECT_LT(held, 8);
  EXPECT_LT(twin.at("probability").get<double>(), 1) << twin;
  EXPECT_EQ(twin.at("flights"), 8);
  EXPECT_NEAR(done, held, 2.5) << "eight of the same sea";
  EXPECT_NE(twin.at("stopped_by").dump().find("significant wave height"), std::string::npos)
      << twin;
}

TEST_F(WindowsCommand, AreWhatThePlanOfADayIsMadeOf) {
  const std::string task = write("peek.yaml", peek(loose));
  const std::string plan = write("plan.yaml",
                                 "name: A day\nsite: farm.yaml\nday: 2025-03-05\nvessels: [{id: "
                                 "boat, crews: 1, speed_kn: 20, hours: 06:00-18:00}]\ncrews: [{id: "
                                 "blue, skills: [rov], shift: 06:00-18:00}]\nvehicles: [{id: rov1, "
                                 "kind: rov}]\ntasks: [{task: " +
                                     task + ", turbines: [T1], vehicles: [rov], skills: [rov]}]\n");
  const auto planned = [&](Arguments more) {
    more.insert(more.begin(), {"plan", plan, "--json"});
    const ProgramResult result = made_->run(more);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::accept(result.out) ? json::parse(result.out) : json();
  };
  const json of_forecast = planned({});
  const std::string file =
      write("windows.json", answer({"--task", task, "--every", "15min"}).dump());
  const json of_file = planned({"--windows", file});
  ASSERT_EQ(of_forecast.at("jobs").size(), 1U) << of_forecast.dump(1);
  EXPECT_EQ(of_forecast.at("jobs"), of_file.at("jobs"));
}

}  // namespace
}  // namespace slackwater::tests::cli_windows_work_test

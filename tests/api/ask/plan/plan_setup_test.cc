// A plan's file and the windows of its day become a problem.
#include "api/ask/plan/plan_setup.h"

#include <gtest/gtest.h>

#include "api/door/cli/decide/windows_file.h"
#include "fields/base/error.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::plan_setup_test {
namespace {

using namespace slackwater::api;

const std::string windows_head = R"({"site": "farm", "day": "2025-06-02", "tasks": [)";

class PlanSetup : public testing::Test {
 protected:
  /// @param site  what the site's file says beside the turbines
  PlanFile plan(const std::string& tasks, const std::string& site = "") const {
    static_cast<void>(files_.write("farm.yaml",
                                   "id: farm\nname: Farm\nlatitude_deg: 54\nlongitude_deg: 6\n"
                                   "water_depth_m: 30\n" +
                                       site +
                                       "turbines:\n"
                                       "  - {id: A01, latitude_deg: 54.0, longitude_deg: 6.0}\n"
                                       "  - {id: A02, latitude_deg: 54.1, longitude_deg: 6.0}\n"));
    const std::string file =
        files_.write("plan.yaml",
                     "site: farm.yaml\n"
                     "vessels:\n"
                     "  - {id: ctv, speed_kn: 20, hours: 06:00-18:00, port: {latitude_deg: 53.9, "
                     "longitude_deg: 6}}\n"
                     "crews:\n  - {id: crew, skills: [rov], shift: 06:00-18:00}\n"
                     "vehicles:\n  - {id: rov1, kind: rov}\n"
                     "tasks:\n" +
                         tasks);
    return load_plan_file(file, files_.store());
  }
  PlanProblem problem(const PlanFile& plan, const std::string& tasks) const {
    return problem_of(plan, parse_windows(windows_head + tasks + "]}", "windows.json"), 0);
  }
  std::string refusal(const PlanFile& plan, const std::string& tasks) const {
    try {
      static_cast<void>(problem(plan, tasks));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      return error.message();
    }
    return {};
  }

  StoreForTests files_;
  const std::string cp_ = "  - {task: cp_anode, turbines: [A01]}\n";
};

const std::string hourly = R"({"task": "cp_anode", "turbine": "A01", "duration_h": 2,
  "contingency_h": 0.5, "starts": [
    {"start": "2025-06-02T06:00:00Z", "probability": 0.9},
    {"start": "2025-06-02T07:00:00Z", "probability": 0.6,
     "duration_h": {"p50": 2, "p90": 2.4}, "energy_wh": {"p90": 150}},
    {"start": "2025-06-02T09:00:00Z", "probability": 0.8}]})";

TEST_F(PlanSetup, TakesTheWorseNeighbourBetweenStartsThatAreAnHourApartAndNothingAcrossGaps) {
  const PlanProblem day = problem(plan(cp_), hourly);
  ASSERT_EQ(day.jobs.size(), 1U);
  const PlanJob& job = day.jobs[0];
  EXPECT_EQ(job.id, "cp_anode@A01");
  EXPECT_EQ(job.vehicles, (std::vector<std::vector<std::string>>{{"rov"}}));
  EXPECT_EQ(job.contingency_min, 30);
  ASSERT_EQ(job.starts.size(), 6U);  // 06:00, :15, :30, :45, 07:00, 09:00
  EXPECT_EQ(job.starts[0].slot, 24U);
  EXPECT_EQ(job.starts[0].probability, 0.9);
  EXPECT_EQ(job.starts[0].hold_min, 120);
  for (std::size_t i = 1; i <= 4; ++i) {
    EXPECT_EQ(job.starts[i].probability, 0.6);
    EXPECT_EQ(job.starts[i].hold_min, 144);
    EXPECT_EQ(job.starts[i].energy_wh, 150);
  }
  EXPECT_EQ(job.starts[5].slot, 36U);
}

TEST_F(PlanSetup, WhatFlightsLeaveOfAStartGoesBeforeWhatItsLimitsSay) {
  const PlanProblem day = problem(plan(cp_), R"({"task": "cp_anode", "turbine": "A01",
    "duration_h": 2, "starts": [
      {"start": "2025-06-02T06:00:00Z", "probability": 0.9, "worth": 0.2}]})");
  ASSERT_EQ(day.jobs[0].starts.size(), 1U);
  EXPECT_EQ(day.jobs[0].starts[0].probability, 0.2);
}

TEST_F(PlanSetup, RoundsTheWayOfAVesselUpToMinutes) {
  const PlanProblem day = problem(plan(cp_), hourly);
  const PlanVessel& vessel = day.vessels[0];
  ASSERT_TRUE(vessel.port);
  // A tenth of a degree of latitude is 11.13 km here; at 20 kn that is 18.03 minutes.
  EXPECT_EQ(vessel.way_min[*vessel.port][0], 19);
  EXPECT_EQ(vessel.way_min[0][1], 19);
  EXPECT_EQ(vessel.way_min[*vessel.port][1], 37);
  EXPECT_EQ(vessel.way_min[1][1], 0);
}

TEST_F(PlanSetup, PutsHoursOnTheSitesClocks) {
  const PlanFile file = plan(cp_, "timezone: Europe/Berlin\n");
  const PlanProblem day = problem(file, hourly);
  EXPECT_EQ(day.vessels[0].hours, (PlanHours{4 * 60, 16 * 60}));  // summer time
}

TEST_F(PlanSetup, LeavesOutStartsInTheDarkAndInAClosedArea) {
  // By NOAA's formula the sun rises there at 03:10 UTC that day and sets at 19:57.
  const std::string task =
      "  - {task: cp_anode, turbines: [A01, A02], duration: 1h, contingency: 0h, "
      "daylight: sun_up}\n";
  std::string starts;
  for (int hour = 0; hour < 24; ++hour)
    starts += std::string(hour == 0 ? "" : ", ") + R"({"start": "2025-06-02T)" +
              (hour < 10 ? "0" : "") + std::to_string(hour) + R"(:00:00Z", "probability": 0.9})";
  const std::string windows =
      R"({"task": "cp_anode", "duration_h": 2, "starts": [)" + starts + "]}";
  PlanProblem day = problem(plan(task), windows);
  ASSERT_EQ(day.jobs.size(), 2U);
  EXPECT_EQ(day.minute_of(day.jobs[0].starts.front().slot), 3 * 60 + 15);
  EXPECT_EQ(day.minute_of(day.jobs[0].starts.back().slot), 18 * 60 + 45);
  EXPECT_EQ(day.jobs[0].without_starts, "it needs daylight (sun_up)");
  day = problem(plan(task,
                     "areas:\n"
                     "  - id: terns\n    kind: exclusion\n    reason: breeding terns\n"
                     "    hours_utc: [5, 11]\n    polygon:\n"
                     "      - {latitude_deg: 53.99, longitude_deg: 5.99}\n"
                     "      - {latitude_deg: 53.99, longitude_deg: 6.01}\n"
                     "      - {latitude_deg: 54.01, longitude_deg: 6.01}\n"
                     "      - {latitude_deg: 54.01, longitude_deg: 5.99}\n"),
                windows);
  for (const JobStart& start : day.jobs[0].starts) {
    const Minute begin = day.minute_of(start.slot);
    EXPECT_TRUE(begin + 60 <= 5 * 60 || begin >= 12 * 60) << begin;
  }
  EXPECT_EQ(day.jobs[1].starts.size(), 63U) << "A02 lies outside";
}

TEST_F(PlanSetup, RefusesWindowsOfAnotherSiteOrDayOrWithoutATask) {
  const PlanFile file = plan(cp_);
  EXPECT_EQ(refusal(file, R"({"task": "biofouling", "duration_h": 2, "starts": []})"),
            "windows.json: found no starts of cp_anode at A01, which the plan asks for; make the "
            "windows of this task too");
  const auto of = [&](const std::string& json) {
    try {
      PlanFile dated = file;
      dated.day = parse_day("2025-06-02");
      static_cast<void>(problem_of(dated, parse_windows(json, "w"), 0));
    } catch (const Error& error) {
      return error.message();
    }
    return std::string();
  };
  EXPECT_EQ(of(R"({"site": "elsewhere", "day": "2025-06-02", "tasks": []})"),
            "w: found windows of elsewhere, expected those of farm, the plan's site");
  EXPECT_EQ(of(R"({"site": "farm", "day": "2025-06-03", "tasks": []})"),
            "w: found windows of 2025-06-03, expected those of 2025-06-02, the plan's day; make "
            "them anew, or change `day`");
}

TEST_F(PlanSetup, RefusesATaskThatIsLongerThanTheDay) {
  const PlanFile file =
      plan("  - {task: cp_anode, turbines: [A01], duration: 11h, contingency: 1h}\n");
  EXPECT_NE(refusal(file, hourly)
                .find("cp_anode@A01: found 12.0 h of work with its contingency, "
                      "longer than the day: 11.4 h are left"),
            std::string::npos)
      << refusal(file, hourly);
}

TEST_F(PlanSetup, NamesThePlaceInWindowsThatAreWrong) {
  const auto refused = [](const std::string& json) {
    try {
      static_cast<void>(parse_windows(json, "w"));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      return error.message();
    }
    return std::string("accepted");
  };
  const auto with = [](const std::string& start) {
    return windows_head + R"({"task": "t", "duration_h": 1, "starts": [)" + start + "]}]}";
  };
  EXPECT_EQ(refused("{\"site\": \"farm\", "),
            "w: not valid JSON at byte 18 of 17; was it written to the end?");
  EXPECT_EQ(refused("[]"), "w: found [] where an object was expected");
  EXPECT_EQ(refused("{}"), "w: found no 'site', expected one");
  EXPECT_EQ(refused(R"({"site": 3})"), "w: site: found 3 where a text was expected");
  EXPECT_NE(refused(R"({"site": "a", "day": "June", "tasks": []})").find("w: day: found 'June'"),
            std::string::npos);
  EXPECT_EQ(refused(R"({"site": "a", "day": "2025-06-02", "tasks": 1})"),
            "w: tasks: found 1 where a list was expected");
  EXPECT_EQ(refused(with(R"({"start": "2025-06-02T06:00:00Z", "probability": 1.5})")),
            "w: tasks[0].starts[0].probability: found 1.5, expected 0 to 1");
  EXPECT_EQ(refused(with(R"({"start": "2025-06-02T06:00:00Z", "probability": "high"})")),
            "w: tasks[0].starts[0].probability: found \"high\" where a number was expected");
  EXPECT_EQ(
      refused(with(R"({"start": "2025-06-02T06:00:00Z", "probability": 1, "duration_h": -1})")),
      "w: tasks[0].starts[0].duration_h: found -1, expected 0 to 744");
  EXPECT_EQ(
      refused(with(R"({"start": "2025-06-02T06:00:00Z", "probability": 1, "duration_h": 0})")),
      "w: tasks[0].starts[0].duration_h: found 0, expected more");
  EXPECT_EQ(refused(with(R"({"start": "2025-06-02T06:00:00Z", "probability": 1},
                            {"start": "2025-06-02T06:00:00Z", "probability": 1})")),
            "w: tasks[0].starts[1].start: found 2025-06-02T06:00:00Z after 2025-06-02T06:00:00Z, "
            "expected times that go forward, each once");
  EXPECT_EQ(refused(windows_head + R"({"task": "t", "duration_h": 1, "starts": []},
                                      {"task": "t", "duration_h": 1, "starts": []}]})"),
            "w: tasks[1]: found t at all turbines a second time; keep one");
  EXPECT_NE(refused(std::string(100, '[') + std::string(100, ']')).find("nested deeper"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::plan_setup_test

// Logs as they are read to be watched again, and those that are refused.
#include "api/door/people/playback/logged_run.h"

#include <gtest/gtest.h>

#include <fstream>

#include "api/log/account_tables.h"
#include "api/log/traffic_tables.h"
#include "tests/api/door/people/playback/log_for_tests.h"
#include "tests/support/contains.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::logged_run_test {
namespace {

using ingest::TrajectoryFile;

std::string problem_of(const TrajectoryFile& log) {
  const TemporaryFolder folder;
  ingest::write_trajectories(log, folder / "log.nc");
  return error_of([&] { (void)people::read_logged_run(folder / "log.nc", folder.path()); });
}

TEST(LoggedRun, IsRefusedWithoutPositions) {
  TrajectoryFile log = made_up_log();
  log.variables.erase(log.variables.begin() + 2);
  EXPECT_TRUE(contains(problem_of(log),
                       "log.nc: found no positions (variables x, y and z); give a "
                       "log that"));
}

TEST(LoggedRun, IsRefusedWhoseTimesDoNotGoOn) {
  TrajectoryFile log = made_up_log();
  log.t_s[30] = 29;
  EXPECT_TRUE(contains(problem_of(log), "found the time 29 s in row 30"));
}

TEST(LoggedRun, IsRefusedWhoseNumbersMeanNothing) {
  TrajectoryFile log = made_up_log();
  log.variables[4].values[3] = 77;
  EXPECT_TRUE(contains(problem_of(log), "found 77 as halt"));
  log = made_up_log();
  log.variables.push_back({"velocity_body", "", "m s-1", "", 1, log.variables[0].values});
  EXPECT_TRUE(contains(problem_of(log), "found 1 numbers of velocity_body a vehicle and time"));
}

TEST(LoggedRun, IsRefusedThatIsDamagedOrNoLogAtAll) {
  const TemporaryFolder folder;
  const auto problem = [&] {
    return error_of([&] { (void)people::read_logged_run(folder / "log.nc", folder.path()); });
  };
  EXPECT_TRUE(contains(problem(), "log.nc"));
  std::ofstream(folder / "log.nc") << "these are no tracks";
  EXPECT_TRUE(contains(problem(), "log.nc"));
  ingest::write_trajectories(made_up_log(), folder / "log.nc");
  std::filesystem::resize_file(folder / "log.nc",
                               std::filesystem::file_size(folder / "log.nc") / 2);
  EXPECT_TRUE(contains(problem(), "log.nc"));
}

TEST(LoggedRun, OfAnotherVersionIsShownWithoutItsScenario) {
  TrajectoryFile log = made_up_log();
  log.attributes.emplace_back("scenario", "of: another age");
  const TemporaryFolder folder;
  ingest::write_trajectories(log, folder / "log.nc");
  const people::LoggedRun run = people::read_logged_run(folder / "log.nc", folder.path());
  EXPECT_EQ(run.vehicles.size(), 2U);
  ASSERT_EQ(run.warnings.size(), 1U);
  EXPECT_TRUE(contains(run.warnings[0], "structures and tasks are left out"));
}

TEST(LoggedRun, TellsPhasesAndAlarmsWhileTheyLasted) {
  using twin::ConductEventKind;
  TrajectoryFile log = made_up_log();
  twin::RunAccount account;
  account.vehicles.resize(2);
  account.vehicles[0].mission = {
      {5, ConductEventKind::phase_began, {}, "work", {}},
      {10, ConductEventKind::hold_began, twin::Cause::limit, "holds", {}},
      {20, ConductEventKind::resumed, {}, "resumes", {}},
      {30, ConductEventKind::finished, {}, "is done", {}}};
  twin::AlarmRecord alarm;
  alarm.mmsi = 257000001;
  alarm.begin_s = 12;
  alarm.end_s = 15;
  for (auto& table : api::account_tables(account))
    if (table.name == "mission") log.tables.push_back(table);
  twin::TrafficVessel vessel;
  vessel.id = alarm.mmsi;
  for (auto& table : api::traffic_tables({&vessel, 1}, {&alarm, 1}))
    if (table.name == "alarm") log.tables.push_back(table);
  const TemporaryFolder folder;
  ingest::write_trajectories(log, folder / "log.nc");
  const people::LoggedRun run = people::read_logged_run(folder / "log.nc", folder.path());
  const people::LoggedVehicle& vehicle = run.vehicles[0];
  const auto then = [&](double at_s) {
    const people::Moment moment = people::moment_of(run.t_s, at_s);
    return people::vehicle_then(vehicle, people::status_place(vehicle, moment, at_s));
  };
  EXPECT_EQ(then(4).words.phase, "");
  EXPECT_EQ(then(6).words.phase, "work");
  EXPECT_EQ(then(6).words.doing, "");
  EXPECT_EQ(then(10).words.doing, "holds");
  EXPECT_EQ(then(25).words.doing, "");
  EXPECT_EQ(then(31).words.phase, "") << "its mission is over";
  EXPECT_TRUE(then(11).alarms.empty());
  ASSERT_EQ(then(13).alarms.size(), 1U);
  EXPECT_EQ(then(13).alarms[0].alarm.id, 257000001U);
  EXPECT_TRUE(then(16).alarms.empty());
}

}  // namespace
}  // namespace slackwater::tests::logged_run_test

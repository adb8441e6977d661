// Runs that vehicles join: their logs, what is made of these, and the runs made again.
#include <gtest/gtest.h>

#include <fstream>

#include "api/log/account_log.h"
#include "api/log/command_tables.h"
#include "api/log/score.h"
#include "api/show/rehearse/account_text.h"
#include "api/show/rehearse/run_page.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "tests/api/ask/run/logged_runs.h"

namespace slackwater::tests::newcomer_run_test {
namespace {

using namespace api;
using twin::Newcomer;

const std::string yaml = R"(name: joined
seed: 5
duration: 1min
step_s: 0.05
log_every_s: 0.5
log: {sensors: true}
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.3, north_m_s: 0.1}],
                  wind: {speed_m_s: 5, from_deg: 200}}}
waves: {components: 16, partitions: [{significant_height_m: 0.5, peak_period_s: 5, from_deg: 200}]}
gusts: dryden
vehicles:
  - {name: usv, model: wamv16, start: {north_m: -90, east_m: 0, depth_m: 0},
     tasks: [{do: hold}]}
traffic:
  vessels:
    - {mmsi: 211000001, name: COASTER, speed_m_s: 8,
       waypoints: [{north_m: 0, east_m: -300}, {north_m: 0, east_m: 300}]}
)";

/// Lets two in and drives one of them.
class Hosts {
 public:
  void join(const RunInHand& hand) {
    hand_ = std::make_unique<RunInHand>(hand);
    hand.run.at_opening([this](const twin::StepTime& time) { act(time); });
  }

 private:
  void act(const twin::StepTime& time) {
    twin::CommandArbiter& arbiter = hand_->arbiter;
    const double t_s = arbiter.time_s();
    const auto spawn = [&](const Newcomer& newcomer) {
      return arbiter.spawn("dds 01", newcomer, hand_->newcomer_yard, t_s);
    };
    if (time.step == 203) {
      EXPECT_FALSE(spawn({"bluerov2_heavy", "late rov", {20, 0, 12}, 1}));
      EXPECT_TRUE(spawn({"bluerov2_heavy", "late rov", {20, 0, 12}, 1}));
      EXPECT_TRUE(spawn({"/etc/passwd", "other", {20, 0, 12}, 1}));
    }
    if (time.step == 300) {
      const twin::Reroute away{{{{26, 0, 14}, 0.5}}};
      EXPECT_FALSE(arbiter.submit("dds 02", {0, 1, away, "", 1, t_s}, t_s));
    }
    if (time.step == 400) {
      EXPECT_FALSE(spawn({"x500", "late uav", {-20, 10, -30}, 0}));
    }
    if (time.step == 1193) {
      EXPECT_FALSE(spawn({"x500", "last", {-20, -10, -30}, 0}));
    }
  }
  std::unique_ptr<RunInHand> hand_;
};

class RunThatVehiclesJoin : public LoggedRuns {
 protected:
  RunThatVehiclesJoin() : LoggedRuns(yaml) {}
  Made make_joined(const std::string& name, RunChoice choice = {}) {
    choice.on_ready = [this](const RunInHand& hand) { hosts_.join(hand); };
    return make(name, choice);
  }
  [[nodiscard]] std::filesystem::path changed(const ingest::TrajectoryFile& log) const {
    const std::filesystem::path file = folder_.path() / "changed.nc";
    ingest::write_trajectories(log, file);
    return file;
  }

  Hosts hosts_;
};

TEST_F(RunThatVehiclesJoin, IsMadeAgainByItsLogToTheByte) {
  const Made made = make_joined("run.nc");
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  EXPECT_EQ(log.names, (std::vector<std::string>{"usv", "late rov", "late uav", "last"}));
  const std::vector<twin::Command> commands = commands_in(log);
  ASSERT_EQ(commands.size(), 4U);
  EXPECT_EQ(commands[0].agent, 1U);
  EXPECT_EQ(commands[0].step, 203U);
  const Newcomer& joined = std::get<twin::Spawn>(commands[0].what).newcomer;
  EXPECT_EQ(joined.model, "bluerov2_heavy");
  EXPECT_EQ(joined.name, "late rov");
  EXPECT_EQ(joined.position_m.x, 20);
  EXPECT_EQ(joined.heading_rad, 1);
  EXPECT_EQ(made.result.refusals.size(), 2U);
  // Checksums of all that took part.
  const std::string sums = log.attribute("vehicle_files_sha256");
  for (const char* model : {"bluerov2_heavy ", "wamv16 ", "x500 "})
    EXPECT_NE(sums.find(model), std::string::npos) << sums;
  for (const std::size_t threads : {1U, 2U})
    for (const bool is_batch : {true, false}) {
      const ReplayResult again = replayed(made.log, threads, is_batch);
      EXPECT_TRUE(again.is_identical) << again.difference;
    }
}

TEST_F(RunThatVehiclesJoin, HasThemInItsLogFromTheirFirstTimeOn) {
  const Made made = make_joined("run.nc");
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  const auto* x = log.find("x");
  ASSERT_NE(x, nullptr);
  const std::size_t times = log.t_s.size();
  // Joined before step 203, from 10.15 s on: first seen at 10.5 s; the other at 20.5 s.
  for (const auto& [vehicle, from_s] : {std::pair{0U, 0.0}, {1U, 10.5}, {2U, 20.5}, {3U, 60.0}})
    for (std::size_t t = 0; t < times; ++t)
      EXPECT_EQ(std::isfinite(x->values[vehicle * times + t]), log.t_s[t] >= from_s - 1e-9)
          << vehicle << " at " << log.t_s[t];
  for (const twin::VehicleAccount& vehicle : made.result.account.vehicles) {
    const twin::TrackAccount& track = vehicle.track;
    EXPECT_TRUE(std::isfinite(track.sailed_m + track.rms_depth_error_m)) << vehicle.name;
    EXPECT_TRUE(track.least_voltage_v.has_value()) << vehicle.name;
    EXPECT_EQ(vehicle.halt, twin::Halt::none) << vehicle.name;
    EXPECT_TRUE(vehicle.closest.vehicle.has_value()) << vehicle.name;
  }
  const twin::VehicleAccount& rov = made.result.account.vehicles[1];
  EXPECT_GT(rov.track.sailed_m, 5);
  EXPECT_LT(rov.track.sailed_m, 30) << "no way from the origin to where it joined";
  EXPECT_EQ(rov.waypoints, 1U);
  EXPECT_TRUE(rov.closest.vessel.has_value()) << "the traffic passes it too";
}

TEST_F(RunThatVehiclesJoin, EndsInGoodOrderWhereOneHasNoRowYet) {
  twin::RunControl control;
  RunChoice choice;
  choice.control = &control;
  choice.on_ready = [&](const RunInHand& hand) {
    hosts_.join(hand);
    hand.run.at_barrier([&](const twin::StepTime& time) {
      if (time.step == 205) control.stop();
    });
  };
  const Made made = make("run.nc", choice);
  const auto& vehicles = made.result.account.vehicles;
  ASSERT_EQ(vehicles.size(), 2U);
  EXPECT_EQ(vehicles[1].track.sailed_m, 0);
  EXPECT_EQ(vehicles[1].track.rms_depth_error_m, 0);
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  EXPECT_EQ(scored_time_s(scorecard_of(log).account.vehicles[1]), 0);
  EXPECT_FALSE(run_page_html(log, "").empty());
  const ReplayResult again = replayed(made.log);
  EXPECT_TRUE(again.is_identical) << again.difference;
}

TEST_F(RunThatVehiclesJoin, IsScoredAndShownWithThem) {
  const Made made = make_joined("run.nc");
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  const twin::RunAccount account = scorecard_of(log).account;
  ASSERT_EQ(account.vehicles.size(), 4U);
  EXPECT_EQ(account, made.result.account);
  EXPECT_EQ(scored_time_s(account.vehicles[0]), 60);
  EXPECT_NEAR(scored_time_s(account.vehicles[1]), 49.5, 1e-9);
  EXPECT_NEAR(scored_time_s(account.vehicles[2]), 39.5, 1e-9);
  for (const twin::VehicleAccount& vehicle : account.vehicles) {
    EXPECT_TRUE(std::isfinite(vehicle.at_work.rms_depth_error_m)) << vehicle.name;
    EXPECT_TRUE(vehicle.closest.vehicle.has_value()) << vehicle.name;
  }
  std::vector<std::string> told;
  for (const EventLine& event : event_lines(log, account))
    if (event.vehicle > 0) told.push_back(event.what);
  EXPECT_EQ(std::count(told.begin(), told.end(), "joins the run"), 3);
  EXPECT_EQ(std::count(told.begin(), told.end(), "battery on again"), 0);
  const std::string page = run_page_html(log, "");
  EXPECT_NE(page.find("late uav"), std::string::npos);
  EXPECT_EQ(page.find(":nan"), std::string::npos);
}

TEST_F(RunThatVehiclesJoin, GoesOnFromACheckpointBetweenTwoArrivals) {
  const Made whole = make_joined("whole.nc");
  for (const double at_s : {10.2, 15.0}) {  // before and after its first row
    RunChoice choice;
    choice.checkpoint = folder_.path() / "half.checkpoint";
    choice.checkpoint_at_s = at_s;
    (void)make_joined("first.nc", choice);
    RunChoice rest;
    rest.restore = choice.checkpoint;
    rest.threads = 2;
    for (const twin::Command& command : whole.result.commands)
      if (static_cast<double>(command.step) * scenario_.step_s >= at_s - 1e-9)
        rest.record.commands.push_back(command);
    EXPECT_EQ(rest.record.commands.size(), 3U);
    const Made second = make("second.nc", rest);
    EXPECT_EQ(sha256_of_file(second.log), sha256_of_file(whole.log)) << at_s;
  }
}

TEST_F(RunThatVehiclesJoin, IsNotMadeAgainWithAModelThatIsNotOfTheCatalogue) {
  const Made made = make_joined("run.nc");
  ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  for (ingest::TrajectoryTable& table : log.tables)
    if (table.name == "content") table.columns[0].values[1] = '/';
  try {
    (void)replayed(changed(log));
    ADD_FAILURE() << "was made again";
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::not_found);
    EXPECT_NE(e.message().find("found '/luerov2_heavy'"), std::string::npos) << e.message();
  }
}

TEST_F(RunThatVehiclesJoin, ARecordWhoseVehiclesDoNotFitIsRefusedWithOneSentence) {
  const Made made = make_joined("run.nc");
  const ingest::TrajectoryFile log = ingest::read_trajectories(made.log);
  const auto with = [&](const char* table, const char* column, std::size_t row, double value) {
    ingest::TrajectoryFile other = log;
    for (ingest::TrajectoryTable& t : other.tables)
      for (auto& c : t.columns)
        if (t.name == table && c.name == column) c.values[row] = value;
    return changed(other);
  };
  // A command for one that joins after it, a place that is none, a name without end.
  EXPECT_THROW((void)replayed(with("command", "vehicle", 1, 2)), Error);
  EXPECT_THROW((void)replayed(with("content", "value", 0, 1e300)), Error);
  EXPECT_THROW((void)replayed(with("content", "value", 0, 3)), Error);
  EXPECT_THROW((void)replayed(with("content", "value", 2, -1)), Error);
  EXPECT_THROW((void)replayed(with("content", "value", 26, std::nan(""))), Error);
}

}  // namespace
}  // namespace slackwater::tests::newcomer_run_test

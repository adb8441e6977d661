// `slackwater simulate --checkpoint / --restore`: a run that is taken up leaves the bytes of one
// that never stopped.
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <thread>

#include "fields/base/encode/sha256.h"
#include "ingest/cf/trajectory_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_checkpoint_test {
namespace {

using nlohmann::json;

/// Everything a state can hold: tether, gusts, a route under way and one replaced by the published
/// follower, instruments.
const std::string scenario = R"(name: stands still half way
seed: 5
duration: 3min
step_s: 0.05
log_every_s: 0.5
log: {sensors: true}
navigation: sensors
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0.1}],
                  wind: {speed_m_s: 5, from_deg: 200}}}
waves: {components: 32, partitions: [{significant_height_m: 0.5, peak_period_s: 5, from_deg: 200}]}
gusts: dryden
traffic:
  alarm: {cpa_m: 60, tcpa_min: 1}
  vessels:
    - {mmsi: 1, name: FERRY, speed_m_s: 6,
       waypoints: [{north_m: 300, east_m: 20}, {north_m: -900, east_m: 20}]}
    - {mmsi: 2, name: LAUNCH, speed_m_s: 1.2,
       waypoints: [{north_m: -90, east_m: 0}, {north_m: -90, east_m: 300}]}
structures:
  - {kind: cylinder, north_m: 0, east_m: 30, diameter_m: 6, top_height_m: 20,
     bottom_depth_m: 40}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 12}
    tether: {top: {north_m: -10, east_m: 0, depth_m: 1}, length_m: 40}
    tasks:
      - {do: route, waypoints: [{north_m: 6, east_m: 0, depth_m: 12},
                               {north_m: 6, east_m: 9, depth_m: 14}]}
      - {do: hold}
  - {name: follower, model: bluerov2_heavy, follow: public, navigation: truth,
     start: {north_m: 20, east_m: 0, depth_m: 12},
     tasks: [{do: route, waypoints: [{north_m: 40, east_m: 0, depth_m: 12}]}]}
  - {name: auv, model: lrauv_tethys, start: {north_m: -50, east_m: 0, depth_m: 0},
     tasks: [{do: hold}]}
  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 20}, tasks: [{do: hold}]}
  - {name: usv, model: wamv16, start: {north_m: -90, east_m: 0, depth_m: 0},
     tasks: [{do: follow_track, mmsi: 2}]}
)";

class CheckpointFile : public testing::Test {
 protected:
  void SetUp() override { write("run.yaml", scenario); }
  std::string write(const std::string& name, const std::string& text) const {
    return made_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(path(name));
  }
  /// A whole run to `run.nc` that leaves `at.checkpoint` on its way.
  void run_whole(const std::string& at = "1min") const {
    const ProgramResult run =
        made_.run({"simulate", path("run.yaml"), "--out", path("run.nc"), "--checkpoint",
                   path("at.checkpoint"), "--checkpoint-at", at});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    ASSERT_TRUE(exists("at.checkpoint"));
    EXPECT_FALSE(exists("at.checkpoint.partial"));
  }
  StoreForTests made_;
};

TEST_F(CheckpointFile, ARunTakenUpLeavesTheBytesOfOneThatNeverStopped) {
  run_whole();
  ASSERT_EQ(made_.run({"simulate", path("run.yaml"), "--out", path("plain.nc")}).exit_code, 0);
  EXPECT_TRUE(read_bytes(path("plain.nc")) == read_bytes(path("run.nc")));
  for (const std::vector<std::string>& how :
       {std::vector<std::string>{}, {"--one-by-one"}, {"--threads", "2"}}) {
    std::vector<std::string> arguments{"simulate",  path("run.yaml"),      "--out", path("b.nc"),
                                       "--restore", path("at.checkpoint"), "--json"};
    arguments.insert(arguments.end(), how.begin(), how.end());
    const ProgramResult rest = made_.run(arguments);
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_TRUE(read_bytes(path("b.nc")) == read_bytes(path("run.nc")));
    const json summary = json::parse(rest.out);
    EXPECT_DOUBLE_EQ(summary.at("duration_s").get<double>(), 180);
    // Some raised before the checkpoint and over after it, by a ferry that is 320 m off when it is
    // made.
    const json& alarms = summary.at("traffic").at("alarms");
    EXPECT_TRUE(std::any_of(alarms.begin(), alarms.end(), [](const json& alarm) {
      return alarm.at("begin_s").get<double>() < 60 && alarm.at("end") == "clear" &&
             alarm.at("end_s").get<double>() > 60;
    })) << alarms;
  }
  EXPECT_EQ(made_.run({"replay", path("b.nc")}).exit_code, 0);
}

TEST_F(CheckpointFile, FromCheckpointToCheckpoint) {
  run_whole();
  const ProgramResult second =
      made_.run({"simulate", path("run.yaml"), "--restore", path("at.checkpoint"), "--checkpoint",
                 path("later.checkpoint"), "--checkpoint-at", "2min"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  ASSERT_EQ(made_
                .run({"simulate", path("run.yaml"), "--out", path("b.nc"), "--restore",
                      path("later.checkpoint")})
                .exit_code,
            0);
  EXPECT_TRUE(read_bytes(path("b.nc")) == read_bytes(path("run.nc")));
}

TEST_F(CheckpointFile, ARunThatIsStoppedCanBeGoneOnWith) {
  run_whole();
  for (const int sign : {SIGINT, SIGTERM}) {
    // At the clock's pace, so that the signal comes in its middle.
    const pid_t program =
        start_program({"simulate", path("run.yaml"), "--out", path("stopped.nc"), "--checkpoint",
                       path("stop.checkpoint"), "--real-time", "20"});
    std::this_thread::sleep_for(std::chrono::milliseconds(1000));
    ASSERT_EQ(kill(program, sign), 0);
    EXPECT_EQ(wait_for_program(program), 5);
    EXPECT_FALSE(exists("stopped.nc"));
    ASSERT_TRUE(exists("stop.checkpoint"));
    const ProgramResult rest = made_.run({"simulate", path("run.yaml"), "--out", path("b.nc"),
                                          "--restore", path("stop.checkpoint")});
    ASSERT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_TRUE(read_bytes(path("b.nc")) == read_bytes(path("run.nc")));
    std::filesystem::remove(path("stop.checkpoint"));
  }
}

TEST_F(CheckpointFile, DamagedCutShortOrForeignIsRefusedAndNothingIsWritten) {
  run_whole();
  const std::string good = read_bytes(path("at.checkpoint"));
  const auto refusal = [&](const std::string& bytes, const std::string& yaml, int exit_code) {
    write("bad.checkpoint", bytes);
    const ProgramResult run =
        made_.run({"simulate", write("bad.yaml", yaml), "--out", path("bad.nc"), "--html",
                   path("bad.html"), "--restore", path("bad.checkpoint")});
    EXPECT_EQ(run.exit_code, exit_code) << run.err;
    EXPECT_FALSE(exists("bad.nc"));
    EXPECT_FALSE(exists("bad.html"));
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  const auto says = [](const std::string& message, const char* what) {
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  for (const double share : {0.001, 0.01, 0.3, 0.6, 0.999}) {
    const auto at = static_cast<std::size_t>(share * static_cast<double>(good.size()));
    says(refusal(good.substr(0, at), scenario, 3), at < 24 ? "no checkpoint" : "cut short");
    std::string touched = good;
    touched[std::max<std::size_t>(at, 30)] ^= 1;
    says(refusal(touched, scenario, 3), "checksum does not hold");
  }
  says(refusal(good + "x", scenario, 3), "checksum does not hold");
  says(refusal("", scenario, 3), "no checkpoint");
  says(refusal(read_bytes(path("run.nc")), scenario, 3), "no checkpoint");
  std::string later = good;
  later.replace(0, 23, "slackwater checkpoint 2");
  says(refusal(later, scenario, 3), "another format");
  // With a checksum that holds: of another program, and with fewer rows than it says.
  const auto forged = [&](const std::string& what, const std::string& instead) {
    constexpr std::size_t line = 24, body = line + 65;
    std::string bytes = good;
    bytes.replace(bytes.find(what), what.size(), instead);
    return bytes.replace(line, 64, sha256_of_text(bytes.substr(body)));
  };
  says(refusal(forged("\"program\": \"0", "\"program\": \"7"), scenario, 3),
       "another version of the program");
  says(refusal(forged("\"times\": 1", "\"times\": 9"), scenario, 3), "fewer rows");
  says(refusal(forged("\"control\"", "\"kontrol\""), scenario, 3), "no state of this program");
  std::string other = scenario;
  other.replace(other.find("seed: 5"), 7, "seed: 6");
  says(refusal(good, other, 3), "another scenario");
  const ProgramResult none = made_.run({"simulate", path("run.yaml"), "--restore",
                                        path("none.checkpoint"), "--out", path("bad.nc")});
  EXPECT_EQ(none.exit_code, 4) << none.err;
  EXPECT_EQ(made_.run({"simulate", path("run.yaml"), "--restore", path("")}).exit_code, 3);
}

TEST_F(CheckpointFile, ATimeThatTheRunDoesNotReachIsRefused) {
  const auto code = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"simulate", path("run.yaml"), "--checkpoint", path("c")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return made_.run(arguments).exit_code;
  };
  EXPECT_EQ(code({"--checkpoint-at", "5min"}), 2);
  EXPECT_EQ(code({"--checkpoint-at", "soon"}), 2);
  EXPECT_EQ(made_.run({"simulate", path("run.yaml"), "--checkpoint-at", "1min"}).exit_code, 2);
  EXPECT_FALSE(exists("c"));
  EXPECT_EQ(
      made_.run({"simulate", path("run.yaml"), "--checkpoint", path("no/folder/c")}).exit_code, 2);
}

TEST_F(CheckpointFile, TheLogHoldsWhatWasMeasuredAndHowFarOffItTookItselfToBe) {
  const ProgramResult run =
      made_.run({"simulate", path("run.yaml"), "--out", path("run.nc"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json summary = json::parse(run.out);
  const json& vehicles = summary.at("vehicles");
  EXPECT_EQ(vehicles.at(0).at("navigation"), "sensors");
  EXPECT_GT(vehicles.at(0).at("rms_navigation_error_m").get<double>(), 0);
  EXPECT_LT(vehicles.at(0).at("navigation_error_m").get<double>(), 5);
  EXPECT_EQ(vehicles.at(1).at("navigation"), "truth");
  EXPECT_TRUE(vehicles.at(1).at("navigation_error_m").is_null());
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  for (const char* name : {"navigation_error", "gnss_position", "dvl_velocity", "measured_depth",
                           "compass_heading", "sonar_range"})
    EXPECT_NE(log.find(name), nullptr) << name;
  std::string truth = scenario;
  truth.replace(truth.find("navigation: sensors"), 19, "navigation: truth  ");
  truth.replace(truth.find("log: {sensors: true}"), 20, "");
  ASSERT_EQ(
      made_.run({"simulate", write("truth.yaml", truth), "--out", path("truth.nc")}).exit_code, 0);
  const ingest::TrajectoryFile plain = ingest::read_trajectories(path("truth.nc"));
  EXPECT_EQ(plain.find("navigation_error"), nullptr);
  EXPECT_EQ(plain.find("sonar_range"), nullptr);
}

}  // namespace
}  // namespace slackwater::tests::cli_checkpoint_test

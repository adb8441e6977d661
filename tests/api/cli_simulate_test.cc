// `slackwater simulate` and `replay`: runs that come out the same to the byte, in made-up water and
// in an issued forecast.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "fields/base/encode/csv.h"
#include "ingest/cf/trajectory_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_simulate_test {
namespace {

using nlohmann::json;

const std::string scenario = R"(name: two in a current
seed: 5
duration: 1min
step_s: 0.05
log_every_s: 1
water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0.4, north_m_s: 0.1}],
                  wind: {speed_m_s: 5, from_deg: 200}}}
waves: {components: 32, partitions: [{significant_height_m: 0.5, peak_period_s: 5, from_deg: 200}]}
gusts: dryden
vehicles:
  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 8},
     tasks: [{do: hold}]}
  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 20}, tasks: [{do: hold}]}
)";

class SimulateCommand : public testing::Test {
 protected:
  void SetUp() override { write("run.yaml", scenario); }
  std::string write(const std::string& name, const std::string& text) const {
    return made_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  StoreForTests made_;
};

TEST_F(SimulateCommand, RunsToALogThatReplaysToTheByteHoweverItIsStepped) {
  const ProgramResult run = made_.run({"simulate", path("run.yaml"), "--out", path("run.nc"),
                                       "--html", path("run.html"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json summary = json::parse(run.out);
  EXPECT_DOUBLE_EQ(summary.at("duration_s").get<double>(), 60);
  ASSERT_EQ(summary.at("vehicles").size(), 2U);
  for (const json& vehicle : summary.at("vehicles")) {
    EXPECT_EQ(vehicle.at("halt"), "none");
    EXPECT_GT(vehicle.at("energy_wh").get<double>(), 0.2);
    EXPECT_LT(vehicle.at("state_of_charge").get<double>(), 1);
  }
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  EXPECT_EQ(log.names, (std::vector<std::string>{"rov", "uav"}));
  EXPECT_EQ(log.t_s.size(), 61U);
  EXPECT_EQ(log.attribute("scenario"), scenario);
  EXPECT_NE(read_bytes(path("run.html")).find("two in a current"), std::string::npos);

  const ProgramResult replayed = made_.run({"replay", path("run.nc"), "--json"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  EXPECT_TRUE(json::parse(replayed.out).at("identical").get<bool>());
  ASSERT_EQ(made_
                .run({"simulate", path("run.yaml"), "--out", path("other.nc"), "--one-by-one",
                      "--threads", "2"})
                .exit_code,
            0);
  EXPECT_EQ(read_bytes(path("other.nc")), read_bytes(path("run.nc")));
}

TEST_F(SimulateCommand, TheLogAsATableHasTheNumbersOfTheLog) {
  ASSERT_EQ(
      made_.run({"simulate", path("run.yaml"), "--out", path("run.nc"), "--csv", path("run.csv")})
          .exit_code,
      0);
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  std::ifstream in(path("run.csv"));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> head = csv_cells(line).value();
  const auto column = [&](const std::string& name) {
    const auto found = std::find(head.begin(), head.end(), name);
    EXPECT_NE(found, head.end()) << name << " of " << line;
    return static_cast<std::size_t>(found - head.begin());
  };
  EXPECT_EQ(std::vector<std::string>(head.begin(), head.begin() + 3),
            (std::vector<std::string>{"vehicle", "time", "t_s"}));
  const std::size_t x = column("x_m");
  const std::size_t down = column("velocity_body_2_m_s");
  std::size_t row = 0;
  for (; std::getline(in, line); ++row) {
    const std::vector<std::string> cells = csv_cells(line).value();
    ASSERT_EQ(cells.size(), head.size()) << line;
    const std::size_t times = log.t_s.size();
    EXPECT_EQ(cells[0], log.names[row / times]);
    EXPECT_EQ(std::stod(cells[2]), log.t_s[row % times]);
    EXPECT_EQ(std::stod(cells[x]), log.find("x")->values[row]);
    EXPECT_EQ(std::stod(cells[down]), log.find("velocity_body")->values[3 * row + 2]);
  }
  EXPECT_EQ(row, 2 * log.t_s.size());
  ASSERT_EQ(made_.run({"replay", path("run.nc"), "--csv", path("again.csv")}).exit_code, 0);
  EXPECT_EQ(read_bytes(path("again.csv")), read_bytes(path("run.csv")));
}

TEST_F(SimulateCommand, ALogThatWasTouchedDoesNotReplayAndSaysWhere) {
  ASSERT_EQ(made_.run({"simulate", path("run.yaml"), "--out", path("run.nc")}).exit_code, 0);
  ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  for (auto& variable : log.variables)
    if (variable.name == "x") variable.values[30] += 1e-12;
  ingest::write_trajectories(log, path("touched.nc"));
  const ProgramResult replayed = made_.run({"replay", path("touched.nc")});
  EXPECT_EQ(replayed.exit_code, 3);
  EXPECT_NE(replayed.err.find("x of rov at 30 s"), std::string::npos) << replayed.err;
}

TEST_F(SimulateCommand, RunsInAMemberOfAnIssuedForecastAndReplaysInIt) {
  made_.ingest_days(parse_day("2025-03-01"), 3);
  const ProgramResult issued = made_.run({"forecast", "--site", made_.site(), "--at",
                                          "2025-03-04T05:00:00Z", "--out", path("issued.nc")});
  ASSERT_EQ(issued.exit_code, 0) << issued.err;
  const std::string yaml =
      "name: tomorrow\nseed: 1\nduration: 2min\nmember: 3\nwater: {forecast: {site: " +
      made_.site() +
      "}}\nvehicles:\n  - {name: auv, model: lrauv_tethys, start: {north_m: 0, "
      "east_m: 0, depth_m: 5}, tasks: [{do: route, waypoints: [{north_m: 100, "
      "east_m: 0, depth_m: 5}]}]}\n";
  const std::string file = write("tomorrow.yaml", yaml);
  const auto before = made_.digests();
  const ProgramResult run = made_.run({"simulate", file, "--out", path("run.nc"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(json::parse(run.out).at("forecast_sha256").get<std::string>().size(), 64U);
  EXPECT_EQ(made_.run({"replay", path("run.nc")}).exit_code, 0);
  EXPECT_EQ(made_.digests(), before) << "a rehearsal leaves the store as it was";
  // Another store does not have that forecast.
  const ProgramResult elsewhere =
      run_program({"replay", path("run.nc"), "--store", path("nowhere")});
  EXPECT_EQ(elsewhere.exit_code, 4) << elsewhere.err;
  // In a file it is at hand, for the run and for what its sensors see.
  const std::string named = "site: " + made_.site();
  const std::string from_file =
      std::string(yaml).replace(yaml.find(named), named.size(), "file: issued.nc");
  const ProgramResult seen =
      run_program({"simulate", write("in_file.yaml", from_file), "--out", path("in_file.nc"),
                   "--see", "auv/echo_sounder@0.02", "--store", path("nowhere"), "--json"});
  ASSERT_EQ(seen.exit_code, 0) << seen.err;
  EXPECT_GE(json::parse(seen.out).at("seen")[0].at("frames").size(), 2U);
}

struct Bad {
  const char* what;
  const char* instead;
  int exit_code;
  const char* says;
};

TEST_F(SimulateCommand, RefusesWhatCannotBeRunBeforeTheFirstStep) {
  const Bad all[] = {
      {"seed: 5", "seed: 5\nsead: 6", 3, "sead"},
      {"model: bluerov2_heavy", "model: bluerov3", 3, "lrauv_tethys"},
      {"depth_m: 8", "depth_m: 41", 3, "below_bed"},
      {"height_m: 20", "depth_m: 20", 3, "below the sea"},
      {"tasks: [{do: hold}]}\n  - {name: uav",
       "tether: {top: {north_m: 0, east_m: 0, depth_m: 0}, length_m: 4}}\n  - {name: uav", 3,
       "rov"},
      {"water: {made_up", "water: {forecast: {site: nowhere}, made_up", 3, "one of"},
  };
  for (const Bad& bad : all) {
    std::string yaml = scenario;
    const std::size_t at = yaml.find(bad.what);
    ASSERT_NE(at, std::string::npos) << bad.what;
    yaml.replace(at, std::string(bad.what).size(), bad.instead);
    const ProgramResult run =
        made_.run({"simulate", write("bad.yaml", yaml), "--out", path("bad.nc")});
    EXPECT_EQ(run.exit_code, bad.exit_code) << bad.instead << "\n" << run.err;
    EXPECT_NE(run.err.find(bad.says), std::string::npos) << bad.instead << "\n-> " << run.err;
    EXPECT_FALSE(std::filesystem::exists(path("bad.nc"))) << bad.instead;
  }
}

TEST_F(SimulateCommand, SaysWhatIsMissing) {
  EXPECT_EQ(made_.run({"simulate", path("none.yaml")}).exit_code, 4);
  EXPECT_EQ(made_.run({"simulate", path("run.yaml"), "--out", path("no/folder/run.nc")}).exit_code,
            2);
  EXPECT_EQ(made_.run({"simulate", path("run.yaml"), "--threads", "0"}).exit_code, 2);
  EXPECT_EQ(made_.run({"replay", path("none.nc")}).exit_code, 4);
  EXPECT_EQ(made_.run({"replay", path("run.yaml")}).exit_code, 3);
  const ProgramResult no_forecast = made_.run(
      {"simulate",
       write("store.yaml",
             "name: x\nseed: 1\nduration: 1min\nwater: {forecast: {site: saint_brieuc}}\n"
             "vehicles: [{name: a, model: x500, start: {north_m: 0, east_m: 0, height_m: 9}}]\n")});
  EXPECT_EQ(no_forecast.exit_code, 4) << no_forecast.err;
}

TEST_F(SimulateCommand, TheBundledScenarioRuns) {
  const auto file = source_folder() / "data" / "scenarios" / "pile_inspection.yaml";
  const ProgramResult run = made_.run({"simulate", file.string(), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json summary = json::parse(run.out);
  for (const json& vehicle : summary.at("vehicles")) {
    EXPECT_EQ(vehicle.at("halt"), "none") << vehicle;
    EXPECT_GE(vehicle.at("tasks_done").get<int>(), 1) << vehicle;
    EXPECT_LT(vehicle.at("rms_across_track_m").get<double>(), 1) << vehicle;
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_simulate_test

// How near vehicles came to what was around them, and their clearance alarms: the same figures in
// the summary, the JSON, the log, the page and the scorecard of a run.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ingest/cf/trajectory_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_simulate_clearance_test {
namespace {

using nlohmann::json;

class SimulateClearance : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    return made_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  [[nodiscard]] json simulated(const std::string& file,
                               const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"simulate", file, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramResult run = made_.run(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return run.exit_code == 0 ? json::parse(run.out) : json();
  }
  [[nodiscard]] json score_of(const std::string& log, std::size_t vehicle) const {
    const ProgramResult run = made_.run({"score", log, "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return json::parse(run.out).at("runs")[0].at("vehicles")[vehicle];
  }
  StoreForTests made_;
};

const std::string head =
    "name: passing\nseed: 5\nstart: 2025-03-10T06:00:00Z\nduration: 2min\nstep_s: 0.1\n"
    "log_every_s: 2\nwater: {made_up: {depth_m: 40}}\n";

/// One that lies 4 m beside a pile, nearer than it promises; one that comes past it; a ferry that
/// is 90 m off at 50 s; a third on a line.
const std::string meeting =
    head +
    "clearance: {craft_m: 1, structure_m: 5, vessel_m: 2}\n"
    "structures: [{kind: cylinder, name: pile, north_m: 0, east_m: 7, diameter_m: 6, top_height_m: "
    "20, bottom_depth_m: 40}]\n"
    "traffic: {vessels: [{mmsi: 7, name: FERRY, speed_m_s: 10, waypoints: [{north_m: 500, east_m: "
    "90}, {north_m: -900, east_m: 90}]}]}\n"
    "vehicles:\n"
    "  - {name: still, model: bluerov2_heavy, keeps_clear: false, start: {north_m: 0, east_m: 0, "
    "depth_m: 12}, tasks: [{do: hold}]}\n"
    "  - {name: passer, model: bluerov2_heavy, start: {north_m: -20, east_m: -6, depth_m: 12}, "
    "speed_m_s: 0.5, tasks: [{do: route, waypoints: [{north_m: 20, east_m: -6, depth_m: 12}]}]}\n"
    "  - {name: near, model: bluerov2_heavy, start: {north_m: 0, east_m: 12, depth_m: 20}, tether: "
    "{top: {north_m: -2, east_m: 14, depth_m: 1}, length_m: 30}, tasks: [{do: hold}]}\n";

TEST_F(SimulateClearance, SummaryLogPageAndScoreSayTheSame) {
  const std::string file = write("run.yaml", meeting);
  const json summary =
      simulated(file, {"--out", path("run.nc"), "--html", path("run.html")}).at("vehicles");
  ASSERT_EQ(summary.size(), 3U);
  const json &still = summary[0], &passer = summary[1], &near = summary[2];
  // What the geometry says: 7 m from the axis of a pile of 3 m radius, 90 m from a ferry at 50 s,
  // 6 m from a line of 0.5 m/s.
  EXPECT_NEAR(still.at("closest").at("structure").at("distance_m").get<double>(), 4, 0.1);
  EXPECT_EQ(still.at("closest").at("structure").at("name"), "pile");
  EXPECT_NEAR(still.at("closest").at("vessel").at("distance_m").get<double>(), 90, 0.1);
  EXPECT_NEAR(still.at("closest").at("vessel").at("at_s").get<double>(), 50, 0.2);
  EXPECT_EQ(still.at("closest").at("vessel").at("name"), "FERRY");
  EXPECT_EQ(still.at("closest").at("vessel").at("mmsi"), 7);
  EXPECT_NEAR(passer.at("closest").at("vehicle").at("distance_m").get<double>(), 6, 0.3);
  EXPECT_EQ(passer.at("closest").at("vehicle").at("name"), "still");
  EXPECT_EQ(passer.at("closest").at("tether").at("name"), "near");
  EXPECT_TRUE(near.at("closest").at("tether").is_null()) << "its own does not count";
  // One is placed nearer than the stand-off, one does not keep clear, one has no reason.
  EXPECT_TRUE(still.at("clearance").is_null());
  EXPECT_EQ(passer.at("clearance").at("alarms"), 0);
  EXPECT_GE(near.at("clearance").at("alarms"), 1);
  EXPECT_EQ(near.at("clearance").at("alarms_from").at("structure"),
            near.at("clearance").at("alarms"));
  EXPECT_GT(near.at("clearance").at("changed_s").get<double>(), 0);

  const ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  const ingest::TrajectoryTable* table = log.find_table("approach");
  ASSERT_NE(table, nullptr);
  std::size_t told = 0;
  for (const json& vehicle : summary)
    for (const auto& [kind, approach] : vehicle.at("closest").items()) {
      if (approach.is_null()) continue;
      ASSERT_LT(told, table->rows());
      std::size_t row = 0;
      while (row < table->rows() &&
             !(log.names[static_cast<std::size_t>(table->column("vehicle")->at(row))] ==
                   vehicle.at("name").get<std::string>() &&
               table->text("kind")->at(row) == kind))
        ++row;
      ASSERT_LT(row, table->rows()) << vehicle.at("name") << kind;
      EXPECT_EQ(table->column("distance")->at(row), approach.at("distance_m").get<double>());
      EXPECT_EQ(table->column("time")->at(row), approach.at("at_s").get<double>());
      ++told;
    }
  EXPECT_EQ(told, table->rows());
  for (std::size_t i = 0; i < 3; ++i) {
    const json score = score_of(path("run.nc"), i);
    for (const auto& [kind, approach] : summary[i].at("closest").items())
      EXPECT_EQ(score.at("closest_" + kind + "_m"),
                approach.is_null() ? json(nullptr) : approach.at("distance_m"))
          << i << kind;
  }
  const std::string page = read_bytes(path("run.html"));
  for (const char* what : {"Closest to a structure", "Closest to another vehicle",
                           "Closest to a vessel", "Clearance alarms"})
    EXPECT_NE(page.find(what), std::string::npos) << what;
  const ProgramResult printed = made_.run({"simulate", file});
  EXPECT_NE(printed.out.find("still: closest to a vehicle "), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("a vessel 90.0 m (FERRY, 06:00:"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("clearance alarms: none"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("(structure "), std::string::npos) << printed.out;
  EXPECT_EQ(made_.run({"replay", path("run.nc")}).exit_code, 0);
}

TEST_F(SimulateClearance, ARunTakenUpAndOnTwoThreadsSaysTheSame) {
  const std::string file = write("run.yaml", meeting);
  const json whole =
      simulated(file, {"--checkpoint", path("at.checkpoint"), "--checkpoint-at", "1min"})
          .at("vehicles");
  // Past what was nearest: only the checkpoint knows of it.
  EXPECT_LT(whole[0].at("closest").at("vessel").at("at_s").get<double>(), 60);
  const json rest = simulated(file, {"--restore", path("at.checkpoint")}).at("vehicles");
  const json threads = simulated(file, {"--threads", "2"}).at("vehicles");
  for (std::size_t i = 0; i < whole.size(); ++i)
    for (const char* key : {"closest", "clearance"}) {
      EXPECT_EQ(rest[i].at(key), whole[i].at(key));
      EXPECT_EQ(threads[i].at(key), whole[i].at(key));
    }
}

TEST_F(SimulateClearance, OneThatIsAloneHasMetNobody) {
  const std::string file =
      write("alone.yaml", head +
                              "vehicles: [{name: rov, model: bluerov2_heavy, start: {north_m: 0, "
                              "east_m: 0, depth_m: 12}, tasks: [{do: hold}]}]\n");
  const json rov = simulated(file, {"--out", path("alone.nc")}).at("vehicles")[0];
  EXPECT_TRUE(rov.at("closest").is_null());
  EXPECT_TRUE(rov.at("clearance").is_null());
  EXPECT_EQ(made_.run({"simulate", file}).out.find("closest"), std::string::npos);
  EXPECT_EQ(ingest::read_trajectories(path("alone.nc")).find_table("approach"), nullptr);
}

TEST_F(SimulateClearance, TheScoreOfAnOlderLogIsReadOffItsRows) {
  (void)simulated(write("run.yaml", meeting), {"--out", path("run.nc")});
  ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  for (auto& [name, value] : log.attributes)
    if (name == "log_format") value = "2";
  std::erase_if(log.tables, [](const auto& t) { return t.name == "approach"; });
  ingest::write_trajectories(log, path("old.nc"));
  for (std::size_t i = 0; i < 3; ++i) {
    const json score = score_of(path("run.nc"), i), old = score_of(path("old.nc"), i);
    for (const char* key : {"closest_structure_m", "closest_vehicle_m", "closest_vessel_m"}) {
      // Rows every two seconds show it less near, a ferry by up to a way of 10 m.
      EXPECT_GE(old.at(key).get<double>(), score.at(key).get<double>() - 1e-9) << key;
      EXPECT_LT(old.at(key).get<double>(), score.at(key).get<double>() + 0.6) << key;
    }
    EXPECT_TRUE(old.at("closest_tether_m").is_null());
  }
}

}  // namespace
}  // namespace slackwater::tests::cli_simulate_clearance_test

// What `slackwater simulate` says of vehicles that did not fare well: in its summary, its JSON, its
// log and its page.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ingest/cf/trajectory_file.h"
#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_simulate_fates_test {
namespace {

using nlohmann::json;

class SimulateFates : public testing::Test {
 protected:
  std::string write(const std::string& name, const std::string& text) const {
    return made_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return made_.path(name); }
  /// A bundled vehicle's file without its `battery` block.
  [[nodiscard]] std::string without_battery(const std::string& id) const {
    std::string yaml = read_bytes(source_folder() / "data" / "vehicles" / (id + ".yaml"));
    const std::size_t from = yaml.find("\nbattery:");
    const std::size_t to = yaml.find("\nhotel_w:");
    EXPECT_LT(from, to);
    return write(id + "_bare.yaml", yaml.erase(from, to - from));
  }
  StoreForTests made_;
};

std::string head(const std::string& water) {
  return "name: fates\nseed: 5\nstart: 2025-03-10T18:40:00Z\nduration: 2min\nstep_s: 0.05\n"
         "water: {made_up: " +
         water + "}\nvehicles:\n";
}

TEST_F(SimulateFates, AnEmptyBatteryIsTheCauseAndNotTheSeaThatItStruck) {
  const std::string file = write(
      "flat.yaml", head("{depth_m: 40, wind: {speed_m_s: 3, from_deg: 270}}") +
                       "  - {name: uav, model: x500, state_of_charge: 0.005, start: {north_m: 0, "
                       "east_m: 0, height_m: 40}, tasks: [{do: hold}]}\n");
  const ProgramResult printed = made_.run({"simulate", file});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NE(printed.out.find("battery empty at 18:40:"), std::string::npos) << printed.out;
  EXPECT_NE(printed.out.find("→ fell → struck the sea at 18:40:"), std::string::npos)
      << printed.out;
  const ProgramResult run = made_.run(
      {"simulate", file, "--json", "--out", path("flat.nc"), "--html", path("flat.html")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json uav = json::parse(run.out).at("vehicles").at(0);
  EXPECT_EQ(uav.at("halt"), "struck");
  ASSERT_EQ(uav.at("events").size(), 3U);
  EXPECT_EQ(uav.at("events")[0].at("what"), "battery empty");
  EXPECT_TRUE(uav.at("events")[1].at("at_s").is_null());
  EXPECT_GT(uav.at("events")[2].at("at_s").get<double>(),
            uav.at("events")[0].at("at_s").get<double>());
  EXPECT_GT(uav.at("largest_depth_error_m").get<double>(), 30) << "the height that it lost";
  EXPECT_NE(read_bytes(path("flat.html")).find("battery empty at 18:40:"), std::string::npos);
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("flat.nc"));
  EXPECT_EQ(log.attribute("log_format"), "6");
  ASSERT_NE(log.find_table("fate"), nullptr);
  EXPECT_EQ(log.find_table("fate")->text("events")->at(0), uav.at("fate").get<std::string>());
  EXPECT_EQ(made_.run({"replay", path("flat.nc")}).exit_code, 0);
}

TEST_F(SimulateFates, AnElectricVehicleWithoutABatteryTellsWhatItDrew) {
  const std::string file = write(
      "bare.yaml", head("{depth_m: 40}") + "  - {name: usv, model: " + without_battery("wamv16") +
                       ", start: {north_m: 0, east_m: 0, depth_m: 0}, tasks: [{do: route, "
                       "waypoints: [{north_m: 900, east_m: 0, depth_m: 0}]}]}\n");
  const ProgramResult printed = made_.run({"simulate", file});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NE(printed.out.find("kWh"), std::string::npos) << printed.out;
  EXPECT_EQ(printed.out.find("0.0 kg"), std::string::npos) << printed.out;
  const json usv = json::parse(made_.run({"simulate", file, "--json"}).out).at("vehicles").at(0);
  EXPECT_GT(usv.at("energy_wh").get<double>(), 120 * 150 / 3600.0);  // its hotel load alone
  EXPECT_TRUE(usv.at("fuel_kg").is_null());
  EXPECT_TRUE(usv.at("state_of_charge").is_null());
  EXPECT_TRUE(usv.at("rms_depth_error_m").is_null());
}

TEST_F(SimulateFates, WaterFasterThanTheVehicleIsSaid) {
  std::string yaml = head("{depth_m: 40, current: [{depth_m: 0, east_m_s: 0, north_m_s: -1.5}]}") +
                     "  - {name: auv, model: lrauv_tethys, start: {north_m: 0, east_m: 0, depth_m: "
                     "20}, tasks: [{do: route, waypoints: [{north_m: 500, east_m: 0, depth_m: "
                     "20}]}]}\n";
  yaml.replace(yaml.find("2min"), 4, "30min");
  const ProgramResult printed = made_.run({"simulate", write("fast.yaml", yaml)});
  ASSERT_EQ(printed.exit_code, 0) << printed.err;
  EXPECT_NE(printed.out.find("made no headway against the water at 18:4"), std::string::npos)
      << printed.out;
}

TEST_F(SimulateFates, WhoIsNotRecoveredIsToldOfInAllThatIsSaid) {
  std::string faults;
  for (const char* n : {"0", "1", "2"})
    faults +=
        std::string(*n == '0' ? "" : ", ") + "{fault: lost_thruster, at_s: 5, thruster: " + n + "}";
  const std::string file =
      write("adrift.yaml", head("{depth_m: 40, current: [{depth_m: 0, east_m_s: 0.4, north_m_s: "
                                "0}]}") +
                               "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: "
                               "0, depth_m: 8}, conduct: {faults: [" +
                               faults +
                               "]}, tasks: [{do: route, waypoints: [{north_m: 15, east_m: 0, "
                               "depth_m: 8}]}]}\n");
  const ProgramResult run = made_.run(
      {"simulate", file, "--json", "--out", path("adrift.nc"), "--html", path("adrift.html")});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  const json& rov = out.at("vehicles").at(0);
  EXPECT_EQ(rov.at("halt"), "none");
  EXPECT_EQ(rov.at("fate"), "not recovered at 18:42:00Z");
  ASSERT_EQ(rov.at("events").size(), 1U);
  EXPECT_EQ(rov.at("events")[0].at("what"), "not recovered");
  const std::string page = read_bytes(path("adrift.html"));
  EXPECT_NE(page.find("not recovered at 18:42:00Z"), std::string::npos);
  EXPECT_NE(page.find("lost thruster"), std::string::npos);
  const ingest::TrajectoryFile log = ingest::read_trajectories(path("adrift.nc"));
  EXPECT_EQ(log.find_table("fate")->text("stopped_by")->at(0), "not recovered: lost thruster");
  EXPECT_EQ(made_.run({"replay", path("adrift.nc")}).exit_code, 0);
  // And what it does with nobody at its controls, once.
  ASSERT_EQ(out.at("notes").size(), 1U);
  const auto note = out.at("notes").at(0).get<std::string>();
  EXPECT_EQ(
      note.rfind("bluerov2_heavy: without a controller it does not go straight at 0.5 m/s", 0), 0U)
      << note;
  EXPECT_NE(run.err.find("slackwater: note: " + note), std::string::npos) << run.err;
}

TEST_F(SimulateFates, ALogOfAnotherFormatIsNotReplayedAndSaysSo) {
  const std::string file =
      write("run.yaml", head("{depth_m: 40}") +
                            "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                            "depth_m: 8}, tasks: [{do: hold}]}\n");
  ASSERT_EQ(made_.run({"simulate", file, "--out", path("run.nc")}).exit_code, 0);
  ingest::TrajectoryFile log = ingest::read_trajectories(path("run.nc"));
  std::erase_if(log.attributes, [](const auto& a) { return a.first == "log_format"; });
  ingest::write_trajectories(log, path("old.nc"));
  const ProgramResult replayed = made_.run({"replay", path("old.nc")});
  EXPECT_EQ(replayed.exit_code, 3);
  EXPECT_NE(replayed.err.find("format 1"), std::string::npos) << replayed.err;
}

}  // namespace
}  // namespace slackwater::tests::cli_simulate_fates_test

// A vehicle of somebody else, described from published numbers that nothing here was tuned on: it
// loads without a warning and does what is published of it; broken, it is refused, and so are
// bundled ones of others (held_against/ has those as they are).
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/twin/validation/flight.h"

namespace slackwater::twin::strangers_vehicles_test {
namespace {

using tests::Flight;

std::filesystem::path file_of(const std::string& id) {
  const auto stranger = tests::source_folder() / "tests/twin/strangers/vehicles" / (id + ".yaml");
  if (std::filesystem::exists(stranger)) return stranger;
  return tests::source_folder() / "data/vehicles" / (id + ".yaml");
}
Vehicle stranger(const std::string& id) {
  return read_vehicle(file_of(id), tests::source_folder() / "data");
}

/// A run of one of them; `water` is made up.
Scenario run_of(const std::string& id, const std::string& water, const std::string& entry,
                double step_s = 0.05) {
  return parse_scenario(
      "name: stranger\nseed: 3\nduration: 60min\nstep_s: " + std::to_string(step_s) +
          "\nwater: {made_up: " + water +
          "}\nvehicles:\n  - {name: it, model: " + file_of(id).string() + ", " + entry + "}\n",
      "stranger");
}

TEST(StrangersVehicles, LoadWithoutAWarning) {
  for (const std::string& warning : stranger("heavy_hexacopter").warnings) ADD_FAILURE() << warning;
}

TEST(StrangersVehicles, TheRemusMakesItsPublishedSpeedAndKeepsItsDepthThoughItIsLight) {
  // MSS and Allen et al.: 2.5 m/s at 1525 turns a minute; `most_speed_m_s` of its file is 2.4.
  const Scenario scenario =
      run_of("remus100", "{depth_m: 60}",
             "speed_m_s: 2.3, start: {north_m: 0, east_m: 0, depth_m: 15}, tasks: [{do: route, "
             "waypoints: [{north_m: 9000, east_m: 0, depth_m: 20}]}]");
  Flight flight(scenario);
  EXPECT_NEAR(flight.agent().mission.pursuit.most_speed_m_s, 2.4, 0.15);
  // Down along its leg, which goes to 20 m over 9 km; its fins take up its buoyancy meanwhile.
  const auto below_its_leg_m = [&] {
    const Triple<double>& at = flight.body().position_m;
    return at.z - (15 + 5 * at.x / 9000);
  };
  flight.run(400);
  EXPECT_NEAR(below_its_leg_m(), 0, 0.2);
  flight.run(600);
  EXPECT_NEAR(below_its_leg_m(), 0, 0.01);
  EXPECT_NEAR(flight.velocity_m_s().x, 2.3, 0.01);
  // 6.1 N s2/m2 of drag.
  EXPECT_NEAR(flight.thrust_n().x, 6.1 * 2.3 * 2.3, 3);
  const double pitch_deg = euler_angles(flight.body().attitude).pitch_rad * 180 / constants::pi;
  EXPECT_LT(pitch_deg, 0) << "a light one goes bow down";
  EXPECT_GT(pitch_deg, -10);
}

TEST(StrangersVehicles, TheOtterHasNoBatteryAndYetItsEnergyIsTold) {
  const Scenario scenario =
      run_of("otter", "{depth_m: 60, current: [{depth_m: 0, east_m_s: 0, north_m_s: 0.5}]}",
             "speed_m_s: 1.289, start: {north_m: 0, east_m: 0, depth_m: 0}, tasks: [{do: route, "
             "waypoints: [{north_m: 9000, east_m: 0, depth_m: 0}]}]");
  Flight flight(scenario);
  flight.run(200);
  // 100 N make 1.289 m/s through the water (PythonVehicleSimulator, otter_straight_100N).
  EXPECT_NEAR(flight.thrust_n().x, 100, 2);
  EXPECT_NEAR(flight.velocity_m_s().x, 1.789, 0.01);
  // Its hotel load and what the discs take.
  EXPECT_GT(flight.vehicle().drawn_j, 200 * 20.0);
  EXPECT_EQ(flight.vehicle().battery.delivered_j, 0);
}

TEST(StrangersVehicles, TheHexacopterHoversAboutAsLongAsItsMakerSays) {
  const Scenario scenario =
      run_of("heavy_hexacopter", "{depth_m: 60}",
             "start: {north_m: 0, east_m: 0, height_m: 60}, tasks: [{do: hold}]", 0.004);
  Flight flight(scenario);
  flight.run(20);
  const double power_w = flight.vehicle().electrical_w;
  const Battery& battery = *flight.craft().battery;
  const BatteryStep minute = battery_step(battery, 60);
  BatteryState<double> state = rested(battery, 1);
  double minutes = 0;
  while (state.off < 0.5 && minutes < 1000) {
    (void)discharge(battery, minute, state, power_w);
    minutes += 1;
  }
  std::printf("hexacopter: %.0f W, %.0f minutes; published 38\n", power_w, minutes);
  EXPECT_NEAR(minutes, 38, 0.2 * 38);
  EXPECT_NEAR(flight.body().position_m.z, -60, 0.2);
  EXPECT_LT(flight.state().milestones.largest_roll_rad(), 0.2);
}

/// What is said of a stranger's vehicle with one thing changed, when a run of it is made ready.
std::string refusal(const std::string& id, const std::string& what, const std::string& instead) {
  std::ifstream in(file_of(id));
  std::string yaml(std::istreambuf_iterator<char>(in), {});
  const std::size_t at = yaml.find(what);
  if (at == std::string::npos) return "not in the file: " + what;
  yaml.replace(at, what.size(), instead);
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "broken.yaml") << yaml;
  const bool flies = id == "heavy_hexacopter";
  const Scenario scenario = parse_scenario(
      std::string("name: broken\nseed: 3\nduration: 1min\nstep_s: 0.004\nwater: {made_up: "
                  "{depth_m: 60, wind: {speed_m_s: 1, from_deg: 0}}}\nvehicles:\n  - {name: it, "
                  "model: ") +
          (folder / "broken.yaml").string() + ", start: {north_m: 0, east_m: 0, " +
          (flies ? "height_m" : "depth_m") + ": 10}}\n",
      "broken");
  try {
    (void)set_up(scenario, Flight::around(scenario, Flight::field_of(scenario)));
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

TEST(StrangersVehicles, BrokenTheyAreRefusedWithTheNumbers) {
  struct Broken {
    const char* id;
    const char* what;
    const char* instead;
    std::vector<const char*> says;
  };
  const Broken all[] = {
      {"remus100",
       "centre_of_gravity_m: [0, 0, 0.0196]",
       "centre_of_gravity_m: [0, 0, -0.0196]",
       {"broken.yaml", "0.0196 m above", "turns over"}},
      {"remus100", "mass_kg: 30.48", "mass_kg: 36", {"too heavy", "hull bears", "mass_kg"}},
      {"remus100",
       "centre_of_gravity_m: [0, 0, 0.0196]",
       "centre_of_gravity_m: [0.1, 0, 0.0196]",
       {"degrees", "of trim at rest", "above each other"}},
      {"otter",
       "centre_of_gravity_m: [0.153125, 0, -0.246875]",
       "centre_of_gravity_m: [0.153125, 0, -3]",
       {"metacentric height of -", "capsizes"}},
      {"otter",
       "from_x_m: -0.846875, to_x_m: 1.153125",
       "from_x_m: -2.0, to_x_m: 0.0",
       {"of trim at rest", "1.153 m forward"}},
      {"otter",
       "centre_y_m: [-0.395, 0.395]",
       "centre_y_m: [0.1, 0.89]",
       {"degrees of heel", "-0.495 m aside"}},
      {"otter",
       "cruise_speed_m_s: 1.5",
       "cruise_speed_m_s: 15",
       {"found 15 m/s", "expected at most", "thrust and drag"}},
      {"heavy_hexacopter", "mass_kg: 10", "mass_kg: 40", {"the rotors lift"}},
      {"heavy_hexacopter",
       "  mass_kg: 10",
       "  mass_kg: 10\n  centre_of_gravity_m: [0.5, 0, 0]",
       {"0.5 m forward", "turns over"}},
  };
  for (const Broken& broken : all) {
    const std::string message = refusal(broken.id, broken.what, broken.instead);
    for (const char* says : broken.says)
      EXPECT_NE(message.find(says), std::string::npos) << broken.instead << "\n-> " << message;
  }
}

}  // namespace
}  // namespace slackwater::twin::strangers_vehicles_test

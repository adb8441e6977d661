// `slackwater vehicle check`: its figures beside those of a run and of the libraries behind it, its
// page, and what it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/shared_data.h"
#include "tests/support/store_for_tests.h"

namespace slackwater::tests::cli_vehicle_check_test {
namespace {

using nlohmann::json;

json checked(const StoreForTests& made, const std::string& model) {
  const ProgramResult run = made.run({"vehicle", "check", model, "--json"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return json::parse(run.out);
}

const json& manoeuvre(const json& check, const std::string& name) {
  for (const json& one : check.at("manoeuvres"))
    if (one.at("name") == name) return one;
  throw std::runtime_error("no " + name);
}

TEST(VehicleCheckCommand, TellsHowTheRemusLiesAndGoes) {
  const StoreForTests made;
  const json check = checked(made, "remus100");
  EXPECT_EQ(check.at("kind"), "auv");
  EXPECT_NEAR(check.at("at_rest").at("bg_m").get<double>(), 0.0196, 1e-6);
  // 302.34 N less 299.
  EXPECT_NEAR(check.at("at_rest").at("net_buoyancy_n").get<double>(), 3.4, 0.1);
  EXPECT_NEAR(check.at("top_speed_m_s").get<double>(), 2.4, 0.1);
  // Its file says so: without its fins yaw grows e-fold in 1.0 s at 1.5 m/s.
  EXPECT_NEAR(1 / check.at("controls_held").at("yaw_per_s").get<double>(), 1.0, 0.1);
  for (const json& at : check.at("speeds")) {
    EXPECT_GT(at.at("power_w").get<double>(), 30) << "its hotel load";
    if (at.at("speed_m_s").get<double>() < 1) continue;  // the least at which its fins steer it
    EXPECT_TRUE(at.at("autopilot").at("kept").get<bool>()) << at.dump(2);
  }
  const json& circle = manoeuvre(check, "turning circle").at("account");
  EXPECT_GT(circle.at("figures").at("tactical_diameter_m").get<double>(), 1);
  EXPECT_EQ(
      manoeuvre(check, "zig-zag 10/10").at("account").at("figures").at("overshoots_deg").size(),
      4U);
  const json& steps = manoeuvre(check, "steps").at("account").at("figures").at("steps");
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps.at(1).at("what"), "depth");
  EXPECT_GT(steps.at(1).at("rise_s").get<double>(), 1);
  EXPECT_EQ(steps.back().at("what"), "speed");
  EXPECT_EQ(steps.back().at("to"), 1.5);
}

/// The circle of the check is that of a scenario in the same words.
TEST(VehicleCheckCommand, FliesTheManoeuvresOfScenarios) {
  const StoreForTests made;
  const json of_check = manoeuvre(checked(made, "remus100"), "turning circle").at("account");
  const std::string scenario = made.write(
      "circle.yaml",
      "name: circle\nseed: 0\nduration_s: 600\nstep_s: 0.1\nlog_every_s: 0.1\n"
      "water: {made_up: {depth_m: 100}}\nvehicles:\n  - {name: it, model: remus100, start: "
      "{north_m: 0, east_m: 0, depth_m: 20}, tasks: [{do: turning_circle, approach_s: 120, "
      "lasts_s: "
      "1800}]}\n");
  const ProgramResult run = made.run({"simulate", scenario, "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json of_run = json::parse(run.out).at("vehicles").at(0).at("manoeuvres").at(0);
  EXPECT_EQ(of_check.at("figures"), of_run.at("figures"));
}

TEST(VehicleCheckCommand, IsReadByPeopleForEveryVehicleOfTheCatalogue) {
  const StoreForTests made;
  for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "data/vehicles")) {
    const std::string id = entry.path().stem().string();
    const ProgramResult run = made.run({"vehicle", "check", id, "--html", made.path(id + ".html")});
    EXPECT_EQ(run.exit_code, 0) << id << run.err;
    EXPECT_NE(run.out.find("By speed\n"), std::string::npos) << id << run.out;
    EXPECT_EQ(run.out.find("nan"), std::string::npos) << run.out;
    EXPECT_NE(read_bytes(made.path(id + ".html")).find("Check of "), std::string::npos);
  }
}

/// A turn of Fossen's Otter, whose numbers the file has; the tolerances are those of
/// tests/twin/held_against.
TEST(VehicleCheckCommand, IsHeldAgainstATrialAndFittedToIt) {
  SLACKWATER_NEEDS_SHARED(shared);
  const StoreForTests made;
  const std::string trial = (shared / "data/fossen/otter_turn_100_80.csv").string();
  const ProgramResult run = made.run({"vehicle", "check", "otter", "--against", trial, "--fit",
                                      "damping.N_r", "--html", made.path("otter.html"), "--json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const json out = json::parse(run.out);
  for (const json& error : out.at("trial").at("errors"))
    if (error.at("quantity") == "u_m_s" || error.at("quantity") == "r_rad_s")
      EXPECT_LT(error.at("rms_of_range").get<double>(), 0.05) << error.dump(2);
  const json& fit = out.at("fit");
  EXPECT_EQ(fit.at("keys").at(0).at("key"), "damping.N_r");
  EXPECT_LE(fit.at("rms_after").get<double>(), fit.at("rms_before").get<double>());
  EXPECT_FALSE(fit.at("keys").at(0).at("standard_deviation").is_null());
  EXPECT_NE(read_bytes(made.path("otter.html")).find("Beside a trial"), std::string::npos);
}

TEST(VehicleCheckCommand, RefusesATrialThatItCannotRead) {
  const StoreForTests made;
  EXPECT_EQ(made.run({"vehicle", "check", "otter", "--fit", "damping.N_r"}).exit_code, 2);
  const ProgramResult odd = made.run(
      {"vehicle", "check", "otter", "--against", made.write("odd.csv", "t_s,left_rad_s\n0,1\n")});
  EXPECT_EQ(odd.exit_code, 3);
  EXPECT_NE(odd.err.find("odd.csv:"), std::string::npos) << odd.err;
  EXPECT_EQ(made.run({"vehicle", "check", "otter", "--against", made.path("none.csv")}).exit_code,
            4);
}

TEST(VehicleCheckCommand, RefusesWhatNoRunTakes) {
  const StoreForTests made;
  const ProgramResult unknown = made.run({"vehicle", "check", "nemo"});
  EXPECT_EQ(unknown.exit_code, 3) << unknown.err;
  EXPECT_NE(unknown.err.find("found nemo, expected one of bluerov2_heavy"), std::string::npos)
      << unknown.err;
  std::string yaml = read_bytes(source_folder() / "data/vehicles/otter.yaml");
  yaml.replace(yaml.find("kind: usv"), 9, "kind: auv");
  const ProgramResult odd = made.run({"vehicle", "check", made.write("odd.yaml", yaml)});
  EXPECT_NE(odd.exit_code, 0);
  EXPECT_NE(odd.err.find("odd.yaml:"), std::string::npos) << odd.err;
  EXPECT_EQ(made.run({"vehicle", "check", "otter", "--html", "x.txt"}).exit_code, 2);
}

}  // namespace
}  // namespace slackwater::tests::cli_vehicle_check_test

// How vehicles keep their course under their own autopilots, beside the run itself; and which files
// are refused, or warned of, because they do not.
#include "twin/handling/kept_course.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/handling/handling_findings.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::twin::kept_course_test {
namespace {

using constants::degree;
using tests::bundled_vehicle;

KeptCourse at_cruise(const Vehicle& vehicle) {
  return kept_course(vehicle, own_autopilot(vehicle, vehicle.autopilot, usual_voltage_v(vehicle)),
                     vehicle.cruise_speed_m_s);
}

/// A file of the catalogue with one text in the place of another.
struct Changed {
  tests::TemporaryFolder folder;
  std::filesystem::path file = folder / "odd.yaml";

  Changed(const std::string& id, const std::vector<std::pair<std::string, std::string>>& changes) {
    std::ifstream from(tests::source_folder() / "data/vehicles" / (id + ".yaml"));
    std::string yaml{std::istreambuf_iterator<char>(from), {}};
    for (const auto& [found, instead] : changes) {
      const std::size_t at = yaml.find(found);
      EXPECT_NE(at, std::string::npos) << found;
      if (at != std::string::npos) yaml.replace(at, found.size(), instead);
    }
    std::ofstream(file) << yaml;
  }
  [[nodiscard]] Vehicle read() const {
    return read_handled_vehicle(file, tests::source_folder() / "data");
  }
  /// "odd.yaml:12: ..."; empty: it is taken.
  [[nodiscard]] std::string refusal() const {
    try {
      (void)read();
    } catch (const Error& problem) {
      EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
      const std::string said = problem.message();
      return said.substr(said.find("odd.yaml"));
    }
    return "";
  }
};

TEST(KeptCourse, EveryVehicleOfTheCatalogueKeepsItsCourseAndItsDepth) {
  int seen = 0;
  for (const std::string& id : catalogue(tests::source_folder() / "data")) {
    const Vehicle vehicle = bundled_vehicle(id);
    if (vehicle.kind == VehicleKind::uav) continue;
    const KeptCourse course = at_cruise(vehicle);
    std::printf("%-16s %5.2f m/s for %3.0f s: %.3f degrees, %.3f m off, makes %.3f m/s\n",
                id.c_str(), course.speed_m_s, course.lasts_s, course.heading_off_rad / degree,
                course.depth_off_m, course.made_m_s);
    EXPECT_TRUE(is_kept(course)) << id;
    EXPECT_FALSE(is_lost(course)) << id;
    EXPECT_NEAR(course.made_m_s, course.speed_m_s, 0.03 * course.speed_m_s) << id;
    EXPECT_TRUE(findings_on_handling(vehicle).empty()) << id;
    ++seen;
  }
  EXPECT_GE(seen, 7);
}

/// The same REMUS in a run, 5 degrees beside its way: what is said of it at load is what it does.
TEST(KeptCourse, IsWhatTheVehicleDoesInARun) {
  const Vehicle remus = bundled_vehicle("remus100");
  const KeptCourse course = at_cruise(remus);
  const auto run = tests::lone_run(
      "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nwater: {made_up: {depth_m: 60}}\n"
      "vehicles:\n  - {name: it, model: remus100, start: {north_m: 0, east_m: 0, depth_m: 20, "
      "heading_deg: 5}, tasks: [{do: steps, speed_m_s: 1.5, duration_s: 2000, table: [{at_s: 0, "
      "heading_deg: 0}]}]}\n");
  VehicleState<double> moving = run->states()[0].vehicle;
  moving.body.nu.linear.x = 1.5;
  run->enqueue({0, 0, PutVehicle{moving}});
  tests::go_on(*run, 0.5 * course.lasts_s);
  double off_m = 0, off_rad = 0;
  while (run->time_s() < course.lasts_s) {
    tests::go_on(*run, 1);
    off_m = std::max(off_m, std::abs(tests::state_of_lone(*run).vehicle.body.position_m.z - 20));
    off_rad = std::max(off_rad, std::abs(tests::yaw_rad(tests::state_of_lone(*run))));
  }
  // Its battery sags in the run and is held at rest at load; it is looked at once a second.
  EXPECT_NEAR(course.depth_off_m, off_m, 0.02 + 0.1 * off_m);
  EXPECT_NEAR(course.heading_off_rad, off_rad, 0.1 * degree);
}

/// Weighed out, and with the heading period that an AUV has by default: its own, faster one holds
/// it all the same.
TEST(KeptCourse, AnAuvWithoutTheLiftOfItsHullIsRefusedAndTheKeysAreNamed) {
  const Changed without("remus100", {{"  Y_uv: -28.6\n", ""},
                                     {"  Z_uw: -28.6\n", ""},
                                     {"  M_uw: 24.0\n", ""},
                                     {"  N_uv: -24.0\n", ""},
                                     {"  Y_ur: 5.22\n", ""},
                                     {"  Z_uq: -5.22\n", ""},
                                     {"  M_uq: -2.0\n", ""},
                                     {"  N_ur: -2.0\n", "  K_up: 0\n"},
                                     {"  munk: included\n", ""},
                                     {"mass_kg: 30.48", "mass_kg: 30.83"},
                                     {"heading_period_s: 4, ", ""}});
  const std::string said = without.refusal();
  std::printf("%s\n", said.c_str());
  EXPECT_TRUE(said.starts_with("odd.yaml:")) << said;
  EXPECT_NE(said.find("most likely `lift` with"), std::string::npos) << said;
}

TEST(KeptCourse, AnAutopilotThatIsTooSlowForItsVehicleIsRefused) {
  // The periods that an AUV has by default; its yaw grows e-fold in a second without its fins.
  const Changed slow("remus100",
                     {{"autopilot: {tilt_period_s: 3, heading_period_s: 4, vertical_period_s: 20, ",
                       "autopilot: {"}});
  const std::string said = slow.refusal();
  std::printf("%s\n", said.c_str());
  EXPECT_NE(said.find("does not keep it straight and level at 1.5 m/s"), std::string::npos) << said;
}

TEST(KeptCourse, FinsThatAreTooSmallAreRefused) {
  const Changed small("remus100", {{"limit_rad: 0.237, rate_rad_s: 0.5, lag_s: 0.1}\nelevator",
                                    "limit_rad: 0.01, rate_rad_s: 0.5, lag_s: 0.1}\nelevator"}});
  const std::string said = small.refusal();
  std::printf("%s\n", said.c_str());
  EXPECT_NE(said.find("does not keep it straight"), std::string::npos) << said;
}

/// Its thrusters are measured at voltages: without a battery it is looked at on the highest, and
/// runs on a bus that a scenario holds.
TEST(KeptCourse, OfARovWithoutABatteryIsToldAndItsRunAsksForAVoltage) {
  std::ifstream from(tests::source_folder() / "data/vehicles/bluerov2_heavy.yaml");
  std::string yaml{std::istreambuf_iterator<char>(from), {}};
  const std::size_t at = yaml.find("\nbattery:\n");
  ASSERT_NE(at, std::string::npos);
  std::size_t end = at + 10;
  while (yaml.compare(end, 2, "  ") == 0 || yaml[end] == '#') end = yaml.find('\n', end) + 1;
  yaml.erase(at + 1, end - at - 1);
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "odd.yaml") << yaml;
  const Vehicle rov = read_handled_vehicle(folder / "odd.yaml", tests::source_folder() / "data");
  EXPECT_FALSE(rov.battery);
  EXPECT_TRUE(is_kept(at_cruise(rov)));
  const auto ready = [&](const std::string& more) {
    return tests::ready_of(tests::calm_head(0.05) +
                           "  - {name: rov, model: " + (folder / "odd.yaml").string() + more +
                           ", start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: [{do: hold}]}\n");
  };
  EXPECT_EQ(ready(", hold_bus_v: 16").agents.size(), 1U);
  try {
    (void)ready("");
    ADD_FAILURE() << "taken";
  } catch (const Error& problem) {
    EXPECT_NE(problem.message().find("hold_bus_v: missing"), std::string::npos)
        << problem.message();
  }
}

TEST(KeptCourse, OfARovIsThatOfItsThrusters) {
  const Vehicle rov = bundled_vehicle("bluerov2_heavy");
  EXPECT_TRUE(is_kept(at_cruise(rov)))
      << "by itself it somersaults, and its thrusters hold it upright";
}

}  // namespace
}  // namespace slackwater::twin::kept_course_test

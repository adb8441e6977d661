#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"

namespace slackwater::twin::read_vehicle_test {
namespace {

using tests::bundled_vehicle;
using tests::contains;

std::string text_of(const std::string& id) {
  std::ifstream file(tests::source_folder() / "data/vehicles" / (id + ".yaml"));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// What is said of a bundled vehicle with one line put in the place of another.
std::string refusal(const std::string& id, const std::string& line, const std::string& instead) {
  const tests::TemporaryFolder folder;
  std::string yaml = text_of(id);
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  std::ofstream(folder / "made-up.yaml") << yaml.replace(at, line.size(), instead);
  try {
    (void)read_vehicle(folder / "made-up.yaml", tests::source_folder() / "data");
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

/// Sum of what the mounts do per newton each: force and moment about the origin.
Spatial<double> wrench(const Vehicle& vehicle, const std::array<double, most_mounts>& thrust_n) {
  Spatial<double> sum;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const Triple<double> force = thrust_n[i] * vehicle.mount[i].direction;
    sum = sum + force_at(vehicle.mount[i].position_m, force);
  }
  return sum;
}

/// twin/docs/vehicles.md: 129.2 N ahead from cos 45 (2 x 51.44 + 2 x 39.91), 205.7 N down.
TEST(ReadVehicle, TheBlueRov2HasTheBollardThrustOfItsSheet) {
  const Vehicle blue = bundled_vehicle("bluerov2_heavy");
  ASSERT_EQ(blue.mounts, 8U);
  EXPECT_EQ(blue.kind, VehicleKind::rov);
  const ThrusterSurroundings<double> around{0, 0, 16, 0};
  const double ahead_n = run(blue.thrusters[0], 1.0, around).thrust_n;
  const double astern_n = run(blue.thrusters[0], -1.0, around).thrust_n;
  const Spatial<double> surge = wrench(blue, {astern_n, astern_n, ahead_n, ahead_n, 0, 0, 0, 0});
  EXPECT_NEAR(surge.linear.x, 129.2, 0.05);
  EXPECT_NEAR(surge.linear.y, 0, 1e-12);
  EXPECT_NEAR(surge.angular.z, 0, 1e-12);
  const Spatial<double> heave = wrench(blue, {0, 0, 0, 0, ahead_n, ahead_n, ahead_n, ahead_n});
  EXPECT_NEAR(heave.linear.z, 205.7, 0.05);
  EXPECT_NEAR(heave.angular.x, 0, 1e-12);
  EXPECT_NEAR(heave.angular.y, 0, 1e-12);
}

TEST(ReadVehicle, TheX500LiftsOneAndTwoThirdsOfItsWeight) {
  const Vehicle x500 = bundled_vehicle("x500");
  const ThrusterSurroundings<double> around{0, 0, 15.2, 100};
  const double most_n = run(x500.thrusters[0], 5000.0, around).thrust_n;
  const Spatial<double> lift = wrench(x500, {most_n, most_n, most_n, most_n, 0, 0, 0, 0});
  EXPECT_NEAR(-lift.linear.z / (x500.body.mass_kg * constants::gravity_m_s2), 1.689, 1e-3);
  EXPECT_NEAR(lift.angular.x, 0, 1e-12);
  EXPECT_NEAR(lift.angular.y, 0, 1e-12);
  double spin = 0;
  for (std::size_t i = 0; i < 4; ++i) spin += x500.mount[i].spin;
  EXPECT_EQ(spin, 0);
}

TEST(ReadVehicle, TheLrauvTrimsByItsBatteryAndItsBladder) {
  const Vehicle lrauv = bundled_vehicle("lrauv_tethys");
  EXPECT_EQ(lrauv.mounts, 1U);
  EXPECT_NEAR(lrauv.trim.most_volume_m3 - lrauv.trim.least_volume_m3, 875e-6, 1e-12);
  EXPECT_NEAR(lrauv.rudder.limit_rad, 15 * constants::pi / 180, 1e-6);
  EXPECT_NEAR(lrauv.hotel_w, 16.8, 1e-12);
}

TEST(ReadVehicle, KnowsInWhichLineEachKeyStands) {
  const Vehicle lrauv = bundled_vehicle("lrauv_tethys");
  const std::string file = (tests::source_folder() / "data/vehicles/lrauv_tethys.yaml").string();
  const auto line_with = [&](const std::string& words) {
    const std::string text = text_of("lrauv_tethys");
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    const auto lines =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
    return file + ":" + std::to_string(1 + lines);
  };
  EXPECT_EQ(lrauv.place_of("hotel_w"), line_with("hotel_w: 16.8"));
  EXPECT_EQ(lrauv.place_of("fins.limit_rad"), line_with("limit_rad: 0.26"));
  EXPECT_EQ(lrauv.place_of("dimensions_m.width"), line_with("width: 0.305"));
  EXPECT_EQ(lrauv.place_of("mounts[0].direction"), line_with("direction: [1, 0, 0]"));
  // What it does not say would stand in what is around it.
  EXPECT_EQ(lrauv.place_of("fins.lag_s"), line_with("fins:"));
  EXPECT_EQ(lrauv.place_of("mounts[7].turns"), line_with("mounts:"));
  EXPECT_EQ(lrauv.place_of("lift.M_uw"), file);
}

TEST(ReadVehicle, RefusesWhatNoVehicleIsAndSaysWhy) {
  EXPECT_EQ(refusal("x500", "kind: uav", "kind: uav"), "nothing was refused");
  EXPECT_TRUE(contains(refusal("x500", "kind: uav", "kind: drone"), "expected rov, auv, uav"));
  EXPECT_TRUE(contains(refusal("x500", "largest_step_s: 0.004", "largest_step_s: 0.05"), "0.004"));
  EXPECT_TRUE(contains(refusal("x500", "kind: uav", "kind: usv"), "has hulls"));
  EXPECT_TRUE(
      contains(refusal("x500", "direction: [0, 0, -1]", "direction: [0, 0, -2]"), "direction"));
  EXPECT_TRUE(
      contains(refusal("x500", "direction: [0, 0, -1]", "direction: [0, 1, -1]"), "of length 1"));
  EXPECT_TRUE(contains(refusal("x500", "turns: clockwise", "turns: cw"), "counterclockwise"));
  EXPECT_TRUE(contains(refusal("x500", "hotel_w: 8", "hotel_load_w: 8"), "hotel_w"));
  EXPECT_TRUE(contains(refusal("x500", "capacity_ah: 5.0", "capacity_ah: 5000"), "not mAh"));
  EXPECT_TRUE(contains(refusal("bluerov2_heavy", "model: t200", "model: t100"), "t200"));
  EXPECT_TRUE(contains(refusal("lrauv_tethys", "stall_rad: 0.17", "stall_deg: 9.7"), "stall_rad"));
  EXPECT_TRUE(
      contains(refusal("lrauv_tethys", "hotel_w: 16.8", "hotel_w: 16.8\nwings: 2"), "wings"));
  EXPECT_TRUE(contains(refusal("lrauv_tethys",
                               "mounts:\n  - {position_m: [-1.43162, 0, 0], "
                               "direction: [1, 0, 0]}\n",
                               ""),
                       "found 0 thrusters"));
}

}  // namespace
}  // namespace slackwater::twin::read_vehicle_test

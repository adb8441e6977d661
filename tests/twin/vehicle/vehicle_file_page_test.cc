#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fields/base/constants.h"
#include "tests/support/page_keys.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/validation/flight.h"
#include "twin/body/attitude.h"

// The page api/docs/vehicle_file.md has the keys that the readers of a vehicle's file ask for, each
// in the section of its reader, and no others; and its example is a vehicle.

namespace slackwater::twin::vehicle_file_page_test {
namespace {

namespace fs = std::filesystem;

using tests::in_one_but_not;
using tests::keys_in_tables;
using tests::section_of;
using tests::text_of_source;
using tests::Words;
using tests::words_quoted_in;
using tests::yaml_block_of;

/// A section of the page, and the readers of the keys in its tables.
struct PagePart {
  const char* title;
  std::vector<const char*> readers;
};
const std::vector<PagePart> parts{
    {"The vehicle as a whole", {"twin/vehicle/read_vehicle.cc"}},
    {"Body",
     {"twin/vehicle/read_body.cc", "twin/vehicle/read_derivatives.cc",
      "twin/vehicle/read_cross_flow.cc", "twin/body/floating_hull.cc"}},
    {"Thrusters and fins",
     {"twin/vehicle/read_mounts.cc", "twin/thruster/read_thruster.cc",
      "twin/thruster/read_propeller.cc", "twin/thruster/read_open_water.cc",
      "twin/vehicle/read_fins.cc"}},
    {"Battery", {"twin/battery/read_battery.cc"}},
    {"Autopilot", {"twin/control/read_autopilot.cc"}},
    {"Tether", {"twin/tether/read_tether.cc"}},
    {"Sensors", {"twin/sensor/read_sensors.cc"}}};

/// What stands between quotes in the readers and is no key: words that a key may have, folders, and
/// pieces of messages and names.
const Words no_keys{"rov",       "auv",    "uav",       "usv",      "vessel",
                    "clockwise", "apart",  "included",  "left_out", "counterclockwise",
                    "table",     "drive",  "propeller", "rotor",    "moving_mass",
                    "volume",    "none",   "pulses",    "voltages", "batteries",
                    "thruster_", "XYZKMN", "uvwpqr"};

/// The names that are made of letters: read_derivatives.cc.
Words derivatives() {
  Words made;
  for (const char force : std::string_view("XYZKMN")) {
    for (const char motion : std::string_view("uvwpqr")) {
      const std::string name{force, '_', motion};
      made.insert(name);
      made.insert(name + "_dot");
    }
  }
  for (const char* name :
       {"X_u_abs_u", "Y_v_abs_v", "Z_w_abs_w", "K_p_abs_p", "M_q_abs_q", "N_r_abs_r"})
    made.insert(name);
  return made;
}

Words keys_asked_for(const PagePart& part) {
  Words asked;
  if (std::string_view(part.title) == "Body") asked = derivatives();
  for (const char* reader : part.readers)
    for (const std::string& word : words_quoted_in(text_of_source(reader)))
      if (!no_keys.contains(word)) asked.insert(word);
  return asked;
}

const char* const page_of_vehicles = "api/docs/vehicle_file.md";

TEST(VehicleFilePage, HasTheKeysThatTheReadersAskFor) {
  const std::string page = text_of_source(page_of_vehicles);
  std::size_t count = 0;
  for (const PagePart& part : parts) {
    const Words asked = keys_asked_for(part);
    const Words told = keys_in_tables(section_of(page, std::string("## ") + part.title));
    EXPECT_EQ(in_one_but_not(asked, told), "") << "are not in a table of: " << part.title;
    EXPECT_EQ(in_one_but_not(told, asked), "") << "nobody asks for, of: " << part.title;
    count += told.size();
  }
  EXPECT_GT(count, 300U) << "the page was not read";
}

/// Else the keys of a new reader would be missed.
TEST(VehicleFilePage, EveryReaderHasASection) {
  Words known;
  for (const PagePart& part : parts) known.insert(part.readers.begin(), part.readers.end());
  std::size_t count = 0;
  for (const char* folder : {"vehicle", "thruster", "battery", "tether", "sensor"}) {
    for (const auto& entry : fs::directory_iterator(tests::source_folder() / "twin" / folder)) {
      const std::string name = entry.path().filename().string();
      if (!name.starts_with("read_") || !name.ends_with(".cc")) continue;
      ++count;
      EXPECT_TRUE(known.contains(std::string("twin/") + folder + "/" + name)) << name;
    }
  }
  EXPECT_GT(count, 10U) << "the sources were not found";
}

TEST(VehicleFilePage, KeysAreToldFromOtherWords) {
  EXPECT_EQ(words_quoted_in("#include \"gone\"\n"
                            "  c.number(\"length_m\", {0, 1});  // not \"this\"\n"
                            "  c.refuse(\"width_m\", \"give a width\");\n"),
            (Words{"length_m", "width_m"}));
  EXPECT_EQ(keys_in_tables("| your table | key |\n|---|---|\n| `not` | |\n\n"
                           "| key | unit |\n|---|---|\n| `a`, **`b_m`** | `c` |\ntext `d`\n"),
            (Words{"a", "b_m"}));
  EXPECT_EQ(section_of("x\n## One\n1\n### Of it\n## Two\n2\n", "## One"), "\n## One\n1\n### Of it");
}

/// From the tables as they are typed in: the sums and signs that the page says come of them.
TEST(VehicleFilePage, ItsExampleIsAVehicle) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "remus100.yaml")
      << yaml_block_of(text_of_source(page_of_vehicles), "id: ");
  const Vehicle remus = read_vehicle(folder / "remus100.yaml", tests::source_folder() / "data");
  for (const std::string& warning : remus.warnings) ADD_FAILURE() << warning;
  // 24.0 less the moment of the added mass, 35.5 - 0.93; likewise aside.
  EXPECT_NEAR(remus.body.speed_lift.m_uw, -10.57, 1e-12);
  EXPECT_NEAR(remus.body.speed_lift.n_uv, 10.57, 1e-12);
  EXPECT_NEAR(remus.body.speed_lift.z_uq, -6.15, 1e-12);
  EXPECT_NEAR(remus.rudder.position_x_m, -0.638, 5e-4);
  EXPECT_NEAR(remus.elevator.position_x_m, -0.638, 5e-4);
  EXPECT_EQ(remus.mount[0].name, "propeller");
  // Fossen's model of it, with the same drag and propeller, comes to 1.00117 and 2.55365 m/s at 600
  // and 1525 turns a minute: thrust is drag there. 2 % of the speed are 4 % of the drag.
  for (const auto& [turns_a_minute, speed_m_s] :
       {std::pair{600.0, 1.00117}, std::pair{1525.0, 2.55365}}) {
    ThrusterSurroundings<double> around;
    around.advance_m_s = speed_m_s;
    around.voltage_v = 24;
    const double shaft_rad_s = turns_a_minute * 2 * constants::pi / 60;
    const double drag_n = remus.body.quadratic_damping.linear.x * speed_m_s * speed_m_s;
    EXPECT_NEAR(run(remus.thrusters[0], shaft_rad_s, around).thrust_n, drag_n, 0.04 * drag_n);
  }
}

/// It is unstable without its fins: its autopilot holds it on the way of the page's dive.
TEST(VehicleFilePage, ItsExampleDives) {
  const std::string page = text_of_source(page_of_vehicles);
  const tests::TemporaryFolder folder;
  const std::string file = (folder / "remus100.yaml").string();
  std::ofstream(file) << yaml_block_of(page, "id: ");
  std::string dive = yaml_block_of(page, "name: A dive");
  const std::string model = "model: remus100.yaml";
  const std::size_t at = dive.find(model);
  ASSERT_NE(at, std::string::npos);
  tests::Flight flight(dive.replace(at, model.size(), "model: " + file));
  double deepest_m = 0, steepest_rad = 0;
  while (flight.body().position_m.x < 590 && flight.time_s() < 500) {
    flight.step();
    deepest_m = std::max(deepest_m, flight.body().position_m.z);
    const EulerAngles angles = euler_angles(flight.body().attitude);
    steepest_rad = std::max({steepest_rad, std::abs(angles.pitch_rad), std::abs(angles.roll_rad)});
  }
  EXPECT_GE(flight.body().position_m.x, 590);
  EXPECT_NEAR(flight.body().position_m.y, 0, 1);
  EXPECT_NEAR(flight.body().position_m.z, 10 + 10 * 440.0 / 450, 0.5);
  EXPECT_LE(deepest_m, 20.5);
  EXPECT_LT(steepest_rad, 30 * constants::degree);
}

}  // namespace
}  // namespace slackwater::twin::vehicle_file_page_test

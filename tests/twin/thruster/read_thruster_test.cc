#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/support/contains.h"
#include "tests/support/thruster_for_tests.h"

namespace slackwater::twin::read_thruster_test {
namespace {

using tests::contains;

const std::string table_yaml = R"(kind: table
propeller_diameter_m: 0.076
rise_time_constant_s: 0.2
fall_time_constant_s: 0.2
pwm_least_us: 1100
pwm_zero_us: 1500
pwm_most_us: 1900
measured:
  - {voltage_v: 12, pwm_us: [1100, 1500, 1900], thrust_n: [-28, 0, 36], power_w: [204, 0, 203]}
  - {voltage_v: 16, pwm_us: [1100, 1500, 1700, 1900], thrust_n: [-40, 0, 18, 51],
     power_w: [389, 0, 73, 381]}
)";
const std::string rotor_yaml = R"(kind: rotor
propeller_diameter_m: 0.254
thrust_n_s2: 8.54858e-06
torque_arm_m: 0.016
efficiency: 0.59
most_shaft_rad_s: 1000
rise_time_constant_s: 0.0125
fall_time_constant_s: 0.025
)";
const std::string drive_yaml = R"(kind: drive
propeller_diameter_m: 0.2
efficiency: 0.677
most_thrust_n: 250
least_thrust_n: -100
idle_power_w: 40
most_power_w: 700
rise_time_constant_s: 0.3
fall_time_constant_s: 0.3
)";

std::string refusal(std::string yaml, const std::string& line, const std::string& instead) {
  const std::size_t at = yaml.find(line);
  EXPECT_NE(at, std::string::npos) << line;
  try {
    (void)tests::thruster_from(yaml.replace(at, line.size(), instead));
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

TEST(ReadThruster, TakesWhatIsWell) {
  EXPECT_EQ(refusal(table_yaml, "0.2", "0.2"), "nothing was refused");
  EXPECT_EQ(refusal(rotor_yaml, "0.016", "0.016"), "nothing was refused");
  EXPECT_EQ(refusal(drive_yaml, "0.3", "0.3"), "nothing was refused");
  const Thruster table = tests::thruster_from(table_yaml);
  EXPECT_EQ(table.table.command.count, 5U);
  EXPECT_EQ(table.table.voltage_v.count, 2U);
  EXPECT_NEAR(run(table, 0.25, {0.0, 0.0, 14.0, 0.0}).thrust_n, 9, 1e-12);
}

TEST(ReadThruster, RefusesTablesThatNoThrusterHas) {
  EXPECT_TRUE(contains(refusal(table_yaml, "0, 18, 51", "0, 52, 51"), "Smooth"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[-28, 0, 36]", "[-28, 1, 36]"), "at pwm_zero_us"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[-28, 0, 36]", "[0, 0, 36]"), "negative thrust"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[-28, 0, 36]", "[-28, 0]"), "2 of thrust_n"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[-28, 0, 36]", "[-28, 0, .nan]"), "thrust_n"));
  // kgf, and a diameter in millimetres or centimetres
  EXPECT_TRUE(contains(refusal(table_yaml, "[-40, 0, 18, 51]", "[-4.1, 0, 1.8, 5.2]"), "not kgf"));
  EXPECT_TRUE(contains(refusal(table_yaml, "0.076", "76"), "propeller_diameter_m"));
  EXPECT_TRUE(contains(refusal(table_yaml, "0.076", "7.6"), "metres"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[204, 0, 203]", "[204, 0, -203]"), "power_w"));
  EXPECT_TRUE(contains(refusal(table_yaml, "[1100, 1500, 1900]", "[1100, 1510, 1900]"), "pwm_us"));
  EXPECT_TRUE(contains(refusal(table_yaml, "1700", "1700.0137"), "no common step"));
  EXPECT_TRUE(contains(refusal(table_yaml, "voltage_v: 16", "voltage_v: 11"), "rising order"));
  EXPECT_TRUE(
      contains(refusal(table_yaml, "pwm_zero_us: 1500", "pwm_zero_us: 1950"), "pwm_zero_us"));
}

TEST(ReadThruster, RefusesOtherUnitsAndKinds) {
  EXPECT_TRUE(contains(refusal(rotor_yaml, "8.54858e-06", "9.375e-08"), "rad/s"));  // per rpm^2
  EXPECT_TRUE(contains(refusal(rotor_yaml, "0.254", "10"), "thrust_n_s2"));         // inches
  EXPECT_TRUE(contains(refusal(rotor_yaml, "0.59", "59"), "efficiency"));
  EXPECT_TRUE(
      contains(refusal(rotor_yaml, "kind: rotor", "kind: propellor"), "expected table, propeller"));
  EXPECT_TRUE(contains(refusal(rotor_yaml, "0.0125", "-1"), "rise_time_constant_s"));
  EXPECT_TRUE(contains(refusal(rotor_yaml, "torque_arm_m", "moment_arm_m"), "torque_arm_m"));
  EXPECT_TRUE(contains(refusal(drive_yaml, "-100", "100"), "least_thrust_n"));
  EXPECT_TRUE(contains(refusal(drive_yaml, "700", "30"), "idle power"));
  EXPECT_TRUE(contains(refusal("model: t200\n", "t200", "t300"), "t200"));
  EXPECT_TRUE(contains(refusal("model: t200\nlag_s: 1\n", "lag_s", "lag_s"), "lag_s"));
}

}  // namespace
}  // namespace slackwater::twin::read_thruster_test

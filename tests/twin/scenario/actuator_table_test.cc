#include "twin/scenario/actuator_table.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin::actuator_table_test {
namespace {

/// A scenario with that task on line 7.
Scenario with_task(const std::string& task) {
  return parse_scenario(
      "name: test\nseed: 7\nduration: 30min\nwater: {made_up: {depth_m: 60}}\nvehicles:\n"
      "  - {name: auv, model: lrauv_tethys, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: [\n"
      "      {do: actuators, " +
          task + "}]}\n",
      "test.yaml");
}

std::string said_of(const std::string& task) {
  try {
    (void)with_task(task);
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

TEST(ActuatorTable, IsRowsOfNamesWithTheirUnits) {
  const ScenarioTask task =
      with_task(
          "duration_s: 60, keep: [depth, speed], speed_m_s: 1.2, table: "
          "[{at_s: 0, rudder_deg: 5, left_propeller_rad_s: 80}, {at_s: 2.5, volume_m3: "
          "-1e-4}]")
          .vehicles[0]
          .tasks[0];
  EXPECT_EQ(task.kind, ScenarioTask::Kind::actuators);
  EXPECT_EQ(task.hold_s, 60);
  const ActuatorTable& table = task.table.value();
  EXPECT_TRUE(table.keeps_depth && table.keeps_speed && !table.keeps_heading);
  EXPECT_EQ(table.speed_m_s, 1.2);
  ASSERT_EQ(table.rows.size(), 2U);
  using Setting = std::vector<std::pair<std::string, double>>;
  EXPECT_EQ(table.rows[0].setting, (Setting{{"rudder_deg", 5}, {"left_propeller_rad_s", 80}}));
  EXPECT_EQ(table.rows[1].at_s, 2.5);
  EXPECT_EQ(table.rows[1].setting, (Setting{{"volume_m3", -1e-4}}));
  EXPECT_EQ(table.rows[1].place.text, "test.yaml:7");
}

TEST(ActuatorTable, HasKeysThatEndInAUnit) {
  EXPECT_EQ(actuator_key("thruster_1_rad_s")->name, "thruster_1");
  EXPECT_EQ(actuator_key("thruster_1_rad_s")->unit, KeyUnit::rad_s);
  EXPECT_EQ(actuator_key("volume_m3")->unit, KeyUnit::m3);
  EXPECT_EQ(actuator_key("moving_mass_m")->unit, KeyUnit::m);
  EXPECT_EQ(actuator_key("stern_rpm")->unit, KeyUnit::rpm);
  EXPECT_FALSE(actuator_key("rudder"));
  EXPECT_FALSE(actuator_key("_deg")) << "of nothing";
}

TEST(ActuatorTable, IsRefusedWithItsLineAndAWayOut) {
  for (const auto& [task, words] : {
           std::pair{"duration_s: 9, table: []", "found 0 rows, expected 1 to 100000"},
           {"duration_s: 9, table: [{at_s: 0}]", "found a row without an actuator"},
           {"duration_s: 9, table: [{at_s: 0, rudder: 5}]", "rudder: expected the name of an"},
           {"duration_s: 9, table: [{at_s: 0, rudder_share: 1.5}]", "rudder_share: "},
           {"duration_s: 9, table: [{at_s: 0, rudder_deg: hard}]", "rudder_deg: "},
           {"duration_s: 9, table: [{at_s: 3, rudder_deg: 5}, {at_s: 3, rudder_deg: 6}]",
            "found 3 after 3; list rows in the order of their time"},
           {"duration_s: 9, table: [{at_s: 9, rudder_deg: 5}]",
            "found 9, and the task lasts 9 s; give it a longer duration"},
           {"duration_s: 9, keep: [course], table: [{at_s: 0, rudder_deg: 5}]",
            "found course, expected depth, heading or speed"},
           {"duration_s: 9, speed_m_s: 1, table: [{at_s: 0, rudder_deg: 5}]",
            "found without keep: [speed]"},
           {"table: [{at_s: 0, rudder_deg: 5}]", "duration"},
       }) {
    const std::string said = said_of(task);
    EXPECT_EQ(said.rfind("test.yaml:7: ", 0), 0U) << said;
    EXPECT_NE(said.find(words), std::string::npos) << said << "\nhas no: " << words;
  }
}

}  // namespace
}  // namespace slackwater::twin::actuator_table_test

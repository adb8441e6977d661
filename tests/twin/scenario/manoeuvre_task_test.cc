#include "twin/scenario/manoeuvre_task.h"

#include <gtest/gtest.h>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin::manoeuvre_task_test {
namespace {

using constants::degree;

/// A scenario with that task on line 7.
ScenarioTask read_from(const std::string& task) {
  return parse_scenario(
             "name: test\nseed: 7\nduration: 30min\nwater: {made_up: {depth_m: 60}}\nvehicles:\n"
             "  - {name: auv, model: remus100, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: "
             "[\n      " +
                 task + "]}\n",
             "test.yaml")
      .vehicles[0]
      .tasks[0];
}

TEST(ManoeuvreTask, IsWhatTheFileSays) {
  const ScenarioTask task = read_from(
      "{do: zig_zag, side: port, helm_deg: 10, heading_change_deg: 15, speed_m_s: 1.2, approach_s: "
      "90, lasts: 5min, executes: 7}");
  EXPECT_EQ(task.kind, ScenarioTask::Kind::manoeuvre);
  const ManoeuvreTask& m = task.manoeuvre.value();
  EXPECT_EQ(m.kind, ManoeuvreKind::zig_zag);
  EXPECT_TRUE(m.to_port);
  EXPECT_EQ(m.helms, std::vector<double>{10 * degree});
  EXPECT_FALSE(m.helms_are_shares);
  EXPECT_EQ(m.heading_change_rad, 15 * degree);
  EXPECT_EQ(m.speed_m_s, 1.2);
  EXPECT_EQ(m.executes, 7U);
  EXPECT_EQ(task.hold_s, 90 + 300);
  EXPECT_EQ(m.place.text, "test.yaml:7");
}

TEST(ManoeuvreTask, HasTheDefaultsOfTheTrialsOfShips) {
  const ManoeuvreTask zig_zag = read_from("{do: zig_zag, lasts_s: 60}").manoeuvre.value();
  EXPECT_EQ(zig_zag.heading_change_rad, 20 * degree);
  EXPECT_TRUE(zig_zag.helms.empty()) << "20 degrees, of what has a rudder";
  EXPECT_FALSE(zig_zag.to_port);
  EXPECT_EQ(zig_zag.approach_s, 60);
  const ManoeuvreTask circle = read_from("{do: turning_circle, lasts_s: 60}").manoeuvre.value();
  EXPECT_EQ(circle.heading_change_rad, 540 * degree);
  const ManoeuvreTask spiral =
      read_from("{do: spiral, helms_share: [0.5, 0, -0.5], each_s: 40}").manoeuvre.value();
  EXPECT_EQ(spiral.helms, (std::vector<double>{0.5, 0, -0.5}));
  EXPECT_TRUE(spiral.helms_are_shares);
  EXPECT_EQ(longest_s(spiral), 60 + 3 * 40);
  EXPECT_EQ(longest_s(read_from("{do: pull_out, turn_s: 50, lasts_s: 70}").manoeuvre.value()),
            60 + 50 + 70);
}

TEST(ManoeuvreTask, OfStepsHasWhatEachSays) {
  const ManoeuvreTask m = read_from(
                              "{do: steps, duration_s: 90, table: [{at_s: 0, speed_m_s: 1}, {at_s: "
                              "30, heading_deg: 20, "
                              "depth_m: 12}]}")
                              .manoeuvre.value();
  ASSERT_EQ(m.steps.size(), 2U);
  EXPECT_EQ(m.steps[0].speed_m_s, 1);
  EXPECT_FALSE(m.steps[0].heading_rad);
  EXPECT_EQ(m.steps[1].heading_rad, 20 * degree);
  EXPECT_EQ(m.steps[1].depth_m, 12);
  EXPECT_EQ(longest_s(m), 90);
}

TEST(ManoeuvreTask, IsRefusedWithItsLineAndAWayOut) {
  for (const auto& [task, words] : {
           std::pair{"{do: turning_circle}", "lasts_s: missing; give lasts_s: 60, or lasts: 1min"},
           {"{do: pull_out, lasts_s: 60}", "turn_s: missing"},
           {"{do: spiral, helms_deg: [5, 0, -5]}", "each_s: missing"},
           {"{do: steps, table: [{at_s: 0, speed_m_s: 1}]}", "duration_s: missing"},
           {"{do: zig_zag, lasts_s: 0}", "lasts_s"},
           {"{do: zig_zag, lasts_s: 60, approach_s: 1}", "approach_s"},
           {"{do: zig_zag, lasts_s: 60, heading_change_deg: 120}", "heading_change_deg"},
           {"{do: zig_zag, lasts_s: 60, side: left}", "found left, expected starboard or port"},
           {"{do: zig_zag, lasts_s: 60, helm_deg: 5, helm_share: 0.5}",
            "found beside helm_deg; give one of the two"},
           {"{do: zig_zag, lasts_s: 60, helm_deg: -5}", "helm_deg"},
           {"{do: zig_zag, lasts_s: 60, turn_s: 5}", "turn_s"},
           {"{do: turning_circle, lasts_s: 60, executes: 5}", "executes"},
           {"{do: spiral, helms_deg: [5], each_s: 60}", "found 1 helms, expected 2 to 200"},
           {"{do: spiral, helms_deg: [5, 0], helms_share: [1, 0], each_s: 60}",
            "found beside helms_deg"},
           {"{do: steps, duration_s: 60, table: []}", "found 0 steps, expected 1 to 10000"},
           {"{do: steps, duration_s: 60, table: [{at_s: 0}]}", "found a step of nothing"},
           {"{do: steps, duration_s: 60, table: [{at_s: 9, speed_m_s: 1}, {at_s: 9, speed_m_s: "
            "2}]}",
            "found 9 after 9; list steps in the order of their time"},
           {"{do: steps, duration_s: 60, table: [{at_s: 60, speed_m_s: 1}]}",
            "found 60, and the task lasts 60 s"},
           {"{do: steps, duration_s: 60, table: [{at_s: 6, depth_m: -1}]}", "depth_m"},
       }) {
    try {
      (void)read_from(task);
      ADD_FAILURE() << task << " is not refused";
    } catch (const Error& problem) {
      const std::string& said = problem.message();
      EXPECT_EQ(said.rfind("test.yaml:7: ", 0), 0U) << said;
      EXPECT_NE(said.find(words), std::string::npos) << said << "\nhas no: " << words;
    }
  }
}

}  // namespace
}  // namespace slackwater::twin::manoeuvre_task_test

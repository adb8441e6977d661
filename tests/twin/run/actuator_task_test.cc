#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "tests/bench/counted_allocations.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::actuator_task_test {
namespace {

using constants::degree;

/// The first task is on line 9, without a current.
std::string with_tasks(const std::string& model, const std::string& tasks,
                       const std::string& depth = "depth_m: 20") {
  return "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 1\n"
         "water: {made_up: {depth_m: 60}}\nvehicles:\n"
         "  - {name: it, model: " +
         model + ", start: {north_m: 0, east_m: 0, " + depth + "}, tasks: [\n      " + tasks +
         "]}\n";
}

std::string said_of(const std::string& model, const std::string& task,
                    const std::string& depth = "depth_m: 20") {
  try {
    (void)ready_of(with_tasks(model, task, depth));
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

TEST(ActuatorTask, IsTheSameCommandsOverTheArbiterToTheBit) {
  const auto by_table = lone_run(with_tasks(
      "lrauv_tethys",
      "{do: actuators, duration_s: 60, table: [{at_s: 0, thruster_1_rad_s: 20, rudder_deg: 5}, "
      "{at_s: 10, rudder_deg: -5, volume_share: 0.5}, {at_s: 20, elevator_deg: 4}]}"));
  const auto by_hand = lone_run(with_tasks("lrauv_tethys", "{do: hold}"));
  twin::SetActuators set;
  set.is_physical = true;
  set.given.give(0, 20);
  set.given.give(twin::rudder_channel, degree * 5);
  for (int i = 0; i < 600; ++i) {
    if (i == 200) {
      set.given.give(twin::rudder_channel, degree * -5);
      const twin::Vehicle& auv = *by_hand->agents()[0].vehicle;
      set.given.give(twin::volume_channel,
                     twin::channel_of(auv, twin::volume_channel)->of_share(0.5));
    }
    if (i == 400) set.given.give(twin::elevator_channel, degree * 4);
    by_hand->enqueue({0, 0, set});
    by_hand->step();
    by_table->step();
    const auto& a = state_of_lone(*by_table).vehicle;
    const auto& b = state_of_lone(*by_hand).vehicle;
    ASSERT_EQ(std::memcmp(&a, &b, sizeof a), 0) << "step " << i;
  }
  EXPECT_GT(state_of_lone(*by_table).vehicle.body.nu.linear.x, 0.3) << "it went";
}

TEST(ActuatorTask, TurnsByTwoThrustersToTheSlowerSide) {
  const auto run = lone_run(
      with_tasks("wamv16",
                 "{do: actuators, duration_s: 60, table: [{at_s: 0, thruster_1_share: 0.5, "
                 "thruster_2_share: 0.4}]}",
                 "depth_m: 0"));
  ASSERT_LT(run->agents()[0].vehicle->mount[0].position_m.y, 0) << "the first is to port";
  go_on(*run, 30);
  EXPECT_GT(yaw_rad(state_of_lone(*run)), 0.2);
}

/// Against the lift of its bladder, which the table fills.
TEST(ActuatorTask, KeepsItsDepthAndSpeedWhileTheRudderGoesByTheTable) {
  const auto run = lone_run(
      with_tasks("lrauv_tethys",
                 "{do: route, speed_m_s: 1, waypoints: [{north_m: 100, east_m: 0, depth_m: 20}]}, "
                 "{do: actuators, duration_s: 300, keep: [depth, speed], speed_m_s: 0.9, table: "
                 "[{at_s: 0, rudder_deg: 4, volume_share: 0.5}]}"));
  while (state_of_lone(*run).mission.task == 0 && run->time_s() < 600) run->step();
  ASSERT_EQ(state_of_lone(*run).mission.task, 1U);
  double turned_rad = 0, worst_m = 0;
  for (int i = 0; i < 200 * 20; ++i) {
    run->step();
    const twin::BodyState<double>& body = state_of_lone(*run).vehicle.body;
    turned_rad += helm_step_s * body.nu.angular.z;
    worst_m = std::max(worst_m, std::abs(body.position_m.z - 20));
  }
  const twin::VehicleState<double>& v = state_of_lone(*run).vehicle;
  EXPECT_NEAR(v.rudder_rad, 4 * degree, 1e-12);
  EXPECT_GT(turned_rad, 1);
  EXPECT_LT(worst_m, 0.25) << "0.57 m where it is not kept";
  EXPECT_NEAR(v.body.nu.linear.x, 0.9, 0.1);
}

TEST(ActuatorTask, RestsWhatNobodyNamesUntilItsRow) {
  const auto run = lone_run(
      with_tasks("lrauv_tethys",
                 "{do: actuators, duration_s: 60, table: [{at_s: 5, thruster_1_rad_s: 20}, "
                 "{at_s: 9, rudder_deg: 5}]}"));
  go_on(*run, 5);
  EXPECT_EQ(state_of_lone(*run).vehicle.thruster[0], 0);
  go_on(*run, 3.95);
  EXPECT_GT(state_of_lone(*run).vehicle.thruster[0], 1);
  EXPECT_EQ(state_of_lone(*run).vehicle.rudder_rad, 0);
  go_on(*run, 1);
  EXPECT_GT(state_of_lone(*run).vehicle.rudder_rad, 0.01);
}

TEST(ActuatorTask, EndsInTimeAndTheNextOneBeginsWhereItIs) {
  const auto run = lone_run(
      with_tasks("wamv16",
                 "{do: actuators, duration_s: 20, table: [{at_s: 0, thruster_1_share: 0.5, "
                 "thruster_2_share: 0.5}]}, {do: hold}",
                 "depth_m: 0"));
  go_on(*run, 20);
  EXPECT_EQ(state_of_lone(*run).mission.task, 0U);
  const twin::Triple<double> left_m = state_of_lone(*run).vehicle.body.position_m;
  ASSERT_GT(left_m.x, 5);
  go_on(*run, 0.1);
  EXPECT_EQ(state_of_lone(*run).mission.task, 1U);
  EXPECT_NEAR(state_of_lone(*run).mission.kept_m.x, left_m.x, 0.5);
}

TEST(ActuatorTask, StandsStillUnderTheHelmAndGoesOnAfterIt) {
  const auto run = lone_run(with_tasks(
      "wamv16", "{do: actuators, duration_s: 20, table: [{at_s: 0, thruster_1_share: 0.5}]}",
      "depth_m: 0"));
  go_on(*run, 5);
  const double held_s = state_of_lone(*run).mission.held_s;
  steer(*run, {0, 0, 0, 0}, 10);
  EXPECT_EQ(state_of_lone(*run).mission.held_s, held_s);
  EXPECT_EQ(state_of_lone(*run).helm.mode, twin::HelmMode::velocity);
  run->enqueue({0, 0, twin::Resume{}});
  go_on(*run, 5);
  EXPECT_NEAR(state_of_lone(*run).mission.held_s, held_s + 5, 1e-6);
  EXPECT_GT(state_of_lone(*run).vehicle.thruster[0], 5);
}

TEST(ActuatorTask, StepsWithoutAllocating) {
  const auto run =
      lone_run(with_tasks("lrauv_tethys",
                          "{do: actuators, duration_s: 60, keep: [depth], table: [{at_s: 0, "
                          "thruster_1_rad_s: 20}, {at_s: 3, rudder_deg: 5}]}"));
  go_on(*run, 1);
  const std::size_t before = bench::allocations();
  go_on(*run, 5);
  EXPECT_EQ(bench::allocations(), before);
}

TEST(ActuatorTask, IsRefusedWithTheLineOfItsRow) {
  const std::string said = said_of("wamv16",
                                   "{do: actuators, duration_s: 9, table: [\n"
                                   "        {at_s: 0, thruster_1_share: 1},\n"
                                   "        {at_s: 1, thruster_3_share: 1}]}",
                                   "depth_m: 0");
  EXPECT_EQ(said.rfind("vehicle it: test.yaml:11: thruster_3_share: found thruster_3", 0), 0U)
      << said;
}

TEST(ActuatorTask, OfWhatTheVehicleCannotIsRefusedWithItsLine) {
  struct Case {
    const char* model;
    const char* depth;
    const char* task;
    const char* words;
  };
  const char* const deep = "depth_m: 20";
  const char* const afloat = "depth_m: 0";
  for (const Case& c : {
           Case{"wamv16", afloat, "table: [{at_s: 0, rudder_deg: 5}]",
                "rudder_deg: found rudder, which the WAM-V 16 has not; expected one of thruster_1, "
                "thruster_2, with its unit"},
           Case{"lrauv_tethys", deep, "table: [{at_s: 0, rudder_rad_s: 5}]",
                "rudder_rad_s: found a unit that rudder has not; expected rudder_deg or "
                "rudder_share"},
           Case{"lrauv_tethys", deep, "table: [{at_s: 0, thruster_1_n: 5}]",
                "expected thruster_1_rad_s or thruster_1_rpm or thruster_1_share"},
           Case{"lrauv_tethys", deep, "table: [{at_s: 0, rudder_deg: 60}]",
                "rudder_deg: found 60, expected -"},
           Case{"lrauv_tethys", deep, "table: [{at_s: 0, rudder_deg: 6, rudder_share: 0.1}]",
                "found rudder twice in a row"},
           Case{"lrauv_tethys", deep, "keep: [heading], table: [{at_s: 0, rudder_deg: 6}]",
                "keep: found heading, and the table has all that would keep it"},
           Case{"lrauv_tethys", deep, "keep: [speed], table: [{at_s: 0, thruster_1_share: 0.5}]",
                "keep: found speed, and the table has all that would keep it"},
           Case{"lrauv_tethys", deep,
                "keep: [speed], speed_m_s: 9, table: [{at_s: 0, rudder_deg: 6}]",
                "speed_m_s: found 9 m/s, expected at most "},
           Case{"lrauv_tethys", deep,
                "keep: [speed], speed_m_s: 0.1, table: [{at_s: 0, rudder_deg: 6}]",
                "speed_m_s: found 0.1 m/s, expected at least "},
           Case{"wamv16", afloat, "keep: [depth], table: [{at_s: 0, thruster_1_share: 0.5}]",
                "keep: found depth, and the WAM-V 16 floats; leave depth out"},
       }) {
    const std::string said =
        said_of(c.model, std::string("{do: actuators, duration_s: 9, ") + c.task + "}", c.depth);
    EXPECT_NE(said.find(c.words), std::string::npos) << said << "\nhas no: " << c.words;
    EXPECT_NE(said.find("vehicle it: test.yaml:9: "), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace slackwater::tests::actuator_task_test

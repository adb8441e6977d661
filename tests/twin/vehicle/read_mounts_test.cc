#include "tests/support/contains.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::read_mounts_test {
namespace {

using tests::contains;
using tests::lrauv_mount;

TEST(ReadMounts, EachMountHasTheThrusterItNames) {
  const Vehicle vehicle = tests::lrauv_of_all_kinds();
  ASSERT_EQ(vehicle.thrusters.size(), 2U);
  ASSERT_EQ(vehicle.mounts, 3U);
  EXPECT_EQ(vehicle.mount[0].name, "propeller");
  EXPECT_EQ(vehicle.mount[1].name, "bow_tunnel");
  EXPECT_EQ(vehicle.mount[2].name, "thruster_3");
  EXPECT_TRUE(thruster_of(vehicle, 0).propeller.open_water.is_known());
  EXPECT_FALSE(thruster_of(vehicle, 1).propeller.open_water.is_known());
  EXPECT_EQ(thruster_of(vehicle, 2).most_command, 100);
  // Each by its own lag and its own numbers: pushes of the second tunnel lift the stern.
  VehicleState<double> state = placed(vehicle, {0, 0, 20}, 0);
  VehicleCommand<double> command;
  command.thruster = {0, 50, -50};
  const StepPlan plan = plan_step(vehicle, 0.1, 24);
  step(vehicle, plan, state, command, {});
  EXPECT_GT(state.body.nu.angular.z, 0);
  EXPECT_LT(state.body.nu.angular.y, 0);
  for (int i = 0; i < 100; ++i) step(vehicle, plan, state, command, {});
  EXPECT_EQ(state.thrust_n[0], 0);
  EXPECT_NEAR(state.thrust_n[1], 0.0005 * 2500, 1e-9);
  EXPECT_NEAR(state.thrust_n[2], -0.0003 * 2500, 1e-9);
}

TEST(ReadMounts, OfOneKindMayHaveNamesToo) {
  const Vehicle lrauv = tests::changed_vehicle(
      "lrauv_tethys",
      {{lrauv_mount, "  - {name: propeller, position_m: [-1.4, 0, 0], direction: [1, 0, 0]}\n"}});
  EXPECT_EQ(lrauv.mount[0].name, "propeller");
  EXPECT_EQ(tests::bundled_vehicle("lrauv_tethys").mount[0].name, "thruster_1");
  EXPECT_EQ(tests::bundled_vehicle("bluerov2_heavy").mount[7].name, "thruster_8");
}

TEST(ReadMounts, RefusesWhatHasNoThrusterOrNoNameOfItsOwn) {
  const std::string kind =
      "kind: drive, propeller_diameter_m: 0.2, efficiency: 0.5, most_thrust_n: 20, "
      "least_thrust_n: -10, rise_time_constant_s: 0.1, fall_time_constant_s: 0.1";
  const std::string at = "position_m: [-1, 0, 0], direction: [1, 0, 0]";
  const auto refusal = [&](const std::string& thrusters, const std::string& mounts) {
    return tests::refusal_of("lrauv_tethys",
                             {{tests::lrauv_thruster, thrusters}, {lrauv_mount, mounts}});
  };
  const std::string two = "thrusters: {main: {" + kind + "}, side: {" + kind + "}}\n";
  const std::string main = "  - {thruster: main, " + at + "}\n";
  const std::string side = "  - {thruster: side, " + at + "}\n";
  EXPECT_EQ(refusal(two, main + side), "nothing was refused");
  EXPECT_TRUE(contains(refusal(two, main + "  - {thruster: bow, " + at + "}\n"),
                       "found bow, expected one of `thrusters`: main, side"));
  EXPECT_TRUE(contains(refusal(two, "  - {" + at + "}\n"), "thruster"));
  EXPECT_TRUE(contains(refusal(two, main), "thrusters.side: no mount has it"));
  EXPECT_TRUE(contains(refusal(two + tests::lrauv_thruster, main + side), "leave one of the two"));
  EXPECT_TRUE(contains(refusal(tests::lrauv_thruster, main), "there is but `thruster`"));
  EXPECT_TRUE(contains(refusal("thrusters: {}\n", main), "found 0 kinds, expected 1 to 4"));
  EXPECT_TRUE(contains(refusal("thrusters: {main: {" + kind + ", turns: 2}}\n", main), "turns"));
  const auto named = [&](const std::string& name) {
    return refusal(tests::lrauv_thruster,
                   "  - {name: " + name + ", " + at + "}\n  - {" + at + "}\n");
  };
  EXPECT_EQ(named("bow"), "nothing was refused");
  EXPECT_TRUE(contains(named("thruster_2"), "found thruster_2, as of mount 1"));
  EXPECT_TRUE(contains(named("rudder"), "no thruster"));
  EXPECT_TRUE(contains(named("Bow-1"), "small letters"));
}

}  // namespace
}  // namespace slackwater::twin::read_mounts_test

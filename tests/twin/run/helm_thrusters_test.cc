#include "fields/base/check.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::helm_thrusters_test {
namespace {

using twin::HelmMode;

const std::string rov_start = "north_m: 0, east_m: 0, depth_m: 20";

/// With the thrusters by hand, renewed each half second.
void drive(twin::Run& run, const std::vector<double>& share, double for_s) {
  const int steps = static_cast<int>(std::lround(for_s / helm_step_s));
  for (int i = 0; i < steps; ++i) {
    if (i % 10 == 0) run.enqueue({0, 0, twin::SetThrusters{share}});
    run.step();
  }
}

TEST(HelmThrusters, OfATableHaveTheirCommand) {
  const auto run = lone_run(lone("bluerov2_heavy", rov_start));
  const std::vector<double> share{0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.05, 0};
  drive(*run, share, 5);
  for (std::size_t i = 0; i < share.size(); ++i)
    EXPECT_NEAR(state_of_lone(*run).vehicle.thruster[i], share[i], 1e-3) << i;
}

TEST(HelmThrusters, OfOtherKindsHaveThatShareOfTheirRange) {
  for (const auto& [model, start] :
       {std::pair{"lrauv_tethys", "north_m: 0, east_m: 0, depth_m: 20"},
        std::pair{"wamv16", "north_m: 0, east_m: 0, depth_m: 0"},
        std::pair{"ctv24", "north_m: 0, east_m: 0, depth_m: 0"}}) {
    const auto run = lone_run(lone(model, start));
    const twin::Vehicle& vehicle = *run->agents()[0].vehicle;
    drive(*run, std::vector<double>(vehicle.mounts, 0.5), 30);
    for (std::size_t i = 0; i < vehicle.mounts; ++i)
      EXPECT_NEAR(state_of_lone(*run).vehicle.thruster[i], 0.5 * vehicle.thrusters[0].most_command,
                  1e-3 * vehicle.thrusters[0].most_command)
          << model;
    EXPECT_EQ(twin::channel_of(vehicle, 0)->of_share(-1), vehicle.thrusters[0].least_command);
    EXPECT_EQ(twin::channel_of(vehicle, 0)->of_share(0), 0);
  }
}

TEST(HelmThrusters, OfARotorStandBelowNought) {
  const auto run = lone_run(lone("x500", "north_m: 0, east_m: 0, height_m: 30"));
  const twin::Vehicle& uav = *run->agents()[0].vehicle;
  EXPECT_EQ(twin::channel_of(uav, 0)->of_share(-0.5), 0);
  EXPECT_EQ(twin::channel_of(uav, 0)->of_share(1), uav.thrusters[0].most_command);
}

TEST(HelmThrusters, GiveTheMotionThatTheirThrustGives) {
  // Two outboards of a WAM-V: the thrust of each on its lever turns it, and ahead both push.
  const auto run = lone_run(lone("wamv16", "north_m: 0, east_m: 0, depth_m: 0"));
  drive(*run, {0.3, 0.3}, 30);
  const twin::VehicleState<double>& v = state_of_lone(*run).vehicle;
  EXPECT_GT(v.body.nu.linear.x, 0.5);
  EXPECT_NEAR(v.body.nu.angular.z, 0, 1e-6);
  const auto& mounts = run->agents()[0].vehicle->mount;
  drive(*run, {0.3, 0}, 10);
  // The moment of a thrust ahead on a lever to starboard turns to port.
  EXPECT_LT(state_of_lone(*run).vehicle.body.nu.angular.z * mounts[0].position_m.y, 0);
}

TEST(HelmThrusters, AreStoppedByAnEmptyBatteryAndAFault) {
  std::string empty = lone("bluerov2_heavy", rov_start + "");
  const std::string model = "model: bluerov2_heavy\n";
  empty.insert(empty.find(model) + model.size(), "    state_of_charge: 0.01\n");
  const auto run = lone_run(empty);
  drive(*run, std::vector<double>(8, 1), 120);
  EXPECT_GT(state_of_lone(*run).vehicle.battery.off, 0.5);
  for (const double thrust_n : state_of_lone(*run).vehicle.thrust_n) EXPECT_EQ(thrust_n, 0);

  std::string faulty = lone("bluerov2_heavy", rov_start);
  faulty.insert(faulty.find(model) + model.size(),
                "    conduct: {faults: [{fault: lost_thruster, thruster: 3, at_s: 2}]}\n");
  const auto lost = lone_run(faulty);
  drive(*lost, std::vector<double>(8, 0.2), 10);
  const twin::VehicleState<double>& v = state_of_lone(*lost).vehicle;
  int without = 0;
  for (const double behind : v.thruster) without += std::abs(behind) < 1e-3 ? 1 : 0;
  EXPECT_EQ(without, 1);
}

TEST(HelmThrusters, DoNotMakeAnRovFly) {
  const auto run = lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 3"));
  const twin::Agent& rov = run->agents()[0];
  // Up with all that pushes up.
  std::vector<double> up;
  for (std::size_t i = 0; i < rov.vehicle->mounts; ++i) {
    const double down = rov.vehicle->mount[i].direction.z;
    up.push_back(std::abs(down) < 0.5 ? 0 : -std::copysign(1, down));
  }
  double highest_m = 0;
  for (int i = 0; i < 60; ++i) {
    drive(*run, up, 0.5);
    highest_m = std::max(highest_m, -state_of_lone(*run).vehicle.body.position_m.z);
  }
  EXPECT_GT(highest_m, 0) << "it came up";
  EXPECT_LT(highest_m, 1);
}

TEST(HelmThrusters, LeaveTheAutopilotReadyToTakeOver) {
  // Fast by the autopilot, then at rest by hand: what it asked for before is forgotten.
  const auto run = lone_run(lone("bluerov2_heavy", rov_start));
  steer(*run, {1, 0, 0, 0}, 20);
  drive(*run, std::vector<double>(8, 0), 60);
  ASSERT_LT(state_of_lone(*run).vehicle.body.nu.linear.x, 0.05);  // it floats up
  const twin::Triple<double> left = state_of_lone(*run).vehicle.body.position_m;
  run->enqueue({0, 0, twin::HoldHere{}});
  double farthest_m = 0;
  for (int i = 0; i < 600; ++i) {
    run->step();
    const twin::Triple<double> off_m = state_of_lone(*run).vehicle.body.position_m - left;
    farthest_m = std::max(farthest_m, std::hypot(off_m.x, off_m.y));
  }
  EXPECT_LT(farthest_m, 0.15);
}

TEST(HelmThrusters, OfAnotherNumberOrBeyondOneAreABug) {
  const auto run = lone_run(lone("bluerov2_heavy", rov_start));
  EXPECT_THROW(run->enqueue({0, 0, twin::SetThrusters{{0.1, 0.1}}}), ContractViolation);
  EXPECT_THROW(run->enqueue({0, 0, twin::SetThrusters{std::vector<double>(8, 1.01)}}),
               ContractViolation);
  EXPECT_THROW(run->enqueue({0, 0, twin::SetThrusters{std::vector<double>(8, NAN)}}),
               ContractViolation);
  EXPECT_THROW(run->enqueue({0, 0, twin::SetVelocity{{NAN, 0, 0, 0}}}), ContractViolation);
}

}  // namespace
}  // namespace slackwater::tests::helm_thrusters_test

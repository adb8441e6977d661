#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "twin/control/autopilot.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin::real_thrusters_test {
namespace {

/// A vehicle of data/vehicles as the simulator steps it: its own thrusters, battery, fins and trim,
/// in still water or a steady current, the autopilot's thrusts turned into commands.
struct RealLoop {
  Vehicle vehicle;
  Autopilot autopilot;
  StepPlan plan;
  VehicleState<double> state;
  ControlState control;
  Triple<double> fluid_m_s;

  RealLoop(const char* id, double voltage_v, const Triple<double>& at_m) {
    const std::filesystem::path data = tests::source_folder() / "data";
    vehicle = read_vehicle(data / "vehicles" / (std::string(id) + ".yaml"), data);
    plan = plan_step(vehicle, vehicle.largest_step_s, voltage_v);
    ThrusterSurroundings<double> still;
    still.voltage_v = voltage_v;
    still.height_m = 1e3;
    const auto most = twin::run(vehicle.thrusters[0], vehicle.thrusters[0].most_command, still);
    const auto least = twin::run(vehicle.thrusters[0], vehicle.thrusters[0].least_command, still);
    const std::vector<ThrustRange> ranges(
        vehicle.mounts, {std::min(least.thrust_n, 0.0), most.thrust_n,
                         most.thrust_n > 0 ? most.torque_n_m / most.thrust_n : 0});
    autopilot =
        plan_autopilot(vehicle.autopilot, vehicle.kind, vehicle.body,
                       {std::span(vehicle.mount).first(vehicle.mounts), ranges, vehicle.rudder,
                        vehicle.elevator, vehicle.trim, vehicle.thrusters[0].rise_time_constant_s});
    state = placed(vehicle, at_m, 0);
    state.bus_voltage_v = voltage_v;
  }
  void run(const Reference& reference, double time_s) {
    for (double t = 0; t < time_s; t += plan.dt_s) {
      const Effort effort =
          effort_of(autopilot, {state.body.position_m, state.body.attitude, state.body.nu, {}, 0},
                    reference, plan.dt_s, control);
      VehicleCommand<double> command;
      ThrusterSurroundings<double> around;
      around.voltage_v = state.bus_voltage_v;
      around.height_m = 1e3;
      for (std::size_t i = 0; i < vehicle.mounts; ++i) {
        around.advance_m_s = dot(vehicle.mount[i].direction, state.body.nu.linear);
        command.thruster[i] = command_for(vehicle.thrusters[0], effort.thrust_n[i], around);
      }
      command.rudder_rad = effort.rudder_rad;
      command.elevator_rad = effort.elevator_rad;
      command.moving_mass_m = effort.moving_mass_m;
      command.volume_m3 = effort.volume_m3;
      Surroundings<double> surroundings;
      surroundings.height_above_m = 1e3;
      (vehicle.kind == VehicleKind::uav ? surroundings.wind_m_s : surroundings.water.velocity_m_s) =
          fluid_m_s;
      step(vehicle, plan, state, command, surroundings);
    }
  }
};

double away_m(const RealLoop& loop, const Triple<double>& place_m) {
  const Triple<double> d = loop.state.body.position_m - place_m;
  return std::sqrt(dot(d, d));
}

TEST(AutopilotWithRealThrusters, HoldsAnRovInItsPlaceThroughTheDeadBandOfItsThrusters) {
  RealLoop loop("bluerov2_heavy", 16, {0, 0, 20});
  Reference reference;
  reference.position_m = {0, 0, 20};
  loop.run(reference, 120);
  EXPECT_LT(away_m(loop, {0, 0, 20}), 0.02);
  // 2.3 N of buoyancy held down takes under 10 W (twin/docs/vehicles.md).
  EXPECT_LT(loop.state.electrical_w - loop.vehicle.hotel_w, 10);
  EXPECT_GT(loop.state.electrical_w - loop.vehicle.hotel_w, 0.5);
  loop.fluid_m_s = {-0.3, 0.4, 0};
  loop.run(reference, 180);
  EXPECT_LT(away_m(loop, {0, 0, 20}), 0.05);
}

TEST(AutopilotWithRealThrusters, DrivesAnRovAtTheSpeedOfItsDataSheet) {
  RealLoop loop("bluerov2_heavy", 16, {0, 0, 20});
  loop.autopilot.settings.most_speed_m_s = 3;
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m.z = 20;
  for (const double speed : {0.6, 0.8, 1.0, 1.2, 1.4, 3.0}) {  // the last is more than it can
    reference.velocity_m_s.x = speed;
    loop.run(reference, 40);
    EXPECT_NEAR(euler_angles(loop.state.body.attitude).pitch_rad, 0, 0.05) << speed;
    EXPECT_NEAR(loop.state.body.position_m.z, 20, 0.1) << speed;
  }
  EXPECT_NEAR(rotation_of(loop.state.body.attitude).to_ned(loop.state.body.nu.linear).x, 1.5, 0.15);
}

TEST(AutopilotWithRealThrusters, DrivesAnAuvAtTheShaftSpeedOfItsSystemTest) {
  RealLoop loop("lrauv_tethys", 14.4, {0, 0, 20});
  Reference reference;
  reference.target = Target::cruise;
  reference.position_m.z = 25;
  reference.velocity_m_s.x = 1;
  reference.heading = course_of(1);
  loop.run(reference, 400);
  EXPECT_NEAR(loop.state.body.nu.linear.x, 1, 0.02);
  EXPECT_NEAR(loop.state.thruster[0], 31.416 / 1.06,
              1.0);  // 300 turns a minute give 1 m/s within 6 %
  EXPECT_NEAR(loop.state.body.position_m.z, 25, 0.2);
  EXPECT_NEAR(euler_angles(loop.state.body.attitude).yaw_rad, 1, 0.02);
}

TEST(AutopilotWithRealThrusters, KeepsAVesselOnItsCourseAtFullSpeedAndTurnsIt) {
  RealLoop loop("ctv24", 0, {0, 0, 0});
  loop.state.body.position_m.z = floating_depth_m(loop.vehicle.body.hull, loop.vehicle.body.mass_kg,
                                                  loop.vehicle.body.fluid_density_kg_m3);
  Reference reference;
  reference.target = Target::cruise;
  for (const double yaw : {0.0, 1.2}) {
    reference.heading = course_of(yaw);
    reference.velocity_m_s.x = loop.vehicle.cruise_speed_m_s;
    loop.run(reference, 240);
    EXPECT_NEAR(loop.state.body.nu.linear.x, loop.vehicle.cruise_speed_m_s, 0.3) << yaw;
    EXPECT_NEAR(euler_angles(loop.state.body.attitude).yaw_rad, yaw, 0.03) << yaw;
  }
}

TEST(AutopilotWithRealThrusters, HoldsAWamVInACurrentThatItDoesNotKnow) {
  RealLoop loop("wamv16", 25.9, {0, 0, 0});
  loop.fluid_m_s = {0.5, 0, 0};
  loop.run({}, 500);
  EXPECT_LT(std::hypot(loop.state.body.position_m.x, loop.state.body.position_m.y), 0.5);
  EXPECT_NEAR(std::abs(euler_angles(loop.state.body.attitude).yaw_rad), constants::pi, 0.1);
}

TEST(AutopilotWithRealThrusters, HoldsAMultirotorInWindWithTwoHundredWatts) {
  RealLoop loop("x500", 15, {0, 0, -30});
  for (std::size_t i = 0; i < 4; ++i) loop.state.thruster[i] = 769;
  Reference reference;
  reference.position_m = {0, 0, -30};
  loop.run(reference, 30);
  EXPECT_LT(away_m(loop, {0, 0, -30}), 0.01);
  EXPECT_NEAR(loop.state.thruster[0], 769.43, 2);
  EXPECT_NEAR(loop.state.electrical_w - loop.vehicle.hotel_w, 220, 10);
  loop.fluid_m_s = {8, 0, 0};
  loop.run(reference, 60);
  EXPECT_LT(away_m(loop, {0, 0, -30}), 0.2);
}

}  // namespace
}  // namespace slackwater::twin::real_thrusters_test

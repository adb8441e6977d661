#include "twin/step/vehicle_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/vehicle/changed_vehicle.h"
#include "twin/step/step_dispatch.h"

namespace slackwater::twin::vehicle_step_test {
namespace {

using tests::bundled_vehicle;
using State = VehicleState<double>;
using Command = VehicleCommand<double>;
using Around = Surroundings<double>;

void run_for(const Vehicle& vehicle, const StepPlan& plan, State& state, const Command& command,
             const Around& around, double seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / plan.dt_s));
  for (int i = 0; i < steps; ++i) step(vehicle, plan, state, command, around);
}

/// The same while something keeps it level: bodies like these pitch by themselves (Munk's moment).
void run_level_for(const Vehicle& vehicle, const StepPlan& plan, State& state,
                   const Command& command, const Around& around, double seconds) {
  const auto steps = static_cast<int>(std::lround(seconds / plan.dt_s));
  for (int i = 0; i < steps; ++i) {
    step(vehicle, plan, state, command, around);
    state.body.attitude = attitude_of({0, 0, 0});
    state.body.nu.angular = {};
    state.body.nu.linear.z = 0;
  }
}

/// twin/docs/vehicles.md: 1.5 +- 0.15 m/s full ahead at 16 V without a tether.
TEST(VehicleStep, TheBlueRov2ReachesItsSpeed) {
  const Vehicle blue = bundled_vehicle("bluerov2_heavy");
  State state = placed(blue, {0, 0, 20}, 0);
  Command ahead;
  ahead.thruster = {-1, -1, 1, 1};
  run_level_for(blue, plan_step(blue, 0.05, 16), state, ahead, {}, 30);
  EXPECT_NEAR(state.body.nu.linear.x, 1.5, 0.1);
  EXPECT_NEAR(state.body.nu.linear.y, 0, 1e-9);
  // Four thrusters at 16 V: two at 381 W, two at 389 W, and the hotel load.
  EXPECT_NEAR(state.electrical_w, 2 * 381.3 + 2 * 388.8 + 15, 0.1);
}

/// Its pack is made for 60 A, less than four thrusters at full command would take: they get what it
/// gives.
TEST(VehicleStep, TheBlueRov2sBatteryLimitsItsThrusters) {
  const Vehicle blue = bundled_vehicle("bluerov2_heavy");
  State state = placed(blue, {0, 0, 20}, 0);
  Command ahead;
  ahead.thruster = {-1, -1, 1, 1};
  run_level_for(blue, plan_step(blue, 0.05), state, ahead, {}, 20);
  EXPECT_EQ(state.current_a, 60);
  EXPECT_NEAR(state.electrical_w, 60 * state.bus_voltage_v, 1e-6);
  EXPECT_LT(state.bus_voltage_v, 16.72 - 60 * 0.028);
  EXPECT_LT(state.body.nu.linear.x, 1.3);
  EXPECT_GT(state.body.nu.linear.x, 0.8);
}

/// 0.235 kg light: 2.3 N down, under 10 W in total of the thrusters.
TEST(VehicleStep, TheBlueRov2HoldsItsDepthForAFewWatts) {
  const Vehicle blue = bundled_vehicle("bluerov2_heavy");
  State state = placed(blue, {0, 0, 20}, 0);
  const double each_n = 0.235 * constants::gravity_m_s2 / 4;
  Command down;
  for (std::size_t i = 4; i < 8; ++i)
    down.thruster[i] = command_for(blue.thrusters[0], each_n, {0, 0, 16, 0});
  run_for(blue, plan_step(blue, 0.05, 16), state, down, {}, 60);
  EXPECT_NEAR(state.body.nu.linear.z, 0, 2e-3);
  EXPECT_LT(state.electrical_w - blue.hotel_w, 10);
}

/// 300 turns a minute: 6.98 N, 1.0586 m/s, as in the system test of the public model.
TEST(VehicleStep, TheLrauvReachesItsSpeed) {
  const Vehicle lrauv = bundled_vehicle("lrauv_tethys");
  State state = placed(lrauv, {0, 0, 30}, 0);
  Command ahead;
  ahead.thruster[0] = 300 * 2 * constants::pi / 60;
  run_level_for(lrauv, plan_step(lrauv, 0.1), state, ahead, {}, 600);
  EXPECT_NEAR(state.body.nu.linear.x, std::sqrt(6.98 / (6.2282 * 1.0)), 0.002);
  EXPECT_NEAR(state.thrust_n[0], 6.98, 0.01);
}

/// 28.8 W under way at 1 m/s, hence 200 h +- 10 %.
TEST(VehicleStep, TheLrauvLastsTwoHundredHours) {
  const Vehicle lrauv = bundled_vehicle("lrauv_tethys");
  State state = placed(lrauv, {0, 0, 30}, 0);
  Command ahead;
  ahead.thruster[0] = command_for(lrauv.thrusters[0], 6.2282, {1, 0, 14.4, 0});
  run_level_for(lrauv, plan_step(lrauv, 0.1), state, ahead, {}, 600);
  EXPECT_NEAR(state.body.nu.linear.x, 1, 0.002);
  EXPECT_NEAR(state.electrical_w, 28.8, 0.1);
  const BatteryStep minute = battery_step(*lrauv.battery, 60);
  BatteryState<double> battery = rested(*lrauv.battery, 1);
  double hours = 0;
  for (; battery.off < 0.5; hours += 1.0 / 60)
    (void)discharge(*lrauv.battery, minute, battery, state.electrical_w);
  EXPECT_NEAR(hours, 200, 20);
}

/// Hover by a quarter of the weight from each rotor: it stands, takes 220 W and its hotel load, and
/// lasts 18 minutes.
TEST(VehicleStep, TheX500HoversForEighteenMinutes) {
  const Vehicle x500 = bundled_vehicle("x500");
  State state = placed(x500, {0, 0, -50}, 0.5);
  Around air;
  air.height_above_m = 50;
  Command hover;
  const double weight_n = x500.body.mass_kg * constants::gravity_m_s2;
  for (std::size_t i = 0; i < 4; ++i) {
    hover.thruster[i] = command_for(x500.thrusters[0], weight_n / 4, {0, 0, 16, 50});
    state.thruster[i] = hover.thruster[i];
  }
  run_for(x500, plan_step(x500, 0.004), state, hover, air, 5);
  EXPECT_NEAR(state.body.position_m.z, -50, 1e-3);
  EXPECT_NEAR(state.body.nu.angular.z, 0, 1e-9);
  EXPECT_NEAR(state.electrical_w - x500.hotel_w, 220, 2);
  const BatteryStep tick = battery_step(*x500.battery, 0.1);
  BatteryState<double> battery = rested(*x500.battery, 1);
  double minutes = 0;
  for (; battery.off < 0.5; minutes += 0.1 / 60)
    (void)discharge(*x500.battery, tick, battery, state.electrical_w);
  EXPECT_NEAR(minutes, 18, 1.8);
}

/// The rotors that turn clockwise seen from below turn the body clockwise seen from above: to
/// starboard.
TEST(VehicleStep, AMultirotorYawsAgainstItsFasterRotors) {
  const Vehicle x500 = bundled_vehicle("x500");
  State state = placed(x500, {0, 0, -50}, 0);
  Command turn;
  turn.thruster = {800, 800, 730, 730};
  for (std::size_t i = 0; i < 4; ++i) state.thruster[i] = turn.thruster[i];
  Around air;
  air.height_above_m = 50;
  run_for(x500, plan_step(x500, 0.004), state, turn, air, 0.02);
  const double torque_n_m = 2 * 0.016 * 8.54858e-6 * (800.0 * 800 - 730.0 * 730);
  EXPECT_NEAR(state.body.nu.angular.z, torque_n_m / 0.04 * 0.02, 1e-3);
  EXPECT_GT(state.body.nu.angular.z, 0);
}

/// 2.30 m/s at 250 N from each outboard; at 2 m/s 784 W of the water's, 784/0.45 W and 150 W of the
/// bus, 3.7 h of 7 kWh, less what 15 degrees (4 %) and the resistance take.
TEST(VehicleStep, TheWamvReachesItsSpeedAndLastsItsHours) {
  const Vehicle wamv = bundled_vehicle("wamv16");
  const StepPlan plan = plan_step(wamv, 0.05);
  State state = placed(wamv, {0, 0, 0}, 0);
  Command ahead;
  ahead.thruster = {250, 250};
  run_for(wamv, plan, state, ahead, {}, 60);
  EXPECT_NEAR(state.body.nu.linear.x, 2.30, 0.02);
  const double drag_n = 51.3 * 2 + 72.4 * 4;
  ahead.thruster = {drag_n / 2, drag_n / 2};
  run_for(wamv, plan, state, ahead, {}, 60);
  EXPECT_NEAR(state.body.nu.linear.x, 2, 0.02);
  EXPECT_NEAR(state.electrical_w, 784 / 0.45 + 150, 25);
  BatteryState<double> battery = rested(*wamv.battery, 1);
  const BatteryStep second = battery_step(*wamv.battery, 1);
  double hours = 0;
  for (; battery.off < 0.5; hours += 1.0 / 3600)
    (void)discharge(*wamv.battery, second, battery, state.electrical_w);
  EXPECT_NEAR(hours, 3.7, 0.37);
}

/// Held against a landing with 60 kN: 150 l/h of 0.84 kg/l.
TEST(VehicleStep, TheCrewVesselBurnsItsFuelPushingOn) {
  const Vehicle vessel = bundled_vehicle("ctv24");
  const ThrusterSurroundings<double> at_rest;
  const double fuel_kg_s = 2 * run(vessel.thrusters[0], 30000.0, at_rest).fuel_kg_s;
  EXPECT_NEAR(fuel_kg_s * 3600 / 0.84, 150, 1);
  State state = placed(vessel, {0, 0, 0}, 0);
  Command push;
  push.thruster = {30000, 30000};
  Around held;
  held.pull_n.x = -60000;
  run_for(vessel, plan_step(vessel, 0.1), state, push, held, 60);
  EXPECT_NEAR(state.fuel_kg, fuel_kg_s * 60, 0.1 * fuel_kg_s * 60);
  EXPECT_EQ(state.electrical_w, 0);
}

/// Speeds and shaft powers of ctv24's power curve, an estimate: met within 13 %.
TEST(VehicleStep, TheCrewVesselMeetsItsPowerCurve) {
  const Vehicle vessel = bundled_vehicle("ctv24");
  const double knots[] = {10, 15, 20, 24, 26};
  const double shaft_kw[] = {320, 800, 1350, 1850, 2050};
  for (std::size_t i = 0; i < 5; ++i) {
    const double u = knots[i] * 1852 / 3600;
    const double drag_n =
        vessel.body.linear_damping.linear.x * u + vessel.body.quadratic_damping.linear.x * u * u;
    const auto jet = run(vessel.thrusters[0], drag_n / 2, ThrusterSurroundings<double>{u, 0, 0, 0});
    EXPECT_NEAR(jet.thrust_n, drag_n / 2, 0.02 * drag_n / 2) << knots[i];  // 25.8 kn is all
    const double power_kw = 2 * jet.fuel_kg_s / 0.208 * 3600;
    EXPECT_NEAR(power_kw / shaft_kw[i], 1, 0.13) << knots[i];
  }
}

TEST(VehicleStep, AnEmptyBatteryStopsTheThrusters) {
  const Vehicle blue = bundled_vehicle("bluerov2_heavy");
  State state = placed(blue, {0, 0, 20}, 0, 2e-4);
  Command ahead;
  ahead.thruster = {-0.5, -0.5, 0.5, 0.5};
  const StepPlan plan = plan_step(blue, 0.05);
  run_for(blue, plan, state, ahead, {}, 0.5);
  EXPECT_EQ(state.battery.off, 0);
  EXPECT_GT(state.thrust_n[2], 5);
  run_for(blue, plan, state, ahead, {}, 30);
  EXPECT_EQ(state.battery.off, 1);
  EXPECT_EQ(state.thrust_n[2], 0);
  EXPECT_EQ(state.electrical_w, 0);
  EXPECT_NEAR(state.battery.drawn_c, 2e-4 * blue.battery->capacity_c, 1e-6);
  EXPECT_LT(state.body.nu.linear.x, 0.1);
}

TEST(VehicleStep, EachMountHasTheThrusterOfItsKind) {
  // A BlueROV2 with an outboard of a WAM-V in the place of its fifth thruster.
  Vehicle mixed = bundled_vehicle("bluerov2_heavy");
  mixed.thrusters.push_back(bundled_vehicle("wamv16").thrusters[0]);
  mixed.thrusters[1].rise_time_constant_s = 0.7;
  mixed.mount[4].kind = 1;
  EXPECT_EQ(mounts_of_kind(mixed, 0), 7U);
  EXPECT_EQ(mounts_of_kind(mixed, 1), 1U);
  State state = placed(mixed, {0, 0, 20}, 0);
  const StepPlan plan = plan_step(mixed, 0.02, 16);
  Command command;
  command.thruster = {0.5, 0, 0, 0, 30, 0.5, 0, 0};
  const std::array<double, most_mounts> before{0.4, 0, 0, 0, 20, 0.4, 0, 0};
  state.thruster = before;
  step(mixed, plan, state, command, {});
  for (const std::size_t i : {0U, 4U, 5U}) {
    const Thruster& thruster = thruster_of(mixed, i);
    const auto lag =
        lagged(lag_step(thruster.rise_time_constant_s, thruster.fall_time_constant_s, plan.dt_s),
               before[i], command.thruster[i]);
    EXPECT_EQ(state.thruster[i], lag.end) << i;
    EXPECT_EQ(state.thrust_n[i], run(thruster, lag.mean, {0, 0, 16, 0}).thrust_n) << i;
    EXPECT_GT(state.thrust_n[i], 0) << i;
  }
  EXPECT_NE(state.thrust_n[4], state.thrust_n[5]);
}

TEST(VehicleStep, ASteadyWaterCarriesAVehicleThatDoesNothing) {
  const Vehicle lrauv = bundled_vehicle("lrauv_tethys");
  State state = placed(lrauv, {0, 0, 30}, 0);
  Around around;
  around.water.velocity_m_s = {0.3, 0, 0};
  run_for(lrauv, plan_step(lrauv, 0.1), state, {}, around, 3600);
  EXPECT_NEAR(state.body.nu.linear.x, 0.3, 0.03);
}

/// One vehicle and eight, on every instruction set: the same bits.
TEST(VehicleStep, EightVehiclesGiveTheBitsOfOne) {
  std::vector<Vehicle> vehicles{tests::lrauv_of_all_kinds()};
  for (const char* id : {"bluerov2_heavy", "lrauv_tethys", "x500", "wamv16", "ctv24"})
    vehicles.push_back(bundled_vehicle(id));
  for (const Vehicle& vehicle : vehicles) {
    const StepPlan plan = plan_step(vehicle, vehicle.largest_step_s);
    for (const KernelPath path : supported_kernel_paths()) {
      Rng random(21, "tests/eight_vehicles");
      State one[block_lanes];
      VehicleState<Eight> block;
      for (std::size_t k = 0; k < block_lanes; ++k) {
        one[k] = placed(vehicle, {random.uniform(-9, 9), 0, random.uniform(-1, 30)},
                        random.uniform(-3, 3), k == 0 ? 1e-4 : random.uniform(0.05, 1));
        one[k].body.nu.linear = {random.uniform(-1, 1), random.uniform(-1, 1), 0.1};
        put(block, k, one[k]);
      }
      for (int i = 0; i < 300; ++i) {
        VehicleCommand<Eight> commands{};
        Surroundings<Eight> surroundings{};
        for (std::size_t k = 0; k < block_lanes; ++k) {
          Command command;
          for (double& c : command.thruster)
            c = random.uniform(-1, 1) * vehicle.thrusters[0].most_command;
          command.rudder_rad = random.uniform(-1, 1);
          command.elevator_rad = random.uniform(-1, 1);
          command.moving_mass_m = random.uniform(-0.1, 0.1);
          command.volume_m3 = random.uniform(-1e-3, 1e-3);
          Around around;
          around.water = {{random.uniform(-1, 1), 0.2, -0.1},
                          {0.1, random.uniform(-1, 1), 0},
                          {0.01, 0, 0},
                          0.3};
          around.wind_m_s = {random.uniform(-9, 9), 3, 0};
          for (std::size_t j = 0; j < vehicle.body.hull.strips; ++j) {
            around.at_strips.head_m[j] = random.uniform(-0.3, 0.3);
            around.at_strips.velocity_m_s[j] = {random.uniform(-1, 1), 0.1, -0.2};
          }
          around.pull_n = {random.uniform(-9, 9), 0, 2};
          around.height_above_m = random.uniform(0, 3);
          put(commands, k, command);
          put(surroundings, k, around);
          step(vehicle, plan, one[k], command, around);
        }
        step_block_on(path)(vehicle, plan, block, commands, surroundings);
      }
      for (std::size_t k = 0; k < block_lanes; ++k) {
        const State lane = taken(block, k);
        EXPECT_EQ(std::memcmp(&lane, &one[k], sizeof lane), 0)
            << vehicle.id << " " << name_of(path) << " " << k;
        EXPECT_TRUE(std::isfinite(one[k].body.nu.linear.x)) << vehicle.id;
      }
    }
  }
}

/// A propeller that turns clockwise, seen along its thrust, turns its vehicle the other way, by the
/// torque of its shaft, and at J = 0 with rho D^5 n^2 K_Q.
TEST(VehicleStep, TheTorqueOfAPropellerRollsItsVehicleAgainstItsTurn) {
  Vehicle auv = tests::lrauv_of_all_kinds();
  auv.thrusters[0].rise_time_constant_s = 0;
  const StepPlan plan = plan_step(auv, 0.01, 24);
  Command ahead;
  ahead.thruster = {40, 0, 0};
  const double turns_s = 40 / (2 * constants::pi);
  const double torque_n_m = 1025 * std::pow(0.2, 5) * turns_s * turns_s * 0.06;
  for (const double spin : {1.0, -1.0}) {
    auv.mount[0].spin = spin;
    State state = placed(auv, {0, 0, 20}, 0);
    const Propulsion<double> pushed = propel(auv, plan, state, ahead, {}, 0.0);
    EXPECT_NEAR(pushed.force.angular.x, -spin * 0.5 * torque_n_m, 1e-9);
    EXPECT_NEAR(0.8 * pushed.power_w, 40 * torque_n_m, 1e-8);
    step(auv, plan, state, ahead, {});
    EXPECT_LT(spin * state.body.nu.angular.x, 0);
  }
}

/// Where its thrust and its drag are alike, the thrust is what its polynomial says of that speed.
TEST(VehicleStep, APropellerInOpenWaterPushesLessTheFasterItGoes) {
  const Vehicle auv = tests::lrauv_of_all_kinds();
  State state = placed(auv, {0, 0, 20}, 0);
  Command ahead;
  ahead.thruster = {40, 0, 0};
  run_level_for(auv, plan_step(auv, 0.05, 24), state, ahead, {}, 300);
  const double u = state.body.nu.linear.x, turns_s = 40 / (2 * constants::pi);
  const double ratio = 0.94 * u / (turns_s * 0.2);
  const double at_rest_n = 0.9 * 1025 * std::pow(0.2, 4) * turns_s * turns_s * 0.45;
  const double thrust_n = at_rest_n * (0.45 - 0.35 * ratio - 0.05 * ratio * ratio) / 0.45;
  EXPECT_GT(ratio, 0.6);
  EXPECT_NEAR(thrust_n, 6.2282 * u * u, 2e-3 * thrust_n);
  EXPECT_NEAR(state.thrust_n[0], thrust_n, 2e-3 * thrust_n);
}

TEST(VehicleStep, FinsFollowBehindTheirLagWithinTheirRate) {
  Vehicle auv = bundled_vehicle("lrauv_tethys");
  auv.rudder.lag_s = 0.3;
  auv.rudder.rate_rad_s = 10;
  auv.elevator.lag_s = 0.3;
  auv.elevator.rate_rad_s = 0.2;
  const double asked = 0.15;
  Command command;
  command.rudder_rad = command.elevator_rad = asked;
  for (const double dt_s : {0.1, 0.02}) {
    const StepPlan plan = plan_step(auv, dt_s);
    State state = placed(auv, {0, 0, 20}, 0);
    double t_s = 0;
    while (t_s < 0.2 - 1e-9) {
      step(auv, plan, state, command, {});
      t_s += dt_s;
      EXPECT_NEAR(state.rudder_rad, asked * (1 - std::exp(-t_s / 0.3)), 1e-12) << t_s;
    }
    // 0.15/0.3 rad/s is more than its rate.
    EXPECT_NEAR(state.elevator_rad, 0.2 * t_s, 1e-12);
    run_for(auv, plan, state, command, {}, 10);
    EXPECT_NEAR(state.rudder_rad, asked, 1e-9);
    EXPECT_NEAR(state.elevator_rad, asked, 1e-9);
  }
}

TEST(FinsForce, OfTheDriftHasALiftSlopeOfItsOwn) {
  Vehicle auv = bundled_vehicle("lrauv_tethys");
  const Spatial<double> nu_r{{1.2, 0.02, -0.03}, {}};
  const auto force = [&](double passive_share, double rudder_rad, double elevator_rad) {
    auv.rudder.passive_share = auv.elevator.passive_share = passive_share;
    return fins_force(auv, nu_r, rudder_rad, elevator_rad).linear;
  };
  EXPECT_EQ(force(0, 0, 0).y, 0);
  EXPECT_EQ(force(0, 0, 0).z, 0);
  EXPECT_NEAR(force(0.4, 0, 0).y, 0.4 * force(1, 0, 0).y, 1e-12);
  EXPECT_NEAR(force(0.4, 0, 0).z, 0.4 * force(1, 0, 0).z, 1e-12);
  EXPECT_NEAR(force(0.4, 0.05, 0).y - force(0.4, 0, 0).y, force(0, 0.05, 0).y, 1e-12);
  EXPECT_NEAR(force(0.4, 0, 0.05).z - force(0.4, 0, 0).z, force(0, 0, 0.05).z, 1e-12);
}

TEST(FinsForce, OfRudderAndElevatorActsWhereEachStands) {
  Vehicle auv = bundled_vehicle("lrauv_tethys");
  auv.rudder.position_x_m = -0.4;
  auv.rudder.area_m2 = 0.05;
  auv.elevator.lift_slope_per_rad = 2;
  constexpr double u = 1.3, q = -0.02, r = 0.03, rudder_rad = 0.05, elevator_rad = -0.04;
  const Spatial<double> force = fins_force(auv, {{u, 0, 0}, {0, q, r}}, rudder_rad, elevator_rad);
  const auto coefficient = [](const FinPair& fins, double angle_rad, double aside_m_s,
                              double other_m_s) {
    return fins.lift_slope_per_rad *
           (angle_rad +
            aside_m_s / std::sqrt(u * u + aside_m_s * aside_m_s + other_m_s * other_m_s));
  };
  const auto pressure_n = [&](const FinPair& fins, double aside_m_s) {
    return 0.5 * 1025 * fins.area_m2 * (u * u + aside_m_s * aside_m_s);
  };
  const double v = -0.4 * r, x = auv.elevator.position_x_m, w = -x * q;
  const double aside = coefficient(auv.rudder, rudder_rad, v, 0.4 * q);
  const double up = coefficient(auv.elevator, elevator_rad, -w, x * r);
  const double y_n = -pressure_n(auv.rudder, v) * aside;
  const double z_n = pressure_n(auv.elevator, w) * up;
  EXPECT_NEAR(force.linear.y, y_n, 1e-7);
  EXPECT_NEAR(force.linear.z, z_n, 1e-7);
  EXPECT_NEAR(force.angular.y, -x * z_n, 1e-7);
  EXPECT_NEAR(force.angular.z, -0.4 * y_n, 1e-7);
  EXPECT_NEAR(force.linear.x,
              -(pressure_n(auv.rudder, v) * auv.rudder.drag_factor * aside * aside +
                pressure_n(auv.elevator, w) * auv.elevator.drag_factor * up * up),
              1e-7);
}

TEST(FinsForce, IsThatOfTheRudderAloneWhereThereIsNoElevator) {
  Vehicle auv = bundled_vehicle("lrauv_tethys");
  auv.elevator = {};
  EXPECT_TRUE(has_fins(auv));
  const Spatial<double> force = fins_force(auv, {{1, 0.1, 0.2}, {0, 0.1, 0}}, 0.1, 0.1);
  EXPECT_LT(force.linear.y, -0.5);
  EXPECT_EQ(force.linear.z, 0);
  EXPECT_EQ(force.angular.y, 0);
}

TEST(VehicleStep, RefusesAStepLongerThanTheVehicleBears) {
  const Vehicle x500 = bundled_vehicle("x500");
  EXPECT_THROW((void)plan_step(x500, 0.02), ContractViolation);
  EXPECT_THROW((void)plan_step(x500, 0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::twin::vehicle_step_test

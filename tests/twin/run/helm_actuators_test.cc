#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/twin/run/helm_for_tests.h"
#include "twin/run/command_numbers.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::tests::helm_actuators_test {
namespace {

using twin::HelmMode;

const std::string auv_start = "north_m: 0, east_m: 0, depth_m: 20";

twin::SetActuators shares(const twin::Vehicle& vehicle, const std::vector<std::string>& names,
                          const std::vector<double>& values) {
  return {twin::values_by_name(vehicle, names, values), false};
}

/// Renewed each half second.
void drive(twin::Run& run, const twin::CommandWhat& what, double for_s) {
  const int steps = static_cast<int>(std::lround(for_s / helm_step_s));
  for (int i = 0; i < steps; ++i) {
    if (i % 10 == 0) run.enqueue({0, 0, what});
    run.step();
  }
}

std::unique_ptr<twin::Run> lone_auv() { return lone_run(lone("lrauv_tethys", auv_start)); }
const twin::Vehicle& vehicle_of(twin::Run& run) { return *run.agents()[0].vehicle; }

TEST(HelmActuators, TurnTheBowToTheSideOfTheRudder) {
  for (const double side : {-1.0, 1.0}) {
    const auto run = lone_auv();
    drive(*run, shares(vehicle_of(*run), {"thruster_1", "rudder"}, {0.5, 0.5 * side}), 60);
    const twin::VehicleState<double>& v = state_of_lone(*run).vehicle;
    EXPECT_NEAR(v.rudder_rad, 0.5 * side * vehicle_of(*run).rudder.limit_rad, 1e-12);
    EXPECT_GT(side * v.body.nu.angular.z, 0.01);
    EXPECT_EQ(state_of_lone(*run).helm.mode, HelmMode::actuators);
  }
}

TEST(HelmActuators, LiftTheBowWithTheElevator) {
  const auto run = lone_auv();
  drive(*run, shares(vehicle_of(*run), {"thruster_1", "elevator"}, {0.8, 0.5}), 30);
  const auto& attitude = state_of_lone(*run).vehicle.body.attitude;
  EXPECT_GT(twin::euler_angles(attitude).pitch_rad, 0.05);
}

TEST(HelmActuators, OfThrustersAloneAreThrustersByHandToTheBit) {
  const auto by_name = lone_auv(), by_order = lone_auv();
  drive(*by_name, shares(vehicle_of(*by_name), {"thruster_1"}, {0.7}), 10);
  drive(*by_order, twin::SetThrusters{{0.7}}, 10);
  const auto& a = state_of_lone(*by_name).vehicle;
  const auto& b = state_of_lone(*by_order).vehicle;
  EXPECT_GT(a.body.nu.linear.x, 0.1);
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(HelmActuators, InUnitsAreTheSharesOfTheirRangeToTheBit) {
  const auto in_shares = lone_auv(), in_units = lone_auv();
  const twin::Vehicle& auv = vehicle_of(*in_units);
  drive(*in_shares, shares(auv, {"thruster_1", "rudder", "volume"}, {0.5, -0.5, -0.25}), 10);
  twin::SetActuators units;
  units.is_physical = true;
  units.given.give(0, 0.5 * auv.thrusters[0].most_command);
  units.given.give(twin::rudder_channel, -0.5 * auv.rudder.limit_rad);
  units.given.give(twin::volume_channel, 0.25 * auv.trim.least_volume_m3);
  drive(*in_units, units, 10);
  const auto& a = state_of_lone(*in_shares).vehicle;
  const auto& b = state_of_lone(*in_units).vehicle;
  EXPECT_EQ(std::memcmp(&a, &b, sizeof a), 0);
}

TEST(HelmActuators, LeaveBallastAsItIsAndFinsAmidshipsWhereTheyAreNotNamed) {
  const auto run = lone_auv();
  const twin::Vehicle& auv = vehicle_of(*run);
  drive(*run, shares(auv, {"rudder", "moving_mass"}, {1, 0.02}), 30);
  const double mass_m = state_of_lone(*run).vehicle.moving_mass_m;
  EXPECT_NEAR(mass_m, 0.02 * auv.trim.travel_m, 1e-9);
  drive(*run, shares(auv, {"thruster_1"}, {0.1}), 30);
  EXPECT_EQ(state_of_lone(*run).vehicle.moving_mass_m, mass_m);
  EXPECT_EQ(state_of_lone(*run).vehicle.rudder_rad, 0);
}

TEST(HelmActuators, AreOverOnceNobodyRenewsThem) {
  const auto run = lone_auv();
  drive(*run, shares(vehicle_of(*run), {"rudder"}, {1}), 0.5);
  go_on(*run, 0.45);  // a second since the command
  EXPECT_EQ(state_of_lone(*run).helm.mode, HelmMode::actuators);
  go_on(*run, 0.1);
  EXPECT_EQ(state_of_lone(*run).helm.mode, HelmMode::hold);
  EXPECT_EQ(state_of_lone(*run).helm.cause, twin::HelmCause::not_renewed);
}

TEST(HelmActuators, ComeBackFromTheirNumbers) {
  twin::SetActuators set;
  set.is_physical = true;
  set.given.give(3, -0.1);
  set.given.give(twin::volume_channel, 1e-4);
  const twin::CommandWhat what = set;
  const twin::CommandWhat back = twin::what_of("actuators", twin::numbers_of(what));
  ASSERT_TRUE(std::holds_alternative<twin::SetActuators>(back));
  EXPECT_EQ(std::get<twin::SetActuators>(back).given, set.given);
  EXPECT_TRUE(std::get<twin::SetActuators>(back).is_physical);
  std::vector<double> fewer = twin::numbers_of(what);
  fewer.pop_back();
  EXPECT_THROW((void)twin::what_of("actuators", fewer), Error);
}

TEST(HelmActuators, ThatTheVehicleHasNotOrCannotAreABug) {
  const auto run = lone_run(lone("wamv16", "north_m: 0, east_m: 0, depth_m: 0"));
  const auto refused = [&](std::size_t channel, double value, bool is_physical) {
    twin::SetActuators set{{}, is_physical};
    set.given.give(channel, value);
    EXPECT_THROW(run->enqueue({0, 0, set}), ContractViolation) << channel << " " << value;
  };
  refused(twin::rudder_channel, 0.1, false);
  refused(2, 0.1, false);
  refused(0, 1.01, false);
  refused(0, NAN, true);
  refused(0, 1.01 * vehicle_of(*run).thrusters[0].most_command, true);
  EXPECT_THROW(run->enqueue({0, 0, twin::SetActuators{}}), ContractViolation) << "of nothing";
}

}  // namespace
}  // namespace slackwater::tests::helm_actuators_test

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/twin/validation/flight.h"

namespace slackwater::twin::energy_balance_test {
namespace {

using tests::Flight;

/// What the thrusters draw in the surroundings that they end a step in.
double thrusters_w(const Flight& flight) {
  const Vehicle& vehicle = flight.craft();
  const Rotation<double> r = rotation_of(flight.body().attitude);
  const Triple<double> fluid =
      vehicle.kind == VehicleKind::uav ? flight.state().wind_m_s : flight.state().water_m_s;
  const Triple<double> through = flight.body().nu.linear - r.to_body(fluid);
  double sum = 0;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const Mount& mount = vehicle.mount[i];
    const Triple<double> speed = through + cross(flight.body().nu.angular, mount.position_m);
    ThrusterSurroundings<double> around;
    around.advance_m_s = dot(mount.direction, speed);
    const Triple<double> across = speed - around.advance_m_s * mount.direction;
    around.across_m_s = std::sqrt(dot(across, across));
    around.voltage_v = flight.vehicle().bus_voltage_v;
    around.height_m = -flight.body().position_m.z;
    sum += twin::run(thruster_of(vehicle, i), flight.vehicle().thruster[i], around).power_w;
  }
  return sum;
}

struct Balance {
  double thrusters_j = 0;
  double hotel_j = 0;
  double lost_j = 0;    ///< in the resistances of the pack
  double source_j = 0;  ///< open-circuit voltage times current
};

/// A run under way, its powers summed by the trapezoidal rule from what is seen at the steps.
void expect_balance(const char* yaml, double seconds) {
  Flight flight(parse_scenario(yaml, "balance"));
  flight.run(5);
  const Battery& battery = *flight.craft().battery;
  const BatteryState<double> start = flight.vehicle().battery;
  const double dt_s = flight.agent().plan.dt_s;
  const double begin_s = flight.time_s();
  Balance sum;
  double before_w = thrusters_w(flight);
  while (flight.time_s() < begin_s + seconds - 1e-9) {
    const BatteryState<double> was = flight.vehicle().battery;
    flight.step();
    const double after_w = thrusters_w(flight);
    sum.thrusters_j += 0.5 * dt_s * (before_w + after_w);
    sum.hotel_j += dt_s * flight.craft().hotel_w;
    before_w = after_w;
    const double current_a = flight.vehicle().current_a;
    const double v1 = 0.5 * (was.rc_voltage_v + flight.vehicle().battery.rc_voltage_v);
    sum.lost_j += dt_s * current_a * (battery.resistance_ohm * current_a + v1);
    sum.source_j += open_circuit_energy_j(battery, was.charge, flight.vehicle().battery.charge);
  }
  const BatteryState<double>& end = flight.vehicle().battery;
  const double delivered_j = end.delivered_j - start.delivered_j;
  std::printf("%s: %.1f J given, %.1f thrusters + %.1f hotel, source %.1f less %.1f lost\n",
              flight.craft().id.c_str(), delivered_j, sum.thrusters_j, sum.hotel_j, sum.source_j,
              sum.lost_j);
  EXPECT_NEAR(sum.thrusters_j + sum.hotel_j, delivered_j, 1e-3 * delivered_j);
  EXPECT_NEAR(sum.source_j, delivered_j + sum.lost_j, 1e-3 * delivered_j);
  EXPECT_NEAR(end.drawn_c - start.drawn_c, battery.capacity_c * (start.charge - end.charge),
              1e-3 * (end.drawn_c - start.drawn_c));
}

TEST(EnergyBalance, OfAnRovThatSweepsInAShearedCurrent) {
  expect_balance(R"(
name: sweep
seed: 1
duration: 2min
step_s: 0.02
water:
  made_up:
    depth_m: 100
    current: [{depth_m: 0, east_m_s: 0.3, north_m_s: 0.2},
              {depth_m: 50, east_m_s: -0.2, north_m_s: 0}]
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 15, heading_deg: 90}
    tasks: [{do: depth_sweep, from: {north_m: 0, east_m: 0, depth_m: 15}, course_deg: 90,
             length_m: 60, shallow_m: 10, deep_m: 20, wavelength_m: 30}]
)",
                 40);
}

TEST(EnergyBalance, OfAnAuvThatDivesAndTurns) {
  expect_balance(R"(
name: dive
seed: 1
duration: 5min
step_s: 0.1
water: {made_up: {depth_m: 100, current: [{depth_m: 0, east_m_s: 0.2, north_m_s: 0}]}}
vehicles:
  - name: auv
    model: lrauv_tethys
    start: {north_m: 0, east_m: 0, depth_m: 10, heading_deg: 0}
    tasks: [{do: route, waypoints: [{north_m: 60, east_m: 0, depth_m: 15},
                                    {north_m: 60, east_m: 90, depth_m: 20}]}]
)",
                 120);
}

TEST(EnergyBalance, OfAQuadrotorInGusts) {
  expect_balance(R"(
name: fly
seed: 1
duration: 1min
step_s: 0.004
gusts: dryden
water: {made_up: {depth_m: 100, wind: {speed_m_s: 7, from_deg: 250}}}
vehicles:
  - name: uav
    model: x500
    start: {north_m: 0, east_m: 0, height_m: 50, heading_deg: 0}
    tasks: [{do: route, waypoints: [{north_m: 30, east_m: 30, height_m: 60}]}]
)",
                 10);
}

}  // namespace
}  // namespace slackwater::twin::energy_balance_test

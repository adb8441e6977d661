#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/own_autopilot.h"
#include "tests/twin/validation/flight.h"

// The BlueROV2 Heavy against what is published of it and what follows from that:
// twin/docs/vehicles.md.

namespace slackwater::twin::rov_figures_test {
namespace {

using tests::Flight;

const char* const away_at_full_speed = R"(
name: full ahead
seed: 1
duration: 2min
step_s: 0.05
water: {made_up: {depth_m: 100}}
vehicles:
  - name: rov
    model: bluerov2_heavy
    start: {north_m: 0, east_m: 0, depth_m: 20, heading_deg: 0}
    tasks: [{do: route, waypoints: [{north_m: 5000, east_m: 0, depth_m: 20}]}]
)";

/// Straight ahead with all that the thrusters have: the autopilot's bound of nine tenths of the
/// speed, which leaves it something to hold its pitch with, is lifted. For four seconds, thirty
/// times the time in which surge settles (m'/(2 D u) = 0.14 s): the attitude, which the added mass
/// turns over without that reserve, is still level.
Flight full_ahead(double held_voltage_v) {
  Scenario scenario = parse_scenario(away_at_full_speed, "full ahead");
  scenario.vehicles[0].held_voltage_v = held_voltage_v;
  return Flight(scenario, Flight::field_of(scenario), [](ReadyRun& ready) {
    tests::change_autopilot(ready.agents[0],
                            [](AutopilotSettings& own) { own.most_speed_m_s = 1.6; });
    // More than it makes, which no scenario may ask for.
    ready.agents[0].mission.guidance.speed_m_s = 1.6;
  });
}

double surge_drag_n(const Vehicle& vehicle, double speed_m_s) {
  const Body& body = vehicle.body;
  return (body.linear_damping.linear.x + body.quadratic_damping.linear.x * speed_m_s) * speed_m_s;
}

/// Thrust ahead and power of the four horizontal thrusters at full command.
struct AllAhead {
  double thrust_n = 0;
  double power_w = 0;
};
AllAhead all_ahead(const Vehicle& vehicle, double speed_m_s, double voltage_v) {
  AllAhead sum;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const double ahead = vehicle.mount[i].direction.x;
    if (ahead == 0) continue;
    ThrusterSurroundings<double> around;
    around.voltage_v = voltage_v;
    around.advance_m_s = ahead * speed_m_s;
    around.across_m_s = std::abs(vehicle.mount[i].direction.y) * speed_m_s;
    const double command =
        ahead > 0 ? vehicle.thrusters[0].most_command : vehicle.thrusters[0].least_command;
    const auto out = twin::run(vehicle.thrusters[0], command, around);
    sum.thrust_n += ahead * out.thrust_n;
    sum.power_w += out.power_w;
  }
  return sum;
}

/// Where a share of this thrust balances the drag, by bisection.
double steady_speed_m_s(const Vehicle& vehicle, double voltage_v, double most_w) {
  double low = 0, high = 4;
  for (int i = 0; i < 60; ++i) {
    const double speed = 0.5 * (low + high);
    const AllAhead all = all_ahead(vehicle, speed, voltage_v);
    const double share = std::min(1.0, most_w / all.power_w);
    (share * all.thrust_n > surge_drag_n(vehicle, speed) ? low : high) = speed;
  }
  return low;
}

TEST(RovFigures, FullAheadAtSixteenVoltsMakesThePublishedSpeed) {
  Flight flight = full_ahead(16);
  flight.run(4);
  const double speed = flight.velocity_m_s().x;
  std::printf("full ahead at 16 V: %.3f m/s, %.0f W\n", speed, flight.vehicle().electrical_w);
  EXPECT_NEAR(speed, 1.49, 0.05);
  // What keeps it at its depth takes next to nothing: a tilt of 0.01 rad.
  EXPECT_NEAR(speed, steady_speed_m_s(flight.craft(), 16, 1e9), 0.005);
}

TEST(RovFigures, OnItsOwnPackTheCurrentLimitTakesAFifthOfThatSpeed) {
  Flight flight = full_ahead(0);
  flight.run(4);
  const auto& v = flight.vehicle();
  const double speed = flight.velocity_m_s().x;
  std::printf("full ahead on the pack: %.3f m/s, %.1f V, %.1f A, %.0f W\n", speed, v.bus_voltage_v,
              v.current_a, v.electrical_w);
  EXPECT_NEAR(v.current_a, 60, 1e-9);
  // The thrusters have what 60 A leave after the hotel load, and push by that share.
  EXPECT_NEAR(
      speed,
      steady_speed_m_s(flight.craft(), v.bus_voltage_v, v.electrical_w - flight.craft().hotel_w),
      0.01);
  EXPECT_LT(speed, 1.35);
}

Flight held_on_a_tether(double depth_m, double length_m) {
  char yaml[700];
  std::snprintf(yaml, sizeof yaml, R"(
name: held
seed: 1
duration: 5min
step_s: 0.05
water: {made_up: {depth_m: 100, current: [{depth_m: 0, east_m_s: 0, north_m_s: -0.5}]}}
vehicles:
  - name: rov
    model: bluerov2_heavy
    hold_bus_v: 16
    start: {north_m: 0, east_m: 0, depth_m: %g, heading_deg: 0}
    tether: {top: {north_m: 0, east_m: 0, depth_m: 0}, length_m: %g}
)",
                depth_m, length_m);
  return Flight(parse_scenario(yaml, "held"));
}

/// Against the current, NED north.
double mean_push_n(Flight& flight, double seconds) {
  double sum = 0;
  int count = 0;
  for (const double end_s = flight.time_s() + seconds; flight.time_s() < end_s; ++count) {
    flight.step();
    sum += rotation_of(flight.body().attitude).to_ned(flight.thrust_n()).x;
  }
  return sum / count;
}

TEST(RovFigures, HoldingHalfAMetreASecondOnATautTetherTakesHalfItsDragAndThatOfTheHull) {
  // 1.2/2 rho 7.6 mm 50 m (0.5 m/s)^2, half of it at either end, and 13.6 N of hull: 42.8 N.
  Flight taut = held_on_a_tether(50, 50);
  taut.run(60);
  const double push = mean_push_n(taut, 20);
  std::printf("holding 0.5 m/s on 50 m: %.2f N, tension %.1f N\n", push, taut.state().tether_n);
  EXPECT_NEAR(push, 42.8, 0.02 * 42.8);
  EXPECT_LT(std::abs(taut.body().position_m.x), 0.5);
}

// Along the line the flow has less to hold on to: of each metre between the ends it takes cos^2 of
// the slope, in the mean 0.83 for a bow that is a tenth longer than its chord (an arc of half-angle
// 0.75 rad: 1/2 + sin(2a)/(4a)).
TEST(RovFigures, ATetherWithATenthOfSlackBowsAndPullsLess) {
  Flight slack = held_on_a_tether(50, 55);
  slack.run(60);
  const double push = mean_push_n(slack, 20);
  std::printf("holding 0.5 m/s on 55 m at 50 m: %.2f N, tension %.1f N\n", push,
              slack.state().tether_n);
  const double straight_n = 42.8 - surge_drag_n(slack.craft(), 0.5);
  const double bowed = 0.5 + std::sin(1.5) / 3;
  EXPECT_NEAR(push, surge_drag_n(slack.craft(), 0.5) + bowed * straight_n, 0.05 * push);
}

TEST(RovFigures, HoveringAgainstItsBuoyancyTakesLessThanTenWatts) {
  Flight hover(R"(
name: hover
seed: 1
duration: 1min
step_s: 0.05
water: {made_up: {depth_m: 100}}
vehicles:
  - {name: rov, model: bluerov2_heavy, hold_bus_v: 16, start: {north_m: 0, east_m: 0, depth_m: 20}}
)");
  hover.run(40);
  double sum_w = 0, down_n = 0;
  constexpr int steps = 400;
  for (int i = 0; i < steps; ++i) {
    hover.step();
    sum_w += (hover.vehicle().electrical_w - hover.craft().hotel_w) / steps;
    down_n += hover.thrust_n().z / steps;
  }
  std::printf("hover: %.2f N down, %.2f W in the thrusters\n", down_n, sum_w);
  const Body& body = hover.craft().body;
  EXPECT_NEAR(down_n,
              constants::gravity_m_s2 *
                  (body.fluid_density_kg_m3 * body.displaced_volume_m3 - body.mass_kg),
              0.02);
  EXPECT_LT(sum_w, 10);
  EXPECT_GT(sum_w, 0);
}

}  // namespace
}  // namespace slackwater::twin::rov_figures_test

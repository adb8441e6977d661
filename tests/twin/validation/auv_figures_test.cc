#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/support/own_autopilot.h"
#include "tests/twin/validation/flight.h"
#include "twin/battery/battery_step.h"

// The Tethys LRAUV against what is published of it and what follows from that:
// twin/docs/vehicles.md.

namespace slackwater::twin::auv_figures_test {
namespace {

using tests::Flight;

/// Ahead at a speed in still water.
Scenario straight_ahead(double speed_m_s) {
  Scenario scenario = parse_scenario(R"(
name: straight ahead
seed: 1
duration: 10min
step_s: 0.1
water: {made_up: {depth_m: 100}}
vehicles:
  - name: auv
    model: lrauv_tethys
    start: {north_m: 0, east_m: 0, depth_m: 20, heading_deg: 0}
    tasks: [{do: route, waypoints: [{north_m: 9000, east_m: 0, depth_m: 20}]}]
)",
                                     "straight ahead");
  scenario.vehicles[0].speed_m_s = speed_m_s;
  return scenario;
}

TEST(AuvFigures, ThreeHundredTurnsAMinuteMakeTheSpeedOfItsCoefficients) {
  // Kt rho D^4 w^2 = 6.98 N against 6.2282 u^2: 1.059 m/s; the model's system test has 1 m/s within
  // 6 %.
  const Scenario scenario = straight_ahead(1.0);
  Flight flight(scenario, Flight::field_of(scenario), [](ReadyRun& ready) {
    tests::change_autopilot(ready.agents[0],
                            [](AutopilotSettings& own) { own.most_speed_m_s = 1.2; });
    ready.agents[0].mission.guidance.speed_m_s = 1.2;
  });
  flight.run(240);
  const double turns = flight.vehicle().thruster[0] * 60 / (2 * constants::pi);
  const double speed = flight.velocity_m_s().x;
  std::printf("%.1f turns a minute: %.4f m/s\n", turns, speed);
  EXPECT_NEAR(turns, 300, 0.3);
  EXPECT_NEAR(speed, 1.059, 0.005);
}

TEST(AuvFigures, AMetreASecondTakesThePublishedPowerAndLastsTwoHundredHours) {
  Flight flight(straight_ahead(1.0));
  flight.run(300);
  const double speed = flight.velocity_m_s().x;
  const double power = flight.vehicle().electrical_w;
  EXPECT_NEAR(speed, 1.0, 0.001);
  EXPECT_NEAR(power, 28.8, 1);
  // Power does not depend on the voltage of the bus, so that the whole discharge is that of this
  // load.
  const Battery& battery = *flight.craft().battery;
  const BatteryStep minute = battery_step(battery, 60);
  BatteryState<double> state = rested(battery, 1);
  double hours = 0;
  while (state.off < 0.5 && hours < 1000) {
    (void)discharge(battery, minute, state, power);
    hours += 1 / 60.0;
  }
  std::printf("%.4f m/s: %.2f W, %.1f h, %.0f km\n", speed, power, hours, 3.6 * hours * speed);
  EXPECT_GT(hours, 195);
  EXPECT_LT(hours, 210);
  // 62 sticks of 14.4 V and 6.27 Ah: 5.6 kWh. What was given is within the source's own energy.
  EXPECT_LT(state.delivered_j, open_circuit_energy_j(battery, 1, 0));
}

TEST(AuvFigures, HalfAMetreASecondTakesAQuarterOfTheThrust) {
  Flight flight(straight_ahead(0.5));
  flight.run(300);
  // 6.2282 N s2/m2: 1.56 N.
  std::printf("0.5 m/s: %.4f m/s, %.3f N\n", flight.velocity_m_s().x, flight.thrust_n().x);
  EXPECT_NEAR(flight.velocity_m_s().x, 0.5, 0.001);
  EXPECT_NEAR(flight.thrust_n().x, 1.56, 0.02);
}

}  // namespace
}  // namespace slackwater::twin::auv_figures_test

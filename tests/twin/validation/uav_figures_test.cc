#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/twin/validation/flight.h"
#include "twin/battery/battery_step.h"

// The X500 against what is published of it and what follows from that: twin/docs/vehicles.md.

namespace slackwater::twin::uav_figures_test {
namespace {

using tests::Flight;

Scenario in_calm_air(double height_m, double state_of_charge) {
  Scenario scenario = parse_scenario(R"(
name: calm
seed: 1
duration: 1min
step_s: 0.004
water: {made_up: {depth_m: 100}}
vehicles:
  - {name: uav, model: x500, start: {north_m: 0, east_m: 0, height_m: 30}}
)",
                                     "calm");
  scenario.vehicles[0].start_m.z = -height_m;
  scenario.vehicles[0].state_of_charge = state_of_charge;
  return scenario;
}

TEST(UavFigures, HoversAtThePublishedTurnsForThePublishedTime) {
  Flight flight(in_calm_air(50, 1));
  flight.run(8);
  const double power = flight.vehicle().electrical_w;
  double mean_rad_s = 0;
  for (std::size_t i = 0; i < flight.craft().mounts; ++i)
    mean_rad_s += flight.vehicle().thruster[i] / static_cast<double>(flight.craft().mounts);
  EXPECT_NEAR(mean_rad_s, 769, 1);
  EXPECT_LT(std::abs(flight.velocity_m_s().z), 0.01);
  // The power of a thrust does not depend on the voltage; the whole discharge is that of this load.
  // Hotel load and all, to the cut-off at 3.3 V a cell.
  const Battery& battery = *flight.craft().battery;
  const BatteryStep second = battery_step(battery, 1);
  BatteryState<double> state = rested(battery, 1);
  double minutes = 0;
  while (state.off < 0.5 && minutes < 100) {
    (void)discharge(battery, second, state, power);
    minutes += 1 / 60.0;
  }
  std::printf(
      "hover: %.1f rad/s, %.1f W of which %.0f hotel, %.1f min, usable %.3f of the charge\n",
      mean_rad_s, power, flight.craft().hotel_w, minutes, 1 - state.charge);
  EXPECT_GT(minutes, 16);
  EXPECT_LT(minutes, 20);
}

/// m v' = m g - d v^2 from rest: v = v_t tanh(g t/v_t), v_t = sqrt(m g/d).
TEST(UavFigures, WithAnEmptyBatteryFallsAsTheClosedFormSays) {
  Flight flight(in_calm_air(290, 0));
  const Body& body = flight.craft().body;
  const double terminal =
      std::sqrt(body.mass_kg * constants::gravity_m_s2 / body.quadratic_damping.linear.z);
  for (const double t : {1.0, 3.0, 9.0}) {
    flight.run(t - flight.time_s());
    EXPECT_NEAR(flight.velocity_m_s().z,
                terminal * std::tanh(constants::gravity_m_s2 * t / terminal), 0.002)
        << t << " s";
  }
  std::printf("falls at %.2f of %.2f m/s\n", flight.velocity_m_s().z, terminal);
}

}  // namespace
}  // namespace slackwater::twin::uav_figures_test

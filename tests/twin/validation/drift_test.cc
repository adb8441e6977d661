#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/twin/validation/flight.h"

// Vehicles whose battery is empty: where the water takes them, by the closed forms of a body with
// drag.

namespace slackwater::twin::drift_test {
namespace {

using tests::Flight;

Scenario dead_in_a_current(const char* model, double speed_m_s) {
  char yaml[600];
  std::snprintf(yaml, sizeof yaml, R"(
name: dead
seed: 1
duration: 5min
step_s: 0.02
water: {made_up: {depth_m: 100, current: [{depth_m: 0, east_m_s: 0, north_m_s: %g}]}}
vehicles:
  - name: dead
    model: %s
    state_of_charge: 0
    start: {north_m: 0, east_m: 0, depth_m: 50, heading_deg: 0}
)",
                speed_m_s, model);
  return parse_scenario(yaml, "dead");
}

/// m' v_r' = -d v_r |v_r|: v_r = v_0/(1 + v_0 d t/m'), behind the water by ln(1 + v_0 d t/m') m'/d.
TEST(Drift, AnAuvWithoutPowerIsCarriedOffAsTheClosedFormOfQuadraticDragSays) {
  constexpr double current = 0.5;
  const Scenario scenario = dead_in_a_current("lrauv_tethys", current);
  Flight flight(scenario, Flight::field_of(scenario),
                [](ReadyRun& ready) { ready.states[0].vehicle.battery.off = 1; });
  const Body& body = flight.craft().body;
  const double mass = body.mass_kg + body.added_mass.entry[0][0];
  // The fins' own drag is that of their lift: none, straight on.
  const double drag = body.quadratic_damping.linear.x;
  for (const double t : {5.0, 30.0, 120.0, 240.0}) {
    flight.run(t - flight.time_s());
    const double grown = 1 + current * drag * t / mass;
    EXPECT_NEAR(flight.velocity_m_s().x, current - current / grown, 1e-4) << t << " s";
    const double way = current * t - std::log(grown) * mass / drag;
    // Its volume is known to a gramme: it sinks a little, and so gathers a little more of the flow.
    EXPECT_NEAR(flight.body().position_m.x, way, 1e-3 + 1e-4 * way) << t << " s";
  }
  EXPECT_EQ(flight.vehicle().battery.off, 1);
}

/// m' v' = B - a v - b v^2 from rest, with k = sqrt(a^2 + 4 b B):
/// v = 2 B tanh(k t/2m')/(k + a tanh(k t/2m')), which ends where drag balances the buoyancy.
TEST(Drift, AnRovWithoutPowerRisesAsTheClosedFormOfBothDragsSays) {
  Flight flight(dead_in_a_current("bluerov2_heavy", 0));
  const Body& body = flight.craft().body;
  const double lift = constants::gravity_m_s2 *
                      (body.fluid_density_kg_m3 * body.displaced_volume_m3 - body.mass_kg);
  const double mass = body.mass_kg + body.added_mass.entry[2][2];
  const double a = body.linear_damping.linear.z, b = body.quadratic_damping.linear.z;
  const double k = std::sqrt(a * a + 4 * b * lift);
  for (const double t : {1.0, 3.0, 10.0, 60.0}) {
    flight.run(t - flight.time_s());
    const double grown = std::tanh(0.5 * k * t / mass);
    EXPECT_NEAR(-flight.velocity_m_s().z, 2 * lift * grown / (k + a * grown), 1e-4) << t << " s";
  }
  std::printf("rises at %.4f m/s\n", -flight.velocity_m_s().z);
}

}  // namespace
}  // namespace slackwater::twin::drift_test

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"
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

/// A WAM-V without power, beam on to a wind of 10 m/s at 10 m, by a file of its own.
double drift_m_s(const std::string& model) {
  char yaml[600];
  std::snprintf(yaml, sizeof yaml, R"(
name: blown
seed: 1
duration: 5min
step_s: 0.05
water: {made_up: {depth_m: 50, wind: {speed_m_s: 10, from_deg: 270}}}
vehicles:
  - {name: it, model: %s, start: {north_m: 0, east_m: 0, depth_m: 0, heading_deg: 0}}
)",
                model.c_str());
  const Scenario scenario = parse_scenario(yaml, "blown");
  Flight flight(scenario, Flight::field_of(scenario),
                [](ReadyRun& ready) { ready.states[0].vehicle.battery.off = 1; });
  flight.run(120);
  EXPECT_EQ(flight.vehicle().battery.off, 1);
  return flight.velocity_m_s().y;
}

/// c (U - v)^2 = a v + b v^2 of the file's own numbers, with U by the logarithmic profile at the
/// height that the file states for c.
TEST(Drift, ACraftWithoutPowerIsBlownOffAsTheBalanceOfWindAndWaterSays) {
  EXPECT_NEAR(drift_m_s("wamv16"), 0.346, 0.001);
  const std::filesystem::path data = tests::source_folder() / "data";
  std::ifstream in(data / "vehicles" / "wamv16.yaml");
  const std::string shipped(std::istreambuf_iterator<char>(in), {});
  const tests::TemporaryFolder folder;
  for (const double height_m : {1.0, 3.0, 10.0, 25.0}) {
    std::string file = shipped;
    const std::string stated = "wind_height_m: 10";
    const std::size_t at = file.find(stated);
    ASSERT_NE(at, std::string::npos);
    file.replace(at, stated.size(), "wind_height_m: " + std::to_string(height_m));
    std::ofstream(folder / "craft.yaml") << file;
    constexpr double roughness_m = 0.0002;
    const double wind = 10 * std::log(height_m / roughness_m) / std::log(10 / roughness_m);
    constexpr double a = 100, b = 100, c = 0.5;
    const double half = 0.5 * (a + 2 * c * wind);
    const double v = (-half + std::sqrt(half * half + (b - c) * c * wind * wind)) / (b - c);
    EXPECT_NEAR(drift_m_s((folder / "craft.yaml").string()), v, 1e-3 * v) << height_m << " m";
  }
}

}  // namespace
}  // namespace slackwater::twin::drift_test

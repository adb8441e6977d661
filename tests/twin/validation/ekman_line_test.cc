#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "fields/current/coriolis.h"
#include "fields/current/ekman_layer.h"
#include "tests/support/own_autopilot.h"
#include "tests/twin/validation/flight.h"
#include "twin/step/vehicle_step.h"

// An AUV on a straight line through a wind-driven column: what the current does to it where it
// holds its heading, and what it does about it where it follows the line.
// SLACKWATER_EKMAN_LINE_CSV=FILE writes the table.

namespace slackwater::twin::ekman_line_test {
namespace {

using tests::Flight;
constexpr std::array depths_m{4.0, 10.0, 20.0, 40.0};
constexpr double speed_m_s = 1.0;

/// 0.3 Pa to the north-east (some 12 m/s of wind) and 0.02 m2/s of eddy viscosity at 55 N: 0.19 m/s
/// at the surface, a scale of 18 m.
Horizontal ekman_m_s(double depth_m) {
  const double f = coriolis_parameter_rad_s(Angle::from_degrees(55));
  return surface_ekman_velocity(std::polar(0.3, 0.25 * constants::pi), 0.02, f,
                                constants::sea_water_density_kg_m3, depth_m);
}

std::shared_ptr<const Field> column(const Scenario& scenario, double share) {
  std::vector<double> levels_m;
  std::vector<Horizontal> current;
  for (int stamp = 0; stamp < 2; ++stamp) {
    for (double depth = 0; depth <= 80; depth += 1) {
      if (stamp == 0) levels_m.push_back(depth);
      current.push_back(share * ekman_m_s(depth));
    }
  }
  return made_up_field({Flight::epoch(), Flight::epoch() + std::chrono::hours(1)}, levels_m,
                       current, {}, scenario.origin, 100);
}

Scenario eastward(double depth_m) {
  Scenario scenario = parse_scenario(R"(
name: line
seed: 1
duration: 20min
step_s: 0.1
water: {made_up: {depth_m: 100}}
vehicles:
  - name: auv
    model: lrauv_tethys
    start: {north_m: 0, east_m: 0, depth_m: 20, heading_deg: 90}
    tasks: [{do: route, waypoints: [{north_m: 0, east_m: 5000, depth_m: 20, speed_m_s: 1}]}]
)",
                                     "line");
  scenario.vehicles[0].start_m.z = depth_m;
  scenario.vehicles[0].tasks[0].waypoints[0].position_m.z = depth_m;
  return scenario;
}

/// With a log of its speed through the water: else it keeps its speed over ground.
void knows_the_water(ReadyRun& ready) {
  for (Agent& agent : ready.agents)
    tests::change_autopilot(agent, [](AutopilotSettings& own) { own.current_feed_forward = true; });
}

/// The vehicle under its autopilot as it holds a heading of east: a reference that no mission
/// gives.
Triple<double> drift_m_s(const Flight& flight, const EnvironmentSampler& water) {
  const Agent& agent = flight.agent();
  const Vehicle& vehicle = *agent.vehicle;
  AgentState state = flight.state();
  Reference east;
  east.target = Target::cruise;
  east.velocity_m_s = {speed_m_s, 0, 0};
  east.position_m.z = state.vehicle.body.position_m.z;
  east.heading = course_of(0.5 * constants::pi);
  const auto steps = static_cast<int>(std::lround(400 / agent.plan.dt_s));
  Triple<double> from;
  for (int i = 0; i <= steps; ++i) {
    const BodyState<double>& body = state.vehicle.body;
    if (i == steps - 500) from = body.position_m;
    Surroundings<double> around;
    around.water = water.current(body.position_m, vehicle.body.height_m, 0).motion;
    const Measured measured{body.position_m, body.attitude, body.nu, around.water.velocity_m_s};
    const Effort effort =
        effort_of(*agent.autopilot, measured, east, agent.plan.dt_s, state.control);
    VehicleCommand<double> command;
    ThrusterSurroundings<double> meets;
    meets.voltage_v = state.vehicle.bus_voltage_v;
    meets.advance_m_s = body.nu.linear.x - around.water.velocity_m_s.y;
    command.thruster[0] = command_for(vehicle.thrusters[0], effort.thrust_n[0], meets);
    command.rudder_rad = effort.rudder_rad;
    command.elevator_rad = effort.elevator_rad;
    command.moving_mass_m = effort.moving_mass_m;
    command.volume_m3 = effort.volume_m3;
    step(vehicle, agent.plan, state.vehicle, command, around);
  }
  return (1 / (500 * agent.plan.dt_s)) * (state.vehicle.body.position_m - from);
}

/// Means over the last stretch of a line that is followed.
struct OnLine {
  double crab_rad = 0;  ///< of the bow, to the right of the line
  double off_line_m = 0;
  double over_ground_m_s = 0;
  double thruster_j_m = 0;  ///< per metre of the line
};
OnLine followed(Flight& flight) {
  flight.run(300);
  const double from_m = flight.body().position_m.y, from_s = flight.time_s();
  OnLine line;
  double energy_j = 0;
  constexpr int steps = 1000;
  for (int i = 0; i < steps; ++i) {
    flight.step();
    line.crab_rad += (euler_angles(flight.body().attitude).yaw_rad - 0.5 * constants::pi) / steps;
    line.off_line_m = std::max(line.off_line_m, std::abs(flight.body().position_m.x));
    energy_j += flight.agent().plan.dt_s * (flight.vehicle().electrical_w - flight.craft().hotel_w);
  }
  const double way_m = flight.body().position_m.y - from_m;
  line.over_ground_m_s = way_m / (flight.time_s() - from_s);
  line.thruster_j_m = energy_j / way_m;
  return line;
}

TEST(EkmanLine, AHeldHeadingDriftsWithTheCrossCurrentAndAFollowedLineCrabs) {
  const char* const csv_path = std::getenv("SLACKWATER_EKMAN_LINE_CSV");
  std::ofstream csv;
  if (csv_path != nullptr) csv.open(csv_path);
  const char* const header =
      "depth_m,eastward_m_s,northward_m_s,drift_north_m_s,crab_deg,asin_deg,off_line_m,"
      "over_ground_m_s,thruster_j_per_m,of_still_water\n";
  std::printf("%s", header);
  csv << header;
  const Scenario still_scenario = eastward(20);
  Flight still(still_scenario, column(still_scenario, 0), knows_the_water);
  const OnLine in_still = followed(still);
  for (const double depth : depths_m) {
    const Scenario scenario = eastward(depth);
    Flight flight(scenario, column(scenario, 1), knows_the_water);
    const Horizontal current = ekman_m_s(depth);
    const Triple<double> drift = drift_m_s(flight, *flight.agent().water);
    const OnLine line = followed(flight);
    const double lead = std::asin(current.imag() / speed_m_s);
    char row[300];
    std::snprintf(row, sizeof row, "%g,%.4f,%.4f,%.4f,%.3f,%.3f,%.3f,%.4f,%.3f,%.4f\n", depth,
                  current.real(), current.imag(), drift.x, line.crab_rad * 180 / constants::pi,
                  lead * 180 / constants::pi, line.off_line_m, line.over_ground_m_s,
                  line.thruster_j_m, line.thruster_j_m / in_still.thruster_j_m);
    std::printf("%s", row);
    csv << row;
    // Both within what the hull's height of 0.3 m and levels of 1 m make of the profile.
    EXPECT_NEAR(drift.x, current.imag(), 0.002) << depth << " m";
    EXPECT_NEAR(drift.y, speed_m_s + current.real(), 0.005) << depth << " m";
    EXPECT_NEAR(line.crab_rad, lead, 0.005) << depth << " m";
    EXPECT_LT(line.off_line_m, 0.5) << depth << " m";
    // The same thrust through the water for another way over ground.
    const double expected = std::sqrt(1 - current.imag() * current.imag()) + current.real();
    EXPECT_NEAR(line.over_ground_m_s, expected, 0.005) << depth << " m";
    EXPECT_NEAR(line.thruster_j_m * expected, in_still.thruster_j_m, 0.01 * in_still.thruster_j_m)
        << depth << " m";
  }
}

}  // namespace
}  // namespace slackwater::twin::ekman_line_test

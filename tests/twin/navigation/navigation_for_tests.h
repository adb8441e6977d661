#pragma once
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests {

/// Instruments of the kinds that a vehicle has, without any error.
inline twin::Sensors perfect(twin::Sensors sensors) {
  if (sensors.gnss) {
    twin::Gnss& g = *sensors.gnss;
    g.white_horizontal_sd_m = g.white_vertical_sd_m = g.velocity_sd_m_s = 0;
    g.slow_horizontal_m.sd = g.slow_vertical_m.sd = 0;
  }
  if (sensors.imu) {
    for (twin::InertialNoise* n : {&sensors.imu->gyro, &sensors.imu->accelerometer})
      n->white_density = n->walk_density = n->start_bias_sd = 0;
  }
  if (sensors.depth) {
    sensors.depth->scale = 1;
    sensors.depth->noise_sd_m = sensors.depth->resolution_m = 0;
  }
  if (sensors.compass) {
    const double rate_hz = sensors.compass->rate_hz;
    sensors.compass = twin::Compass{};
    twin::Compass& c = *sensors.compass;
    c.constant_rad = c.sine_rad = c.cosine_rad = c.double_sine_rad = c.double_cosine_rad = 0;
    c.noise_sd_rad = 0;
    c.rate_hz = rate_hz;
  }
  if (sensors.dvl) {
    sensors.dvl->scale = 1;
    sensors.dvl->noise_sd_m_s = 0;
    // The water that it is in, not that of a layer below, which shear makes another.
    sensors.dvl->layer_near_m = sensors.dvl->layer_far_m = 0;
  }
  return sensors;
}

/// A scenario made ready with every vehicle's instruments changed.
inline twin::ReadyRun ready_with(const std::string& yaml,
                                 const std::function<void(twin::Sensors&)>& change,
                                 std::uint64_t seed = 7) {
  twin::Scenario scenario = twin::parse_scenario(yaml, "test.yaml");
  scenario.seed = seed;
  twin::ReadyRun ready = twin::set_up(scenario, surround_of(scenario));
  for (std::size_t i = 0; i < ready.agents.size(); ++i) {
    auto vehicle = std::make_shared<twin::Vehicle>(*ready.agents[i].vehicle);
    change(vehicle->sensors);
    twin::Agent agent =
        twin::make_agent(vehicle, ready.agents[i].water, scenario.vehicles[i], scenario.step_s);
    agent.gusts = ready.agents[i].gusts;
    ready.agents[i] = agent;
    ready.states[i] = twin::first_state(agent, scenario.vehicles[i], seed);
  }
  return ready;
}

/// How far a vehicle takes itself to be from where it is, m, in the plane.
inline double lost_m(const twin::AgentState& state) {
  return std::hypot(state.navigation.error_m.x, state.navigation.error_m.y);
}

}  // namespace slackwater::tests

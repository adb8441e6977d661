#pragma once
#include <memory>

#include "api/door/dds/message/vehicle_messages.h"

namespace slackwater::tests {

/// A vehicle with numbers that single precision has too. It stands at (3, 4, 5) m NED with its head
/// to the east, rolls, and goes by the truth.
struct VehicleForTests {
  twin::Agent agent;
  twin::AgentState state;
  dds::Stamp stamp{1'717'300'000, 250'000'000};
  std::string name = "rov";

  VehicleForTests() {
    auto vehicle = std::make_shared<twin::Vehicle>();
    vehicle->battery.emplace();
    vehicle->battery->capacity_c = 3600 * 16;  // 16 Ah
    vehicle->sensors.imu.emplace();
    vehicle->sensors.imu->gyro = {0.25, 0, 0.5, 10};
    vehicle->sensors.imu->accelerometer = {0.5, 0, 1, 100};
    vehicle->sensors.dvl.emplace();
    vehicle->sensors.dvl->noise_sd_m_s = 0.25;
    agent.name = name;
    agent.navigation.emplace();
    agent.navigation->steers = false;
    agent.navigation->instruments.sensors = vehicle->sensors;
    agent.navigation->instruments.dt_s = 0.25;
    agent.vehicle = std::move(vehicle);

    twin::BodyState<double>& body = state.vehicle.body;
    body.position_m = {3, 4, 5};
    body.attitude = {0.5, 0.5, 0.5, 0.5};
    body.nu.linear = {1.5, 0.25, -0.5};
    body.nu.angular = {0.125, 0.5, -0.25};
    state.vehicle.battery.charge = 0.75;
    state.vehicle.bus_voltage_v = 15.5;
    state.vehicle.current_a = 8.25;
    state.navigation.navigator.position_m = {30, 40, 50};
    state.navigation.navigator.attitude = {1, 0, 0, 0};
  }
};

}  // namespace slackwater::tests

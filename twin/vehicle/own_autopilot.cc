#include "twin/vehicle/own_autopilot.h"

#include <algorithm>
#include <span>
#include <vector>

#include "twin/vehicle/balance.h"

namespace slackwater::twin {
namespace {

/// Of the slowest of its thrusters.
double longest_rise_s(const Vehicle& vehicle) {
  double longest_s = 0;
  for (const Thruster& thruster : vehicle.thrusters)
    longest_s = std::max(longest_s, thruster.rise_time_constant_s);
  return longest_s;
}

/// What a thruster gives at rest on a bus of this voltage.
ThrustRange range_of(const Thruster& thruster, double voltage_v) {
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  around.height_m = 1e3;
  const auto most = run(thruster, thruster.most_command, around);
  const auto least = run(thruster, thruster.least_command, around);
  return {std::min(least.thrust_n, 0.0), most.thrust_n,
          most.thrust_n > 0 ? most.torque_n_m / most.thrust_n : 0};
}

}  // namespace

double usual_voltage_v(const Vehicle& vehicle) noexcept {
  if (vehicle.battery) return rest_voltage_v(*vehicle.battery, rested(*vehicle.battery, 0.5));
  double voltage_v = 0;
  for (const Thruster& thruster : vehicle.thrusters) {
    if (thruster.kind == ThrusterKind::table) {
      const UniformAxis& axis = thruster.table.voltage_v;
      voltage_v = std::max(voltage_v, axis.at(axis.count - 1));
    } else {
      voltage_v = std::max({voltage_v, thruster.propeller.full_speed_voltage_v,
                            thruster.rotor.full_speed_voltage_v});
    }
  }
  return voltage_v;
}

Autopilot own_autopilot(const Vehicle& vehicle, const AutopilotSettings& settings,
                        double voltage_v) {
  std::vector<ThrustRange> ranges;
  for (std::size_t i = 0; i < vehicle.mounts; ++i)
    ranges.push_back(range_of(thruster_of(vehicle, i), voltage_v));
  Autopilot autopilot =
      plan_autopilot(settings, vehicle.kind, vehicle.body,
                     {std::span(vehicle.mount).first(vehicle.mounts), ranges, vehicle.rudder,
                      vehicle.elevator, vehicle.trim, longest_rise_s(vehicle)});
  expect_strength(vehicle, autopilot);
  return autopilot;
}

}  // namespace slackwater::twin

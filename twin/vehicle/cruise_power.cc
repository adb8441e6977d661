#include "twin/vehicle/cruise_power.h"

#include <cmath>

#include "fields/base/constants.h"
#include "twin/vehicle/driven.h"

namespace slackwater::twin {
namespace {

double drag_n(const Autopilot& autopilot, double speed_m_s) {
  return (autopilot.linear_damping.linear.x + autopilot.quadratic_damping.linear.x * speed_m_s) *
         speed_m_s;
}

double in_water_w(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v,
                  double speed_m_s) {
  const double wanted_n = drag_n(autopilot, speed_m_s);
  const double share = greatest(
      1, [&](double s) { return driven(vehicle, voltage_v, speed_m_s, s).push_n <= wanted_n; });
  return driven(vehicle, voltage_v, speed_m_s, share).power_w;
}

double in_air_w(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v,
                double speed_m_s) {
  const auto rotors = static_cast<double>(vehicle.mounts);
  const double thrust_n = std::hypot(autopilot.weight_n, drag_n(autopilot, speed_m_s));
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  around.height_m = 1e3;
  around.across_m_s = speed_m_s;
  double sum_w = 0;
  for (std::size_t kind = 0; kind < vehicle.thrusters.size(); ++kind) {
    const Thruster& rotor = vehicle.thrusters[kind];
    const double command = command_for(rotor, thrust_n / rotors, around);
    sum_w +=
        static_cast<double>(mounts_of_kind(vehicle, kind)) * run(rotor, command, around).power_w;
  }
  return sum_w;
}

}  // namespace

double cruise_power_w(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v,
                      double speed_m_s) {
  const double thrusters_w = vehicle.kind == VehicleKind::uav
                                 ? in_air_w(vehicle, autopilot, voltage_v, speed_m_s)
                                 : in_water_w(vehicle, autopilot, voltage_v, speed_m_s);
  return vehicle.hotel_w + thrusters_w;
}

}  // namespace slackwater::twin

#include "twin/vehicle/top_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "twin/vehicle/driven.h"

namespace slackwater::twin {
namespace {

double in_water_m_s(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v,
                    bool has_battery) {
  double most_w = std::numeric_limits<double>::infinity();
  if (has_battery && vehicle.battery) {
    const Battery& battery = *vehicle.battery;
    const double under_load_v = voltage_v - battery.most_current_a * battery.resistance_ohm;
    most_w = std::max(battery.most_current_a * under_load_v - vehicle.hotel_w, 0.0);
  }
  const auto is_driven = [&](double speed_m_s) {
    const double share = greatest(
        1, [&](double s) { return driven(vehicle, voltage_v, speed_m_s, s).power_w <= most_w; });
    const double drag_n =
        (autopilot.linear_damping.linear.x + autopilot.quadratic_damping.linear.x * speed_m_s) *
        speed_m_s;
    return driven(vehicle, voltage_v, speed_m_s, share).push_n >= drag_n;
  };
  return greatest(autopilot.settings.most_speed_m_s, is_driven);
}

double in_air_m_s(const Vehicle& vehicle, const Autopilot& autopilot) {
  const double rotors_n = autopilot.allocation.most_astern[2];
  const double beside_n =
      std::sqrt(std::max(rotors_n * rotors_n - autopilot.weight_n * autopilot.weight_n, 0.0));
  const double most_n = std::min(autopilot.weight_n * autopilot.tan_most_tilt, beside_n);
  const double each_n = autopilot.weight_n / static_cast<double>(vehicle.mounts);
  double rotors_drag = 0;
  for (std::size_t kind = 0; kind < vehicle.thrusters.size(); ++kind) {
    if (vehicle.thrusters[kind].kind != ThrusterKind::rotor) continue;
    const Rotor& rotor = vehicle.thrusters[kind].rotor;
    const double turns = std::sqrt(each_n / rotor.thrust_n_s2);
    rotors_drag += rotor.drag_n_s2_m * turns * static_cast<double>(mounts_of_kind(vehicle, kind));
  }
  return greatest(autopilot.settings.most_speed_m_s, [&](double speed_m_s) {
    const double drag_n = (autopilot.linear_damping.linear.x + rotors_drag +
                           autopilot.quadratic_damping.linear.x * speed_m_s) *
                          speed_m_s;
    return drag_n <= most_n;
  });
}

}  // namespace

double top_speed_m_s(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v,
                     bool has_battery) {
  return vehicle.kind == VehicleKind::uav
             ? in_air_m_s(vehicle, autopilot)
             : in_water_m_s(vehicle, autopilot, voltage_v, has_battery);
}

}  // namespace slackwater::twin

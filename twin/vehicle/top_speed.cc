#include "twin/vehicle/top_speed.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace slackwater::twin {
namespace {

constexpr int halvings = 40;

/// The greatest value up to `most` of which that holds, which it does of smaller ones.
template <typename Holds>
double greatest(double most, Holds&& holds) {
  if (holds(most)) return most;
  double low = 0, high = most;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

struct Push {
  double push_n = 0;
  double power_w = 0;
};

/// All that stand along the way, each at this share of its most.
Push driven(const Vehicle& vehicle, double voltage_v, double speed_m_s, double share) {
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  around.height_m = 1e3;
  Push sum;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const double ahead = vehicle.mount[i].direction.x;
    const double command =
        share * (ahead > 0 ? vehicle.thruster.most_command : vehicle.thruster.least_command);
    if (!(ahead * command > 0)) continue;
    around.advance_m_s = ahead * speed_m_s;
    around.across_m_s = std::sqrt(std::max(1 - ahead * ahead, 0.0)) * speed_m_s;
    const ThrusterOutput<double> thruster = run(vehicle.thruster, command, around);
    sum.push_n += ahead * thruster.thrust_n;
    sum.power_w += thruster.power_w;
  }
  return sum;
}

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
  const Rotor& rotor = vehicle.thruster.rotor;
  const double each_n = autopilot.weight_n / static_cast<double>(vehicle.mounts);
  const double turns =
      vehicle.thruster.kind == ThrusterKind::rotor ? std::sqrt(each_n / rotor.thrust_n_s2) : 0.0;
  const double rotors_drag = rotor.drag_n_s2_m * turns * static_cast<double>(vehicle.mounts);
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

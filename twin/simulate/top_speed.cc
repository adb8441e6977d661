#include "twin/simulate/top_speed.h"

namespace slackwater::twin {

double top_speed_m_s(const Vehicle& vehicle, const Autopilot& autopilot, double voltage_v) {
  const double most_m_s = autopilot.settings.most_speed_m_s;
  if (vehicle.body.hull.strips == 0) return most_m_s;
  const auto is_driven = [&](double speed_m_s) {
    ThrusterSurroundings<double> around;
    around.voltage_v = voltage_v;
    around.height_m = 1e3;
    double push_n = 0;
    for (std::size_t i = 0; i < vehicle.mounts; ++i) {
      const double ahead = vehicle.mount[i].direction.x;
      if (!(ahead > 0)) continue;
      around.advance_m_s = ahead * speed_m_s;
      push_n += ahead * run(vehicle.thruster, vehicle.thruster.most_command, around).thrust_n;
    }
    const double drag_n =
        (autopilot.linear_damping.linear.x + autopilot.quadratic_damping.linear.x * speed_m_s) *
        speed_m_s;
    return push_n >= drag_n;
  };
  if (is_driven(most_m_s)) return most_m_s;
  double low = 0, high = most_m_s;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (is_driven(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace slackwater::twin

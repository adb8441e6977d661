#include "twin/vehicle/driven.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

Push driven(const Vehicle& vehicle, double voltage_v, double speed_m_s, double share) {
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  around.height_m = 1e3;
  Push sum;
  for (std::size_t i = 0; i < vehicle.mounts; ++i) {
    const Thruster& thruster = thruster_of(vehicle, i);
    const double ahead = vehicle.mount[i].direction.x;
    const double command = share * (ahead > 0 ? thruster.most_command : thruster.least_command);
    if (!(ahead * command > 0)) continue;
    around.advance_m_s = ahead * speed_m_s;
    around.across_m_s = std::sqrt(std::max(1 - ahead * ahead, 0.0)) * speed_m_s;
    const ThrusterOutput<double> out = run(thruster, command, around);
    sum.push_n += ahead * out.thrust_n;
    sum.power_w += out.power_w;
  }
  return sum;
}

}  // namespace slackwater::twin

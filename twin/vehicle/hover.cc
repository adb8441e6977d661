#include "twin/vehicle/hover.h"

#include <algorithm>

#include "fields/base/constants.h"

namespace slackwater::twin {

std::array<double, most_mounts> hovering_thrusters(const Vehicle& vehicle, double voltage_v,
                                                   double height_m) {
  std::array<double, most_mounts> thruster{};
  if (vehicle.kind != VehicleKind::uav) return thruster;
  ThrusterSurroundings<double> around;
  around.voltage_v = voltage_v;
  around.height_m = std::max(height_m, 0.0);
  const double each_n =
      vehicle.body.mass_kg * constants::gravity_m_s2 / static_cast<double>(vehicle.mounts);
  for (std::size_t i = 0; i < vehicle.mounts; ++i)
    thruster[i] = command_for(thruster_of(vehicle, i), each_n, around);
  return thruster;
}

}  // namespace slackwater::twin

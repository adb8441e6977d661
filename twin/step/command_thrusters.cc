#include "twin/step/command_thrusters.h"

#include "twin/thruster/thrust_curve.h"

namespace slackwater::twin {

void command_thrusters(const Vehicle& vehicle, const std::array<double, most_mounts>& thrust_n,
                       const ThrustersMeet& meet, VehicleCommand<double>& command) {
  ThrusterSurroundings<double> around;
  around.voltage_v = meet.voltage_v;
  around.height_m = meet.height_m;
  for (std::size_t kind = 0; kind < vehicle.thrusters.size(); ++kind) {
    const Thruster& thruster = vehicle.thrusters[kind];
    const auto command_each = [&](const auto& command_of) {
      for (std::size_t i = 0; i < vehicle.mounts; ++i)
        if (vehicle.mount[i].kind == kind) command.thruster[i] = command_of(i);
    };
    if (thruster.kind == ThrusterKind::table) {
      const ThrustCurve curve(thruster.table, around.voltage_v);
      command_each([&](std::size_t i) { return curve.command_for(thrust_n[i]); });
    } else {
      command_each([&](std::size_t i) {
        around.advance_m_s = dot(vehicle.mount[i].direction, meet.through_m_s);
        return command_for(thruster, thrust_n[i], around);
      });
    }
  }
}

void command_effort(const Vehicle& vehicle, const Effort& effort, const ThrustersMeet& meet,
                    VehicleCommand<double>& command) {
  command_thrusters(vehicle, effort.thrust_n, meet, command);
  command.rudder_rad = effort.rudder_rad;
  command.elevator_rad = effort.elevator_rad;
  command.moving_mass_m = effort.moving_mass_m;
  command.volume_m3 = effort.volume_m3;
}

}  // namespace slackwater::twin

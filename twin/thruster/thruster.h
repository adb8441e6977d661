#pragma once
#include <filesystem>

#include "fields/base/config.h"
#include "twin/thruster/drive.h"
#include "twin/thruster/propeller.h"
#include "twin/thruster/rotor.h"
#include "twin/thruster/thrust_table.h"

namespace slackwater::twin {

enum class ThrusterKind {
  table,      ///< measured thrust by command
  propeller,  ///< commanded by the speed of its shaft
  rotor,      ///< of a multirotor, likewise
  drive,      ///< commanded by thrust
};

/// What pushes a vehicle at one or more of its mounts. Of the four the one of its kind is used.
struct Thruster {
  ThrusterKind kind = ThrusterKind::table;
  double rise_time_constant_s = 0;  ///< of the lag behind the command, towards greater ones
  double fall_time_constant_s = 0;
  double least_command = 0;
  double most_command = 0;
  ThrustTable table;
  Propeller propeller;
  Rotor rotor;
  Drive drive;
};

/// What a thruster does at a command (behind its lag). No allocation; the same bits for one and for
/// eight.
template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const Thruster& thruster, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  switch (thruster.kind) {
    case ThrusterKind::table:
      return run(thruster.table, command, around);
    case ThrusterKind::propeller:
      return run(thruster.propeller, command, around);
    case ThrusterKind::rotor:
      return run(thruster.rotor, command, around);
    case ThrusterKind::drive:
      break;
  }
  return run(thruster.drive, command, around);
}

/// The command of least size that gives a thrust in these surroundings; the full one where none
/// does. Cost: 0.1 us.
[[nodiscard]] double command_for(const Thruster& thruster, double thrust_n,
                                 const ThrusterSurroundings<double>& around);

/// Reads the `thruster` of a vehicle: a kind with its numbers, or the `model` of
/// data_folder/thrusters/MODEL.yaml.
/// Throws Error(invalid_input) with file, line and reason.
[[nodiscard]] Thruster read_thruster(const Config& thruster,
                                     const std::filesystem::path& data_folder);

}  // namespace slackwater::twin

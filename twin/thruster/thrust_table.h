#pragma once
#include <cstdint>
#include <vector>

#include "twin/curve/uniform_axis.h"
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// Thrust and electrical power as measured at rest, by command (-1 full astern to 1 full ahead) and voltage of the bus.
struct ThrustTable {
  UniformAxis command;
  UniformAxis voltage_v;
  std::vector<double> thrust_n;  ///< a row per voltage; never falls with the command
  std::vector<double> power_w;   ///< likewise laid out
  double disc_kg_m = 0;          ///< 2 rho A
  /// Where to begin to look for a thrust: of each row, at thrusts whose roots are even, the entry below.
  std::vector<std::uint16_t> guess;
};

inline constexpr std::size_t thrust_guesses = 256;  ///< of a row
/// Fills `guess` once the rest stands.
void index_thrusts(ThrustTable& table);

/// Straight lines between what was measured; above the highest voltage as there, below the lowest the thrust falls with
/// the square of the voltage and the power with its cube, as for a propeller whose speed goes with the voltage. In flow
/// the thrust is that of an actuator disc that keeps its hydraulic power.
template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const ThrustTable& table, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  const PlaceOnAxis<Real> row = place_on(table.voltage_v, around.voltage_v);
  const PlaceOnAxis<Real> column = place_on(table.command, command);
  const auto columns = static_cast<double>(table.command.count);
  const PlaceOnAxis<Real> low{columns * row.below + column.below, column.share};
  const PlaceOnAxis<Real> high{low.below + columns, column.share};
  const auto between = [&](const std::vector<double>& values) -> Real {
    const Real below = on_line(values.data(), low).value;
    return below + row.share * (on_line(values.data(), high).value - below);
  };
  const Real sag = speed_share(table.voltage_v.first, around.voltage_v);
  const Real rest_n = sag * sag * between(table.thrust_n);
  ThrusterOutput<Real> out;
  out.thrust_n = thrust_in_flow(table.disc_kg_m, rest_n, around.advance_m_s);
  out.power_w = sag * sag * sag * between(table.power_w);
  return out;
}

/// The command of least size with that thrust in these surroundings, or the full one.
[[nodiscard]] double command_for(const ThrustTable& table, double thrust_n,
                                 const ThrusterSurroundings<double>& around);

}  // namespace slackwater::twin

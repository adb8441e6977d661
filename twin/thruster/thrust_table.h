#pragma once
#include <cstdint>
#include <vector>

#include "twin/curve/uniform_axis.h"
#include "twin/thruster/actuator_disc.h"
#include "twin/thruster/surroundings.h"

namespace slackwater::twin {

/// Thrust and electrical power as measured at rest, by command (-1 full astern to 1 full ahead) and
/// voltage of the bus.
struct ThrustTable {
  UniformAxis command;
  UniformAxis voltage_v;
  std::vector<double> thrust_n;  ///< a row per voltage; never falls with the command
  std::vector<double> power_w;   ///< likewise laid out
  double disc_kg_m = 0;          ///< 2 rho A
  // What follows is made of these by `index_thrusts`.
  /// Of each entry four numbers: thrust there and at the next command, power there and at the next.
  std::vector<double> step;
  /// Of each row the thrusts ahead, then astern, counted positive, by steps from command 0; padded
  /// by huge ones.
  std::vector<double> half_n;
  /// Where to look for a thrust: of each row and the next, ahead and astern, of shares of the full
  /// thrust whose roots are even: the step that has less on any bus between the two...
  std::vector<std::uint16_t> least_step;
  std::size_t tries = 0;  ///< ...and how many further steps may have less still

  [[nodiscard]] std::size_t half_count() const { return (command.count + 1) / 2; }
};

inline constexpr std::size_t thrust_slots = 256;  ///< of a row, one way
inline constexpr std::size_t thrust_tries = 6;    ///< at a time; even
/// Fills all that once the rest stands.
void index_thrusts(ThrustTable& table);

/// Straight lines between what was measured; above the highest voltage as there, below the lowest
/// the thrust falls with the square of the voltage and the power with its cube, as for a propeller
/// whose speed goes with the voltage. In flow the thrust is that of an actuator disc that keeps its
/// hydraulic power.
template <typename Real>
[[nodiscard]] ThrusterOutput<Real> run(const ThrustTable& table, const Real& command,
                                       const ThrusterSurroundings<Real>& around) {
  const PlaceOnAxis<Real> row = place_on(table.voltage_v, around.voltage_v);
  const PlaceOnAxis<Real> column = place_on(table.command, command);
  const auto columns = static_cast<double>(table.command.count);
  const Real entry = columns * row.below + column.below;
  const std::array<Real, 4> low = four_entries_of(table.step.data(), entry);
  const std::array<Real, 4> high = four_entries_of(table.step.data(), Real{entry + columns});
  const auto between = [&](std::size_t first) -> Real {
    const Real below = low[first] + column.share * (low[first + 1] - low[first]);
    const Real above = high[first] + column.share * (high[first + 1] - high[first]);
    return below + row.share * (above - below);
  };
  const Real sag = speed_share(table.voltage_v.first, around.voltage_v);
  const Real rest_n = sag * sag * between(0);
  ThrusterOutput<Real> out;
  out.thrust_n = thrust_in_flow(table.disc_kg_m, rest_n, around.advance_m_s);
  out.power_w = sag * sag * sag * between(2);
  return out;
}

/// The command of least size with that thrust in these surroundings, or the full one.
[[nodiscard]] double command_for(const ThrustTable& table, double thrust_n,
                                 const ThrusterSurroundings<double>& around);

}  // namespace slackwater::twin

#include <algorithm>
#include <cmath>

#include "twin/thruster/thruster.h"

namespace slackwater::twin {

double rest_thrust_n(double disc_kg_m, double thrust_n, double advance_m_s) {
  const double way = way_of(thrust_n);
  const double size_n = std::abs(thrust_n);
  const double half = 0.5 * way * advance_m_s;
  const double through = half + std::sqrt(half * half + size_n / disc_kg_m);  // Va + w
  // P = T (Va + w) = 2 rho A w0^3.
  const double induced_m_s = std::cbrt(size_n * through / disc_kg_m);
  if (way * advance_m_s > -most_backflow * induced_m_s)
    return way * disc_kg_m * induced_m_s * induced_m_s;
  static const double held = flow_through_disc(-most_backflow);
  return thrust_n * held;
}

namespace {

/// Thrust goes with the square of the command, so that slots are even in its root; rows of near voltages have one shape
/// between their ends.
constexpr double middle_slot = 0.5 * (thrust_guesses - 1);
std::size_t slot_of(double thrust_n, double first_n, double last_n) {
  const double share = thrust_n < 0 ? -std::sqrt(std::min(thrust_n / first_n, 1.0))
                                    : std::sqrt(std::min(thrust_n / last_n, 1.0));
  return static_cast<std::size_t>(middle_slot + middle_slot * share);
}
double thrust_at_slot(std::size_t slot, double first_n, double last_n) {
  const double share = static_cast<double>(slot) / middle_slot - 1;
  return share * share * (share < 0 ? first_n : last_n);
}

/// A row of the table at a voltage between two.
struct Row {
  const double* low;
  const double* high;
  double share;
  const std::uint16_t* guess;
  std::size_t count;
  [[nodiscard]] double at(std::size_t i) const { return low[i] + share * (high[i] - low[i]); }

  /// The entry that the guesses of the row below begin with, and from there on: the last one whose thrust is less.
  [[nodiscard]] std::size_t last_below(double thrust_n) const {
    std::size_t i = guess[slot_of(thrust_n, at(0), at(count - 1))];
    while (i > 0 && !(at(i) < thrust_n)) --i;
    while (i + 2 < count && at(i + 1) < thrust_n) ++i;
    return i;
  }
  /// Likewise the first one whose thrust is more.
  [[nodiscard]] std::size_t first_above(double thrust_n) const {
    std::size_t i = last_below(thrust_n);
    while (i + 1 < count && !(at(i) > thrust_n)) ++i;
    return i;
  }
};

Row row_at(const ThrustTable& table, double voltage_v) {
  const PlaceOnAxis<double> place = place_on(table.voltage_v, voltage_v);
  const auto row = static_cast<std::size_t>(place.below);
  const double* low = table.thrust_n.data() + row * table.command.count;
  return {low, low + table.command.count, place.share, table.guess.data() + row * thrust_guesses,
          table.command.count};
}

double share_between(double value, double a, double b) {
  return std::clamp((value - a) / (b - a), 0.0, 1.0);
}

}  // namespace

void index_thrusts(ThrustTable& table) {
  const std::size_t columns = table.command.count;
  table.guess.clear();
  for (std::size_t row = 0; row < table.voltage_v.count; ++row) {
    const double* thrust_n = table.thrust_n.data() + row * columns;
    std::size_t below = 0;
    for (std::size_t i = 0; i < thrust_guesses; ++i) {
      const double at_n = thrust_at_slot(i, thrust_n[0], thrust_n[columns - 1]);
      while (below + 1 < columns && thrust_n[below + 1] < at_n) ++below;
      table.guess.push_back(static_cast<std::uint16_t>(below));
    }
  }
}

double command_for(const ThrustTable& table, double thrust_n,
                   const ThrusterSurroundings<double>& around) {
  if (!(std::abs(thrust_n) > 0)) return 0;
  const double sag = speed_share(table.voltage_v.first, around.voltage_v);
  if (!(sag > 0)) return 0;
  const double at_rest_n = around.advance_m_s == 0
                               ? thrust_n
                               : rest_thrust_n(table.disc_kg_m, thrust_n, around.advance_m_s);
  const double wanted = at_rest_n / (sag * sag);
  const Row row = row_at(table, around.voltage_v);
  const UniformAxis& axis = table.command;
  const std::size_t none = (axis.count - 1) / 2;  // no thrust: the middle of the axis is command 0
  if (thrust_n > 0) {
    if (!(row.at(axis.count - 1) > wanted)) return axis.at(axis.count - 1);
    const std::size_t weak = std::max(row.last_below(wanted), none);
    return axis.at(weak) + axis.step * share_between(wanted, row.at(weak), row.at(weak + 1));
  }
  if (!(row.at(0) < wanted)) return axis.at(0);
  const std::size_t weak = std::min(row.first_above(wanted), none);
  return axis.at(weak) - axis.step * share_between(wanted, row.at(weak), row.at(weak - 1));
}

double command_for(const Thruster& thruster, double thrust_n,
                   const ThrusterSurroundings<double>& around) {
  const auto limited = [&](double command) {
    return std::clamp(command, thruster.least_command, thruster.most_command);
  };
  switch (thruster.kind) {
    case ThrusterKind::table:
      return command_for(thruster.table, thrust_n, around);
    case ThrusterKind::propeller:
      return limited(
          std::copysign(std::sqrt(std::abs(thrust_n) / thruster.propeller.thrust_n_s2), thrust_n));
    case ThrusterKind::rotor: {
      const Rotor& rotor = thruster.rotor;
      if (!(thrust_n > 0)) return thruster.least_command;
      // What the ground adds depends on the thrust but little: once is enough near hover, and exact at rest.
      const double edgewise2 = around.across_m_s * around.across_m_s;
      const double induced_m_s = induced_velocity_m_s(thrust_n / rotor.disc_kg_m,
                                                      std::max(around.advance_m_s, 0.0), edgewise2);
      const double free_n =
          thrust_n / ground_effect(rotor.radius_m, around.height_m, edgewise2, induced_m_s);
      return limited(std::sqrt(free_n / rotor.thrust_n_s2));
    }
    case ThrusterKind::drive:
      break;
  }
  return limited(thrust_n);
}

}  // namespace slackwater::twin

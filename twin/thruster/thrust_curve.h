#pragma once
#include "twin/thruster/thrust_table.h"

namespace slackwater::twin {

/// A thrust table on a bus of one voltage, to be asked for commands: what the thrusters of a vehicle have in common is
/// worked out once. Lives as long as the table does.
class ThrustCurve {
 public:
  ThrustCurve(const ThrustTable& table, double voltage_v);

  /// The command of least size with that thrust at rest, or the full one; 0 on a bus without voltage. Cost: 20 ns.
  [[nodiscard]] double command_for(double rest_thrust_n) const;

 private:
  [[nodiscard]] double thrust_n(std::size_t i) const { return low_[i] + share_ * rise_of(i); }
  [[nodiscard]] double rise_of(std::size_t i) const { return high_[i] - low_[i]; }
  [[nodiscard]] double ahead(double wanted_n) const;
  [[nodiscard]] double astern(double wanted_n) const;

  const UniformAxis* axis_;
  const double* low_;  ///< the rows of the voltages below and above
  const double* high_;
  const std::uint16_t* guess_;
  double share_ = 0;  ///< of the upper row
  double sag_ = 0;
  std::size_t none_;  ///< no thrust: the middle of the axis is command 0
  double first_n_ = 0;
  double last_n_ = 0;
};

}  // namespace slackwater::twin

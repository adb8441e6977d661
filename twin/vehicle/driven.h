#pragma once
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// What the thrusters that stand along the way give together.
struct Push {
  double push_n = 0;
  double power_w = 0;
};

/// All of them at this share of their most, at a speed ahead through still water.
[[nodiscard]] Push driven(const Vehicle& vehicle, double voltage_v, double speed_m_s, double share);

/// The greatest value up to `most` of which that holds, which it does of smaller ones.
template <typename Holds>
[[nodiscard]] double greatest(double most, Holds&& holds) {
  constexpr int halvings = 40;
  if (holds(most)) return most;
  double low = 0, high = most;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace slackwater::twin

#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "twin/thruster/thrust_table.h"

namespace slackwater::twin {

/// A thrust table on a bus of one voltage, to be asked for commands: what the thrusters of a
/// vehicle have in common is worked out once. Lives as long as the table does.
class ThrustCurve {
 public:
  ThrustCurve(const ThrustTable& table, double voltage_v);

  /// The command of least size with that thrust at rest, or the full one; 0 on a bus without
  /// voltage. Cost: 15 ns, the same for all thrusts: no branch hangs on where the thrust lies in
  /// the table.
  [[nodiscard]] double command_for(double rest_thrust_n) const {
    const Way& way = rest_thrust_n < 0 ? astern_ : ahead_;
    const double wanted_n = std::abs(rest_thrust_n) * per_sag2_;
    if (!(wanted_n > 0)) return 0;
    if (!(way.full_n > wanted_n)) return way.sign;
    // A share that rounds to one belongs to the last slot.
    const auto slot =
        static_cast<std::ptrdiff_t>(thrust_slots * std::sqrt(wanted_n * way.per_full_n));
    std::size_t step = way.least_step[std::min<std::ptrdiff_t>(slot, thrust_slots - 1)];
    const std::size_t last_try = step + tries_;
    for (std::size_t first = step + 1; first <= last_try; first += thrust_tries)
      step += with_less(way, first, wanted_n);
    const double less_n = thrust_n(way, step);
    const double more_n = thrust_n(way, step + 1);
    const double share = std::clamp((wanted_n - less_n) / (more_n - less_n), 0.0, 1.0);
    return way.sign * command_step_ * (static_cast<double>(step) + share);
  }

 private:
  /// The half of the table with thrusts one way, counted positive, by steps from command 0.
  struct Way {
    const double* low_n = nullptr;  ///< of the rows of the voltages below and above
    const double* high_n = nullptr;
    const std::uint16_t* least_step = nullptr;
    double sign = 1;
    double full_n = 0;
    double per_full_n = 0;
  };
  [[nodiscard]] double thrust_n(const Way& way, std::size_t step) const {
    return way.low_n[step] + share_ * (way.high_n[step] - way.low_n[step]);
  }
  /// How many of the next `thrust_tries` steps have less than is wanted.
  [[nodiscard]] std::size_t with_less(const Way& way, std::size_t first, double wanted_n) const {
    using Two [[gnu::vector_size(16)]] = double;
    using Counts [[gnu::vector_size(16)]] = std::int64_t;
    const Two wanted{wanted_n, wanted_n};
    Counts counts{};
    for (std::size_t k = first; k < first + thrust_tries; k += 2) {
      Two low_n, high_n;
      std::memcpy(&low_n, way.low_n + k, sizeof low_n);
      std::memcpy(&high_n, way.high_n + k, sizeof high_n);
      counts -= low_n + share_ * (high_n - low_n) < wanted;  // true is -1
    }
    return static_cast<std::size_t>(counts[0] + counts[1]);
  }
  [[nodiscard]] Way way_of(const ThrustTable& table, std::size_t row, bool is_astern) const;

  double share_ = 0;  ///< of the upper row
  double per_sag2_ = 0;
  double command_step_ = 0;
  std::size_t tries_ = 0;
  Way ahead_;
  Way astern_;
};

}  // namespace slackwater::twin

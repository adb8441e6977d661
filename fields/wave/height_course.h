#pragma once
#include <optional>
#include <vector>

#include "fields/base/lead.h"

namespace slackwater {

/// How the height of a sea changes: a factor on its elevation and all its motion, r(t), at nodes
/// that lie one step apart, linear in between and held before the first and after the last.
///
/// What it leaves out: r eta and r u solve the linear equations but for terms in dr/dt, which are
/// to those with r omega as |dr/dt| / (r omega) = T / (2 pi tau), with T the period of a wave and
/// tau = r / |dr/dt| the time in which the sea would grow by its own height. A sea of 10 s that
/// doubles within an hour (tau 1.4 h): 3e-4.
class HeightCourse {
 public:
  HeightCourse() = default;  ///< 1 at all times
  /// @param step_s   above 0, from one node to the next; the first is at t = 0
  /// @param factors  finite and not below 0; none: 1 at all times
  /// @throws ContractViolation
  HeightCourse(double step_s, std::vector<double> factors);

  /// The same, led to another factor over a while (lead.h); nothing: back to these nodes.
  /// @param to  finite and not below 0
  /// @throws ContractViolation
  [[nodiscard]] HeightCourse led(std::optional<double> to, double from_s, double over_s) const;

  /// Of a time that is no number, that of the first node. No allocation.
  [[nodiscard]] double at(double t_s) const noexcept;
  [[nodiscard]] bool is_constant() const noexcept { return factors_.empty() && lead_.is_none(); }

 private:
  [[nodiscard]] double at_nodes(double t_s) const noexcept;

  double step_s_ = 1;
  std::vector<double> factors_;
  Lead<double> lead_;
};

}  // namespace slackwater

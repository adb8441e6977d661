#pragma once
#include <cmath>

namespace slackwater {

/// Jensen's wake: one deficit over a disc that widens as a cone.
///
///   dU/U = (1 - sqrt(1 - Ct)) [D/(D + 2 k x)]^2   for r <= D/2 + k x, else 0
///
/// Conserves mass between rotor and wake; no near wake (the deficit at the rotor is the full 2a).
/// Offshore k is 0.04 to 0.05, on land 0.075.
/// Source: Jensen (1983), Risoe-M-2411; Katic, Hoejstrup & Jensen (1986).
class JensenWake {
 public:
  /// @param thrust_coefficient  Ct in [0, 1);  @param growth  k >= 0
  JensenWake(double diameter_m, double thrust_coefficient, double growth) noexcept
      : radius_m_(0.5 * diameter_m),
        growth_(growth),
        initial_deficit_(1 - std::sqrt(1 - thrust_coefficient)) {}

  /// Deficit as a fraction of the wind at the turbine, x downstream, r from the axis; x > 0.
  [[nodiscard]] double deficit(double downstream_m, double radius_m) const noexcept {
    const double edge_m = radius_m_ + growth_ * downstream_m;
    if (radius_m > edge_m) return 0;
    const double narrowing = radius_m_ / edge_m;
    return initial_deficit_ * narrowing * narrowing;
  }
  /// Radius of the wake (m), x > 0: outside it the deficit is 0.
  [[nodiscard]] double edge_m(double downstream_m) const noexcept {
    return radius_m_ + growth_ * downstream_m;
  }
  /// A radius that the edge stays within, cheap: a samplers' first question.
  [[nodiscard]] double reach_m(double downstream_m) const noexcept { return edge_m(downstream_m); }

 private:
  double radius_m_;
  double growth_;
  double initial_deficit_;
};

}  // namespace slackwater

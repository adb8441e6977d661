#pragma once
#include <algorithm>
#include <cmath>

namespace slackwater {

/// Growth of a wake with the turbulence of the air it stands in, k* = 0.3837 TI + 0.003678
/// (Niayifar & Porte-Agel 2016, Energies 9, 741; fitted for 0.065 < TI < 0.15).
[[nodiscard]] inline double wake_growth(double turbulence_intensity) noexcept {
  return 0.3837 * turbulence_intensity + 0.003678;
}

/// Deficit on the axis of a Gaussian wake that carries away the thrust of the rotor exactly:
///
///   C = 1 - sqrt(1 - Ct/[8 (sigma/D)^2])   from   int (1 - d) d dA = Ct A/2,  d = C e^(-r2/2 s2)
///
/// Where the wake is too narrow to carry the thrust (8 (sigma/D)^2 < Ct) no real C exists; 1 is
/// returned, still air.
[[nodiscard]] inline double gaussian_axis_deficit(double thrust_coefficient,
                                                  double width_diameters) noexcept {
  const double rest = 1 - thrust_coefficient / (8 * width_diameters * width_diameters);
  return 1 - std::sqrt(std::max(0.0, rest));
}

/// Bastankhah and Porte-Agel's wake: Gaussian across, conserving momentum.
///
///   dU/U = C(x) exp(-r^2/(2 sigma^2)),  sigma/D = k* x/D + 0.2 sqrt(beta)
///   beta = (1 + sqrt(1 - Ct)) / (2 sqrt(1 - Ct))
///
/// A far-wake model: within two to four diameters it asks for more than the air can give, and is
/// held at still air. Use BlendedWake there.
/// Source: Bastankhah & Porte-Agel (2014), Renewable Energy 70, 116.
class GaussianWake {
 public:
  /// @param thrust_coefficient  Ct in [0, 1);  @param growth  k* >= 0, see `wake_growth`
  GaussianWake(double diameter_m, double thrust_coefficient, double growth) noexcept
      : diameter_m_(diameter_m), growth_(growth), thrust_coefficient_(thrust_coefficient) {
    const double outflow = std::sqrt(1 - thrust_coefficient);
    initial_width_m_ = 0.2 * std::sqrt((1 + outflow) / (2 * outflow)) * diameter_m;
  }

  /// Deficit as a fraction of the wind at the turbine, x downstream, r from the axis; x > 0.
  [[nodiscard]] double deficit(double downstream_m, double radius_m) const noexcept {
    const double width_m = initial_width_m_ + growth_ * downstream_m;
    const double ratio = radius_m / width_m;
    return gaussian_axis_deficit(thrust_coefficient_, width_m / diameter_m_) *
           std::exp(-0.5 * ratio * ratio);
  }
  /// Two standard deviations, x > 0: most of the wake.
  [[nodiscard]] double edge_m(double downstream_m) const noexcept {
    return 2 * (initial_width_m_ + growth_ * downstream_m);
  }
  /// Six standard deviations: beyond, the deficit is below 2e-8.
  [[nodiscard]] double reach_m(double downstream_m) const noexcept {
    return 3 * edge_m(downstream_m);
  }

 private:
  double diameter_m_;
  double growth_;
  double thrust_coefficient_;
  double initial_width_m_;
};

}  // namespace slackwater

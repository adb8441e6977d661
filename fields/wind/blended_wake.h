#pragma once

namespace slackwater {

/// The two numbers of a blended wake, in diameters; from formulas, or fitted to a measured wake.
struct BlendedWakeShape {
  double near_wake_length = 4;  ///< x_n/D > 0, where the core of the near wake is eaten up
  double growth = 0.03;         ///< k >= 0, d sigma/dx just behind it
  bool operator==(const BlendedWakeShape&) const = default;
};

/// The published formulas: near wake of Bastankhah & Porte-Agel (2016, eq. 7.3 without yaw),
///   x_n/D = (1 + sqrt(1 - Ct)) / {sqrt(2) [2.32 TI + 0.154 (1 - sqrt(1 - Ct))]},
/// held at 30 D, and growth k* of Niayifar & Porte-Agel (2016).
[[nodiscard]] BlendedWakeShape blended_wake_shape(double thrust_coefficient,
                                                  double turbulence_intensity) noexcept;

/// A wake that is usable from the rotor to the horizon: three published regimes joined so that the
/// momentum taken from the air is the thrust of the rotor at every distance,
///
///   int (1 - d) d dA = Ct A/2     exactly, for all x > 0 and all Ct < 1.
///
/// 1. Near, x <= x_n (Bastankhah & Porte-Agel 2016): a core of deficit 1 - sqrt(1 - Ct), the
///    induction of an actuator disc, whose radius shrinks linearly from that of Frandsen's wake,
///    sqrt(beta) D/2, to nothing; around it a Gaussian edge, whose width follows from the momentum.
///    At x_n it is a Gaussian of sigma = D/sqrt(8): the same number that those authors find.
/// 2. Middle: a Gaussian whose width grows linearly, sigma_1 = D/sqrt(8) + k (x - x_n).
/// 3. Far, from x_f = max(9.6 D, 2 x_n): Larsen's similarity law, width as the cube root of the
///    distance: sigma_2^3 is the straight line through the widths of (2) at x_n and x_f. 9.6 D is
///    where Larsen (2009) anchors his; the widths of the two models agree there within a few per
///    cent for Ct 0.75 and TI 0.05 to 0.12, which is why they can be joined.
///
/// Between x_n and x_f the width is (1-w) sigma_1 + w sigma_2 with w a smooth step; sigma_1 <=
/// sigma_2 there, so the wake never narrows. The depth always follows from the width.
///
/// Steady, axisymmetric, no ground: the wake of the mirror turbine is left out.
class BlendedWake {
 public:
  /// @param thrust_coefficient  Ct in (0, 1)
  BlendedWake(double diameter_m, double thrust_coefficient, BlendedWakeShape shape) noexcept;

  /// Deficit as a fraction of the wind at the turbine, x downstream, r from the axis; x > 0.
  [[nodiscard]] double deficit(double downstream_m, double radius_m) const noexcept;
  /// Two standard deviations, with the core where there is one; x > 0.
  [[nodiscard]] double edge_m(double downstream_m) const noexcept;
  /// Beyond this radius the deficit is below 2e-8; a bound without roots.
  [[nodiscard]] double reach_m(double downstream_m) const noexcept {
    const double tangent_m = tangent_m_ + tangent_slope_ * downstream_m;
    return tangent_m > shortest_reach_m_ ? tangent_m : shortest_reach_m_;
  }

 private:
  /// A core of constant deficit with a Gaussian edge, in diameters.
  struct Profile {
    double axis_deficit;
    double core;   ///< radius of the core
    double width;  ///< sigma of the edge
  };
  [[nodiscard]] Profile profile(double downstream_diameters) const noexcept;
  [[nodiscard]] Profile near_profile(double downstream_diameters) const noexcept;
  [[nodiscard]] double far_width(double downstream_diameters) const noexcept;

  double diameter_m_;
  double thrust_coefficient_;
  double induction_deficit_;  ///< 1 - sqrt(1 - Ct)
  double initial_core_;       ///< sqrt(beta)/2
  BlendedWakeShape shape_;
  double far_start_;    ///< x_f/D
  double cube_growth_;  ///< d(sigma_2^3)/dx
  double shortest_reach_m_;
  double tangent_m_ = 0;
  double tangent_slope_ = 0;
};

}  // namespace slackwater

#pragma once

namespace slackwater {

/// Which measurements anchor the width of Larsen's wake near 10 diameters.
enum class LarsenRadius {
  /// R(9.6 D) from Ct and turbulence, Larsen (2009): the one in use.
  risoe_2009,
  /// R(9.5 D) = [R_nb + min(hub height, R_nb)]/2, R_nb = 1.08 D + 21.7 D max(0, TI - 0.05), of the
  /// European Wind Turbine Standards II (Larsen, Hoejstrup & Madsen 1996): a narrower and deeper
  /// wake, still found in many tools.
  ewts_1996,
};

/// Larsen's wake: Prandtl's turbulent boundary layer equations solved for a rotor, first order.
///
///   dU/U = 1/9 [Ct A (x+x0)^-2]^(1/3) { r^1.5 [3 c1^2 Ct A (x+x0)]^-0.5
///                                       - (35/2pi)^0.3 (3 c1^2)^-0.2 }^2,   r < R_w
///   R_w  = (105 c1^2/2pi)^0.2 [Ct A (x+x0)]^(1/3)
///   x0   = 9.6 D/[(2 R96/(kL D))^3 - 1],  c1 = (kL D/2)^2.5 (105/2pi)^-0.5 (Ct A x0)^(-5/6)
///   kL   = sqrt((m + 1)/2),  m = 1/sqrt(1 - Ct)
///   R96  = 0.435449861 exp(0.797853685 Ct^2 - 0.124807893 Ct + 0.136821858) (15.6298 TI + 1) D
///
/// The flux of deficit is that of the thrust to first order: int dU/U dA = Ct A/2.
/// Where the anchor is no wider than the wake at the rotor (still air with very small or very large
/// thrust) x0 has no value; the wake is then taken to grow by 0.1 % over those diameters.
/// Source: Larsen (2009), Risoe-R-1713; formula and anchor as in PyWake's gcl.py.
class LarsenWake {
 public:
  /// @param thrust_coefficient    Ct in (0, 1)
  /// @param turbulence_intensity  TI >= 0, as a fraction
  /// @param hub_height_m          used by the ewts_1996 anchor alone
  LarsenWake(double diameter_m, double thrust_coefficient, double turbulence_intensity,
             LarsenRadius anchor, double hub_height_m) noexcept;

  /// Deficit as a fraction of the wind at the turbine, x downstream, r from the axis; x > 0.
  [[nodiscard]] double deficit(double downstream_m, double radius_m) const noexcept;
  /// R_w (m), x > 0: outside it the deficit is 0.
  [[nodiscard]] double edge_m(double downstream_m) const noexcept;
  /// A radius that the edge stays within, without a cube root: R_w is concave, its tangents are
  /// above it.
  [[nodiscard]] double reach_m(double downstream_m) const noexcept {
    return tangent_m_ + tangent_slope_ * downstream_m;
  }

 private:
  double origin_m_ = 0;    ///< x0
  double edge_scale_ = 0;  ///< R_w / (x + x0)^(1/3)
  double axis_scale_ = 0;  ///< deficit on the axis times (x + x0)^(2/3)
  double tangent_m_ = 0;
  double tangent_slope_ = 0;
};

}  // namespace slackwater

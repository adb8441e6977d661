#pragma once
#include <functional>
#include <vector>

#include "fields/base/frame.h"

namespace slackwater::api {

/// Mixing of the synthetic sea at one place. Both numbers are chosen so that A/H^2 and r/H are the
/// same everywhere: the column then has one shape in z/H, and one integration serves every depth
/// exactly.
struct ColumnMixing {
  double eddy_viscosity_m2_s = 0;  ///< A, constant over the depth
  double bottom_friction_m_s = 0;  ///< r of the linear bottom stress A dW/dz = r W
};

/// What the three parts of the current share: the Earth and the mixing at a reference depth.
struct ColumnPhysics {
  double coriolis_rad_s = 0;  ///< f of the site, used throughout (an f-plane)
  double reference_depth_m = 35;
  ColumnMixing reference{.eddy_viscosity_m2_s = 0.02, .bottom_friction_m_s = 1.2e-3};

  [[nodiscard]] ColumnMixing at_depth(double water_depth_m) const noexcept;
};

/// Profile of an oscillation exp(i sigma t) with unit amplitude far from the bed, over a bed with
/// linear friction:
///
///   W(z)/W_inf = 1 - r cosh(lambda z) / [r cosh(lambda H) + A lambda sinh(lambda H)],
///   lambda^2   = i (f + sigma)/A
///
/// sigma = 0 is the steady bottom Ekman layer, sigma > 0 turns counter-clockwise. No stress at the
/// surface. Source: the momentum balance i (f + sigma) (W - W_inf) = A W''; compare reference
/// rotary layers of Prandle (1982).
[[nodiscard]] Horizontal bottom_layer_factor(const ColumnPhysics& physics, double water_depth_m,
                                             double depth_m, double sigma_rad_s) noexcept;

/// The response of the column to a wind history, with memory: the exact solution by vertical
/// eigenmodes of
///
///   dW/dt + i f W = A W_zz,   A W_z = F(t) at z = 0,   A W_z = r W at z = -H,
///   W = 0 at the first time,
///
/// with F the kinematic stress (stress over water density, m2/s2), piecewise linear between
/// samples. Each mode is advanced exactly (an inertial oscillation with its own damping); modes
/// beyond the last one follow the stress at once, which the static profile gives in closed form.
/// Truncation error below 0.1 mm/s at 1e-4 m2/s2.
class WindDrivenColumn {
 public:
  /// @param stress  F at the reference depth's column, as a function of hours after the epoch
  WindDrivenColumn(const ColumnPhysics& physics, double first_h, double last_h,
                   const std::function<Horizontal(double hours)>& stress);

  /// Velocity at the height fraction depth/H in [0, 1] of water `water_depth_m` deep, driven by F:
  /// the reference response times reference_depth/H. Cubic in time and depth between tabulated
  /// values.
  [[nodiscard]] Horizontal velocity(double water_depth_m, double depth_m,
                                    double hours) const noexcept;

 private:
  double first_h_ = 0;
  double reference_depth_m_ = 0;
  std::size_t times_ = 0;
  std::vector<Horizontal> table_;  ///< times x depth fractions
};

}  // namespace slackwater::api

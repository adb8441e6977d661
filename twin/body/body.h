#pragma once
#include <array>
#include <cstddef>

#include "twin/body/floating_hull.h"

namespace slackwater::twin {

inline constexpr std::size_t most_stations = 8;

inline constexpr std::size_t most_cross_flow_strips = 20;

/// Lift of body and fixed fins with the speed ahead, named as by SNAME and with its signs: kg/m, kg
/// and kg m.
struct SpeedLift {
  bool is_there = false;
  double y_uv = 0, y_ur = 0, n_uv = 0, n_ur = 0;
  double z_uw = 0, z_uq = 0, m_uw = 0, m_uq = 0;
  double k_up = 0;
  /// The source of these numbers has no moment of the added mass in a flow from aside (Munk), nor
  /// what belongs to it: see `munk_taken_off`.
  bool without_munk = false;
};

/// Drag of the cross-flow, strip by strip along the hull, with its rotation: rho/2 C_d times the
/// area of a strip.
struct CrossFlow {
  bool is_there = false;
  std::size_t strips = 0;
  std::array<double, most_cross_flow_strips> x_m{};
  std::array<double, most_cross_flow_strips> sway_n_s2_m2{};
  std::array<double, most_cross_flow_strips> heave_n_s2_m2{};
};

/// Resistance along one axis against motion along another. Positive opposes, as on the diagonal.
struct CrossDamping {
  bool is_there = false;
  SpatialMatrix linear;                       ///< D without its diagonal
  double y_r = 0, n_v = 0, z_q = 0, m_w = 0;  ///< of the motion times its size
};

/// A rigid body in a fluid, in body axes (forward, right, down) about the body's origin. All signs
/// are those of one convention: masses and dampings are positive.
struct Body {
  double mass_kg = 0;
  Triple<double> centre_of_gravity_m;
  double displaced_volume_m3 = 0;
  Triple<double> centre_of_buoyancy_m;
  SpatialMatrix rigid_mass;           ///< M_RB
  SpatialMatrix added_mass;           ///< M_A
  SpatialMatrix inverse_mass;         ///< (M_RB + M_A)^-1
  Spatial<double> linear_damping;     ///< diagonal of D, N s/m and N m s
  Spatial<double> quadratic_damping;  ///< diagonal of D|nu|, N s2/m2 and N m s2
  /// Where a hull under way leaves the water that it has pushed aside, and the two-dimensional
  /// added mass there.
  double trailing_edge_x_m = 0;
  double trailing_edge_kg_m = 0;
  /// Where along the hull the water is met, for drag in sheared water; shares of one.
  std::size_t stations = 1;
  std::array<Triple<double>, most_stations> station_m{};
  double fluid_density_kg_m3 = 0;
  double height_m = 0;  ///< of the hull, for its coming out of the water
  double radius_m = 0;  ///< of the upright cylinder about its length and width
  FloatingHull hull;    ///< of a surface craft, which displaces no water of its own beside
  SpeedLift speed_lift;
  CrossFlow cross_flow;
  CrossDamping cross_damping;

  /// Whether it feels more than every body does; see lift_and_cross_flow.h.
  [[nodiscard]] bool has_more() const noexcept {
    return speed_lift.is_there || cross_flow.is_there || cross_damping.is_there;
  }
};

/// What a body feels of the fluid around its centre of buoyancy, NED.
template <typename Real>
struct FluidMotion {
  Triple<Real> velocity_m_s;       ///< current and orbital motion, or wind
  Triple<Real> acceleration_m_s2;  ///< Du/Dt of the water
  Triple<Real> shear_per_s;        ///< change of velocity with depth
  Real elevation_m{};              ///< of the surface above still water
};

/// Position from the site's origin (NED, z down from mean sea level), attitude and velocity in body
/// axes.
template <typename Real>
struct BodyState {
  Triple<Real> position_m;
  Attitude<Real> attitude;
  Spatial<Real> nu;
};

}  // namespace slackwater::twin

#pragma once
#include "fields/base/constants.h"
#include "fields/base/numbers/real.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// The unit vector; shorter for what is next to nothing.
template <typename Real>
[[nodiscard]] Triple<Real> direction_of(const Triple<Real>& a) {
  return (1.0 / square_root(dot(a, a) + 1e-12)) * a;
}

/// What a node bears for its share of the line.
template <typename Real>
struct NodeLoad {
  Triple<Real> along;  ///< unit
  Triple<Real> force_n;
  Real mass_along_kg{};
  Real mass_across_kg{};      ///< with the water that is carried along (added mass rho A, cylinder)
  Real damping_along_kg_s{};  ///< slope of the drag
  Real damping_across_kg_s{};
};

/// Drag and weight in water of `length_m` of line about one point:
///
///   f = rho d/2 (C_n |u_n| u_n + C_t |u_t| u_t) l + (m g - rho A g) l,
///
/// with u = water - line, n across and t along the line.
///
/// Sources: Morison's equation with the cross-flow principle, DNV-RP-C205 (2010) 6.2.2; Driscoll,
/// Lueck and Nahon, Applied Ocean Research 22 (2000) 169-182, for lines of lumped mass.
template <typename Real>
[[nodiscard]] NodeLoad<Real> load_of(const Tether& tether, const Triple<Real>& along,
                                     const Real& length_m, const Real& down_m,
                                     const Triple<Real>& relative_m_s, const Real& elevation_m) {
  constexpr double surface_m = 0.2;  // over which line goes under, so that the force has no jump
  const Real wet =
      smaller_of(larger_of((down_m + elevation_m) / surface_m + 0.5, Real{} + 0.0), Real{} + 1.0);
  const Real wet_length_m = wet * length_m;
  const double water_kg_m =
      tether.water_density_kg_m3 * (constants::pi / 4) * tether.diameter_m * tether.diameter_m;
  const double drag = 0.5 * tether.water_density_kg_m3 * tether.diameter_m;
  const Real slip = dot(along, relative_m_s);
  const Triple<Real> across = relative_m_s - slip * along;
  const Real normal = (drag * tether.normal_drag_coefficient) * (wet_length_m * length_of(across));
  const Real tangential =
      (drag * tether.tangential_drag_coefficient) * (wet_length_m * absolute(slip));
  const Real mass_kg = tether.mass_per_m_kg * length_m;
  const Real displaced_kg = water_kg_m * wet_length_m;
  NodeLoad<Real> load;
  load.along = along;
  load.force_n = normal * across + (tangential * slip) * along;
  load.force_n.z = load.force_n.z + constants::gravity_m_s2 * (mass_kg - displaced_kg);
  load.mass_along_kg = mass_kg;
  load.mass_across_kg = mass_kg + displaced_kg;
  load.damping_along_kg_s = 2.0 * tangential;
  load.damping_across_kg_s = 2.0 * normal;
  return load;
}

/// How a node yields to an impulse within a step.
template <typename Real>
struct Yield {
  Triple<Real> along;
  Real along_per_kg{};
  Real across_per_kg{};

  [[nodiscard]] Triple<Real> to(const Triple<Real>& impulse_n_s) const {
    return across_per_kg * impulse_n_s +
           ((along_per_kg - across_per_kg) * dot(along, impulse_n_s)) * along;
  }
};

/// Drag grows with the motion that a step brings. With its slope in the inertia (implicit Euler,
/// one Newton iteration) a light line in a strong current can be stepped at the vehicle's pace.
template <typename Real>
[[nodiscard]] Yield<Real> yield_of(const NodeLoad<Real>& load, const Real& held_kg, double dt_s) {
  return {load.along, 1.0 / (load.mass_along_kg + dt_s * load.damping_along_kg_s + held_kg),
          1.0 / (load.mass_across_kg + dt_s * load.damping_across_kg_s + held_kg)};
}

}  // namespace slackwater::twin

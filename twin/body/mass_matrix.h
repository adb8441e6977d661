#pragma once
#include <array>
#include <optional>

#include "twin/body/spatial.h"

namespace slackwater::twin {

/// Symmetric, about the centre of gravity, in axes parallel to the body's, kg m2. Products of
/// inertia are the entries of the matrix: `xy` = -integral of x y dm.
struct Inertia {
  double xx = 0;
  double yy = 0;
  double zz = 0;
  double xy = 0;
  double xz = 0;
  double yz = 0;
};

/// M_RB about the body's origin of a mass whose centre of gravity is elsewhere. Fossen (2011),
/// 3.27.
[[nodiscard]] SpatialMatrix rigid_mass_matrix(double mass_kg, const Inertia& inertia,
                                              const Triple<double>& centre_of_gravity_m);

[[nodiscard]] SpatialMatrix sum_of(const SpatialMatrix& a, const SpatialMatrix& b);

/// Nothing where the matrix is not symmetric and positive definite: such a body would gain energy
/// by being slowed.
[[nodiscard]] std::optional<SpatialMatrix> inverse_of(const SpatialMatrix& mass);

/// The three principal moments, ascending.
[[nodiscard]] std::array<double, 3> principal_moments(const Inertia& inertia);

}  // namespace slackwater::twin

#pragma once
#include <array>

#include "twin/body/attitude.h"

namespace slackwater::twin {

/// A velocity (m/s, rad/s) or a force (N, N m), in body axes about the body's origin.
template <typename Real>
struct Spatial {
  Triple<Real> linear;
  Triple<Real> angular;

  friend Spatial operator+(const Spatial& a, const Spatial& b) {
    return {a.linear + b.linear, a.angular + b.angular};
  }
  friend Spatial operator-(const Spatial& a, const Spatial& b) {
    return {a.linear - b.linear, a.angular - b.angular};
  }
  friend Spatial operator*(const Real& s, const Spatial& a) {
    return {s * a.linear, s * a.angular};
  }
};

/// The same force acting at a point: with its moment about the origin.
template <typename Real>
[[nodiscard]] Spatial<Real> force_at(const Triple<Real>& point_m, const Triple<Real>& force_n) {
  return {force_n, cross(point_m, force_n)};
}

/// A mass matrix or its inverse, rows and columns in the order u v w p q r.
struct SpatialMatrix {
  std::array<std::array<double, 6>, 6> entry{};
  friend bool operator==(const SpatialMatrix&, const SpatialMatrix&) = default;
};

template <typename Real>
[[nodiscard]] Spatial<Real> operator*(const SpatialMatrix& m, const Spatial<Real>& v) {
  const auto row = [&](std::size_t i) -> Real {
    const auto& e = m.entry[i];
    return (e[0] * v.linear.x + e[1] * v.linear.y + e[2] * v.linear.z) +
           (e[3] * v.angular.x + e[4] * v.angular.y + e[5] * v.angular.z);
  };
  return {{row(0), row(1), row(2)}, {row(3), row(4), row(5)}};
}

/// C(nu) nu of a symmetric mass matrix, by Kirchhoff's equations: with (p, h) = M nu,
///
///   C(nu) nu = (w x p,  w x h + v x p)
///
/// which does no work, nu . C(nu) nu = 0, whatever M. Fossen (2011), theorem 3.2 and 6.5.1.
template <typename Real>
[[nodiscard]] Spatial<Real> coriolis(const SpatialMatrix& mass, const Spatial<Real>& nu) {
  const Spatial<Real> momentum = mass * nu;
  return {cross(nu.angular, momentum.linear),
          cross(nu.angular, momentum.angular) + cross(nu.linear, momentum.linear)};
}

/// What it costs to stop: nu . M nu / 2, J.
template <typename Real>
[[nodiscard]] Real kinetic_energy_j(const SpatialMatrix& mass, const Spatial<Real>& nu) {
  const Spatial<Real> momentum = mass * nu;
  return 0.5 * (dot(nu.linear, momentum.linear) + dot(nu.angular, momentum.angular));
}

}  // namespace slackwater::twin

#include "twin/body/mass_matrix.h"

#include <Eigen/Dense>

namespace slackwater::twin {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

Matrix6 eigen_of(const SpatialMatrix& m) {
  Matrix6 out;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out(i, j) = m.entry[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return out;
}

SpatialMatrix spatial_of(const Matrix6& m) {
  SpatialMatrix out;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      out.entry[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = m(i, j);
  return out;
}

Eigen::Matrix3d eigen_of(const Inertia& i) {
  Eigen::Matrix3d out;
  out << i.xx, i.xy, i.xz, i.xy, i.yy, i.yz, i.xz, i.yz, i.zz;
  return out;
}

}  // namespace

SpatialMatrix rigid_mass_matrix(double mass_kg, const Inertia& inertia,
                                const Triple<double>& centre_of_gravity_m) {
  const Triple<double>& g = centre_of_gravity_m;
  Eigen::Matrix3d s;  // s v = g x v
  s << 0, -g.z, g.y, g.z, 0, -g.x, -g.y, g.x, 0;
  Matrix6 m;
  m.topLeftCorner<3, 3>() = mass_kg * Eigen::Matrix3d::Identity();
  m.topRightCorner<3, 3>() = -mass_kg * s;
  m.bottomLeftCorner<3, 3>() = mass_kg * s;
  m.bottomRightCorner<3, 3>() = eigen_of(inertia) - mass_kg * s * s;
  return spatial_of(m);
}

SpatialMatrix sum_of(const SpatialMatrix& a, const SpatialMatrix& b) {
  return spatial_of(eigen_of(a) + eigen_of(b));
}

std::optional<SpatialMatrix> inverse_of(const SpatialMatrix& mass) {
  const Matrix6 m = eigen_of(mass);
  if (!m.allFinite() || !m.isApprox(m.transpose(), 1e-12)) return std::nullopt;
  const Eigen::LLT<Matrix6> factor(m);
  if (factor.info() != Eigen::Success) return std::nullopt;
  const Matrix6 inverse = factor.solve(Matrix6::Identity());
  return spatial_of(0.5 * (inverse + inverse.transpose()));
}

std::array<double, 3> principal_moments(const Inertia& inertia) {
  const Eigen::Vector3d moments =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(eigen_of(inertia), Eigen::EigenvaluesOnly)
          .eigenvalues();
  return {moments[0], moments[1], moments[2]};
}

}  // namespace slackwater::twin

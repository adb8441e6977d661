#pragma once
#include "fields/base/numbers/real.h"

namespace slackwater::twin {

// Formulas of the step are written once over `Real`: double for one vehicle, eight lanes for many
// (fields/base/numbers/lanes.h).

/// Three components; the frame is said by the name of the variable.
template <typename Real>
struct Triple {
  Real x{};
  Real y{};
  Real z{};

  bool operator==(const Triple&) const = default;

  friend Triple operator+(const Triple& a, const Triple& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
  }
  friend Triple operator-(const Triple& a, const Triple& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
  }
  friend Triple operator*(const Real& s, const Triple& a) { return {s * a.x, s * a.y, s * a.z}; }
};

template <typename Real>
[[nodiscard]] Triple<Real> cross(const Triple<Real>& a, const Triple<Real>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <typename Real>
[[nodiscard]] Real dot(const Triple<Real>& a, const Triple<Real>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Real>
[[nodiscard]] Real length_of(const Triple<Real>& a) {
  return square_root(dot(a, a));
}

/// Unit quaternion that turns body (forward, right, down) into NED (Fossen 2011, 2.2.2).
template <typename Real>
struct Attitude {
  Real w{};
  Real x{};
  Real y{};
  Real z{};
};

/// The rows of R, body to NED: v_ned = R v_body.
template <typename Real>
struct Rotation {
  Triple<Real> north;
  Triple<Real> east;
  Triple<Real> down;

  [[nodiscard]] Triple<Real> to_ned(const Triple<Real>& body) const {
    return {dot(north, body), dot(east, body), dot(down, body)};
  }
  [[nodiscard]] Triple<Real> to_body(const Triple<Real>& ned) const {
    return ned.x * north + ned.y * east + ned.z * down;
  }
};

template <typename Real>
[[nodiscard]] Rotation<Real> rotation_of(const Attitude<Real>& q) {
  const Real xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const Real xy = q.x * q.y, xz = q.x * q.z, yz = q.y * q.z;
  const Real wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  return {{1.0 - 2.0 * (yy + zz), 2.0 * (xy - wz), 2.0 * (xz + wy)},
          {2.0 * (xy + wz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz - wx)},
          {2.0 * (xz - wy), 2.0 * (yz + wx), 1.0 - 2.0 * (xx + yy)}};
}

/// dq/dt for a rate of turn in body axes, rad/s.
template <typename Real>
[[nodiscard]] Attitude<Real> rate_of(const Attitude<Real>& q, const Triple<Real>& rate_rad_s) {
  const Triple<Real>& w = rate_rad_s;
  return {-0.5 * (q.x * w.x + q.y * w.y + q.z * w.z), 0.5 * (q.w * w.x + q.y * w.z - q.z * w.y),
          0.5 * (q.w * w.y + q.z * w.x - q.x * w.z), 0.5 * (q.w * w.z + q.x * w.y - q.y * w.x)};
}

template <typename Real>
[[nodiscard]] Attitude<Real> normalised(const Attitude<Real>& q) {
  const Real s = 1.0 / square_root(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// Roll, pitch, yaw (zyx), for people, logs and autopilots. rad; yaw clockwise from north.
struct EulerAngles {
  double roll_rad = 0;
  double pitch_rad = 0;
  double yaw_rad = 0;
};
[[nodiscard]] EulerAngles euler_angles(const Attitude<double>& attitude) noexcept;
[[nodiscard]] Attitude<double> attitude_of(const EulerAngles& angles) noexcept;

}  // namespace slackwater::twin

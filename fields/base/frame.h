#pragma once
#include <Eigen/Core>
#include <complex>

#include "fields/base/angle.h"

namespace slackwater {

struct Enu {};  ///< east, north, up at the site origin
struct Ned {};  ///< north, east, down

/// A vector that knows its frame; adding two frames does not compile.
template <typename Frame>
class Vector3 {
 public:
  Vector3() = default;
  Vector3(double x, double y, double z) : value_(x, y, z) {}
  explicit Vector3(const Eigen::Vector3d& value) : value_(value) {}
  [[nodiscard]] const Eigen::Vector3d& eigen() const noexcept { return value_; }
  [[nodiscard]] double x() const noexcept { return value_.x(); }
  [[nodiscard]] double y() const noexcept { return value_.y(); }
  [[nodiscard]] double z() const noexcept { return value_.z(); }
  [[nodiscard]] double norm() const noexcept { return value_.norm(); }
  friend Vector3 operator+(const Vector3& a, const Vector3& b) {
    return Vector3(a.value_ + b.value_);
  }
  friend Vector3 operator-(const Vector3& a, const Vector3& b) {
    return Vector3(a.value_ - b.value_);
  }
  friend Vector3 operator*(double s, const Vector3& a) { return Vector3(s * a.value_); }

 private:
  Eigen::Vector3d value_ = Eigen::Vector3d::Zero();
};

/// ENU and NED share the origin; the conversions are each other's inverse.
[[nodiscard]] inline Vector3<Ned> to_ned(const Vector3<Enu>& v) { return {v.y(), v.x(), -v.z()}; }
[[nodiscard]] inline Vector3<Enu> to_enu(const Vector3<Ned>& v) { return {v.y(), v.x(), -v.z()}; }

/// A horizontal vector as a complex number, east + i north: rotations are multiplications.
using Horizontal = std::complex<double>;
/// The level part.
[[nodiscard]] inline Horizontal horizontal_of(const Vector3<Enu>& v) { return {v.x(), v.y()}; }

/// Direction that a current flows *to*, clockwise from true north, in [0, 360).
[[nodiscard]] double to_direction_deg(Horizontal velocity) noexcept;
/// Direction that a wind or wave comes *from*, clockwise from true north, in [0, 360).
[[nodiscard]] double from_direction_deg(Horizontal velocity) noexcept;
/// The vector of a wind or wave that comes from this direction.
[[nodiscard]] Horizontal vector_from_direction(double magnitude,
                                               double from_direction_deg) noexcept;
/// The vector of a current that flows to this direction.
[[nodiscard]] Horizontal vector_to_direction(double magnitude, double to_direction_deg) noexcept;

}  // namespace slackwater

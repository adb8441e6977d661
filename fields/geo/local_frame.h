#pragma once
#include <memory>

#include "fields/base/frame.h"
#include "fields/geo/geo_point.h"

namespace slackwater {

/// The tangent frame ENU at a site's origin, WGS 84, through PROJ's `topocentric` operation.
///
/// The plane leaves the ellipsoid by about d^2/(2R), 5.8 m at 8.6 km: take depths and heights from
/// mean sea level along the local vertical, never from the plane's z (fields/docs/conventions.md).
/// One object per thread.
class LocalFrame {
 public:
  explicit LocalFrame(const GeoPoint& origin);
  ~LocalFrame();
  LocalFrame(LocalFrame&&) noexcept;
  LocalFrame& operator=(LocalFrame&&) noexcept;

  [[nodiscard]] const GeoPoint& origin() const noexcept;
  /// Position of a point `height_m` above the ellipsoid, metres east, north, up of the origin.
  [[nodiscard]] Vector3<Enu> to_local(const GeoPoint& point, double height_m = 0) const;
  struct Geodetic {
    GeoPoint point;
    double height_m = 0;
  };
  [[nodiscard]] Geodetic to_geodetic(const Vector3<Enu>& position) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slackwater

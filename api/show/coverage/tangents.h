#pragma once
#include <Eigen/Geometry>
#include <vector>

#include "api/show/coverage/view.h"

namespace slackwater::api {

[[nodiscard]] inline double dot(const Vector3<Enu>& a, const Vector3<Enu>& b) {
  return a.eigen().dot(b.eigen());
}
[[nodiscard]] inline Vector3<Enu> cross(const Vector3<Enu>& a, const Vector3<Enu>& b) {
  return Vector3<Enu>(a.eigen().cross(b.eigen()));
}

/// What a metre on the sheet is in space: how places go with along and down over some patches, by
/// least squares.
struct SheetTangents {
  Vector3<Enu> along{0, 0, 0};
  Vector3<Enu> down{0, 0, 0};
  /// Of three patches and more that are not in a line; a sheet is about as long as its surface, so
  /// that patches about an edge between parts have none.
  bool is_known = false;
};
[[nodiscard]] SheetTangents tangents_of(const std::vector<const CoveragePatch*>& patches);

/// Where on the sheet something at this place belongs: on the nearest patch, by the tangents there.
struct SheetPlace {
  double along_m = 0;
  double down_m = 0;
  Vector3<Enu> normal{0, 0, 0};  ///< of the surface there
};
/// Of a surface with patches.
[[nodiscard]] SheetPlace sheet_place(const InspectionCoverage& coverage,
                                     const Vector3<Enu>& place_m);

}  // namespace slackwater::api

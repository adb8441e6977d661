#pragma once
#include <array>
#include <string>
#include <vector>

#include "api/show/coverage/marks.h"
#include "api/show/coverage/view.h"

namespace slackwater::api {

/// A piece of a surface in space: patches that lie together on the sheet, as one flat quad.
struct CoverageQuad {
  std::array<Vector3<Enu>, 4> corners_m;
  Vector3<Enu> centre_m{0, 0, 0};
  Vector3<Enu> normal{0, 0, 0};  ///< unit, outward
  double area_m2 = 0;
  PatchState state{};  ///< of most of its area
};

/// The patches gathered into at most about `most` quads.
[[nodiscard]] std::vector<CoverageQuad> quads_of(const InspectionCoverage& coverage,
                                                 std::size_t most);

inline constexpr std::size_t still_quads = 2000;

/// The surface in space, as an SVG element: seen in parallel from 25 degrees above, from the side
/// on which most was looked at, and from the other one too where much of it lies behind. With
/// north, a scale and the level of the sea where that is near. Quads are drawn the farthest first.
[[nodiscard]] std::string still_svg(const InspectionCoverage& coverage,
                                    const std::vector<CoverageMark>& marks);

}  // namespace slackwater::api

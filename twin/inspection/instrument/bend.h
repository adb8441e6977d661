#pragma once
#include <cstdint>

#include "twin/inspection/instrument/view_index.h"

namespace slackwater::twin {

/// How a surface bends at a place: its normal n turns by dn = k1 e1 (e1 . dx) + k2 e2 (e2 . dx) as
/// one goes dx over it. Flat where nothing is set.
struct Bend {
  Triple<double> normal;    ///< unit, outward
  Triple<double> first;     ///< e1: unit, over the surface, the way in which it bulges most
  Triple<double> second;    ///< e2: square to it
  double first_per_m = 0;   ///< k1: one over the radius, above 0 where it bulges outward
  double second_per_m = 0;  ///< k2
};

/// That of a surface about a patch: the least squares of what the normals of its neighbours say,
/// those within 1.6 of its longer side that go on from it without an edge of 60 degrees. Exact for
/// a prism that stands for a cylinder, but for R cos(half of a facet's angle) in the place of R.
/// Flat where it has no neighbours. No allocation.
[[nodiscard]] Bend bend_at(const Surface& surface, const ViewIndex& index, std::uint32_t patch);

}  // namespace slackwater::twin

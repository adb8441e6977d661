#pragma once
#include <cstdint>
#include <vector>

#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

/// The patches of a surface in blocks of neighbours, so that a look passes by what is far from its
/// footprint without a glance at each patch. Made once for a surface.
struct ViewIndex {
  struct Block {
    Triple<double> centre_m;  ///< NED of the run
    double radius_m = 0;      ///< of a ball that holds the patches' centres
    std::uint32_t first = 0;  ///< in `patches`
    std::uint32_t end = 0;
  };
  std::vector<std::uint32_t> patches;
  std::vector<Block> blocks;
};

/// Halves the surface across its longest side until no more than 32 patches are left of it.
[[nodiscard]] ViewIndex view_index(const Surface& surface);

}  // namespace slackwater::twin

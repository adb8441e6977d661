#pragma once
#include <cstddef>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::tests {

struct MadeUpInspection {
  std::size_t columns = 72;  ///< of the pile's patches
  std::size_t rows = 70;
  bool has_bed = true;  ///< a flat bed under a multibeam beside the pile
};

/// A log of one ROV about a pile of 6 m at the origin, in 35 m of water, from which the shares are
/// known: rows of patches of the upper 60 % of the depth are covered, those down to 80 % seen at
/// too coarse a detail, the rest not seen; on the bed the western half is covered. The pile has two
/// true findings, a false alarm and three that were missed, each for its own reason.
[[nodiscard]] ingest::TrajectoryFile made_up_inspection(const MadeUpInspection& how = {});

}  // namespace slackwater::tests

#pragma once
#include <span>
#include <string>

#include "fields/wave/sea_state.h"

namespace slackwater {

/// A sea that somebody made up, for a scenario. It must be one that can exist: every partition, and
/// the total at the period of its highest peak, stays below `steepest_height_m` (growth.h).
///
/// Throws Error(invalid_input), with what was found, the limit and what would do, for a sea that is
/// too steep, a height below 0 or not finite, a period that is not above 0, a gamma outside [1,
/// 10], an s outside [0, 1000], a direction outside [-360, 360]; `what` names the sea in the
/// message.
[[nodiscard]] PartitionedSea scenario_sea(std::span<const WavePartition> partitions,
                                          const std::string& what);

}  // namespace slackwater

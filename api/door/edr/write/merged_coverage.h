#pragma once
#include "api/door/edr/sample/answer.h"
#include "ingest/cf/forecast/sampled_file_writer.h"

namespace slackwater::api::edr {

/// All coverages of an answer (one at least) as the arrays of one CF file: points, series and
/// profiles over stations (a place is one station), grids over the union of their axes,
/// trajectories one after the other. What no coverage speaks of is missing.
///
/// Throws Error(usage) where the union of the axes would be mostly empty: more than 16 times the
/// points of the coverages and more than 2^20.
[[nodiscard]] ingest::SampledFile merged_coverage(const Answer& answer);

}  // namespace slackwater::api::edr

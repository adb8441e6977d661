#pragma once
#include <cstddef>
#include <span>

#include "fields/grid/status.h"

namespace slackwater::ingest {

/// How many whole ensembles of a current profiler were rejected, and why.
struct EnsembleReport {
  std::size_t broken = 0;  ///< a quarter or more of the bins failed: what the others say is luck
  std::size_t zeros = 0;   ///< every bin exactly (0, 0): padding of a record that is not there
  std::size_t zero_bins =
      0;  ///< single bins of three or more adjacent exact zeros in other ensembles
};

/// Rejects what a profiler's ensembles say as wholes (one ensemble = all bins of one time; all bins
/// come from the same pings, the same compass and the same record, so they fail together).
///
/// 1. Broken: of the bins that held a value before the tests, at least a quarter (and at least two)
/// are suspect now.
///    The rest of the ensemble becomes suspect too.
/// 2. Exact zeros: both components exactly 0 in every bin, or in three adjacent bins. Water is
/// never that still in
///    the last bit of the instrument; a record that was not written reads so. A calm that is none
///    would be the most dangerous number.
///
/// Arrays are row-major (time, bin). `before` is the status (of either component) before the range
/// and spike tests: it says which bins held a value.
EnsembleReport test_ensembles(std::size_t bins, std::span<const float> east,
                              std::span<const float> north, std::span<const SampleStatus> before,
                              std::span<SampleStatus> east_status,
                              std::span<SampleStatus> north_status);

}  // namespace slackwater::ingest

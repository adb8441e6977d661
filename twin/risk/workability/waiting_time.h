#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/base/constants.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// How long one waits, from every step of some, for the next workable start. In hours; NaN where
/// no wait is known.
struct WaitingTime {
  std::size_t counted = 0;   ///< steps with a start at or after them
  std::size_t censored = 0;  ///< steps without: left out of the figures
  double mean_h = constants::nan;
  double p10_h = constants::nan;
  double p50_h = constants::nan;
  double p80_h = constants::nan;
  double p90_h = constants::nan;
};

/// Waits that run down together: over the steps of a stretch without a start they are
/// high, high - 1, ..., low, each once.
struct RunOfWaits {
  std::size_t low = 1;
  std::size_t high = 1;
};

/// The waits over some steps, as runs: a run a gap, not a number a step.
struct Waits {
  std::vector<RunOfWaits> runs;
  std::size_t none = 0;      ///< steps that are a start themselves
  std::size_t censored = 0;  ///< steps without a start at or after them
};

/// Adds the waits of the steps of `range`, each to the first start at or after it, be it inside the
/// range or behind it.
/// @param starts  all workable starts of the series
/// @param next    index of a start range that ends no later than any that concerns the range: 0,
///                or what the call for an earlier range returned
/// @return `next` for a later range
std::size_t add_waits(const StepRange& range, const StepRanges& starts, std::size_t next,
                      Waits& waits);

/// Turns waits into figures: counts how often each wait occurs, so that nothing is sorted.
/// Keeps its room between calls. Not thread-safe.
class WaitingTimes {
 public:
  /// @param parts  the waits of steps that belong together, e.g. of all Januaries
  [[nodiscard]] WaitingTime of(const std::vector<const Waits*>& parts, double step_h);

 private:
  std::vector<std::int64_t> change_;  ///< of the number of occurrences, from one wait to the next
};

}  // namespace slackwater::twin

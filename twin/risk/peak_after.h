#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "twin/risk/start_steps.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// The largest (or smallest) value of some steps, and the first step that has it.
struct Peak {
  double value = 0;
  std::optional<std::size_t> step;  ///< of the grid; absent: none of them is a number
};

/// The peak after each start over the steps at which something counts. Values that are no numbers
/// are passed over. One pass for each stretch, by a queue of falling values.
/// @param when   steps after that of the start, ascending
/// @param upper  the largest, else the smallest
[[nodiscard]] std::vector<Peak> peaks_after(std::span<const double> values, const StepRanges& when,
                                            const StartSteps& starts, bool upper);

}  // namespace slackwater::twin

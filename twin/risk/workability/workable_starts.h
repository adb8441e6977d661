#pragma once
#include <cstddef>

#include "fields/base/time.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// How many steps a time takes, the last one whole: ceil(needed / step).
/// @param needed  duration and contingency, more than 0
/// @throws ContractViolation for a step or a time of 0 and less
[[nodiscard]] std::size_t steps_needed(Duration needed, Duration step);

/// Steps t such that [t, t + needed) lies wholly inside a window. A window of n steps has
/// n - needed + 1 of them, or none.
/// @param windows  maximal runs of accessible steps
/// @param needed   steps, 1 at least
/// Source: twin/docs/operations.md, section 3, "Workable start".
[[nodiscard]] StepRanges workable_starts(const StepRanges& windows, std::size_t needed);

}  // namespace slackwater::twin

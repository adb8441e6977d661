#include "twin/risk/workability/workable_starts.h"

#include "fields/base/check.h"

namespace slackwater::twin {

std::size_t steps_needed(Duration needed, Duration step) {
  expects(needed > Duration(0) && step > Duration(0), "a task takes time, and so does a step");
  return static_cast<std::size_t>((needed + step - Duration(1)) / step);
}

StepRanges workable_starts(const StepRanges& windows, std::size_t needed) {
  expects(needed > 0, "a task takes one step at least");
  StepRanges starts;
  for (const StepRange& window : windows)
    if (window.steps() >= needed) starts.push_back({window.begin, window.end - needed + 1});
  return starts;
}

}  // namespace slackwater::twin

#include "twin/risk/peak_after.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

std::vector<Peak> peaks_after(std::span<const double> values, const StepRanges& when,
                              const StartSteps& starts, bool upper) {
  std::vector<Peak> peaks(starts.count);
  const auto is_beyond = [&](double a, double b) { return upper ? a > b : a < b; };
  std::vector<std::size_t> queue;  // steps whose value nothing after them surpasses
  for (const StepRange& range : when) {
    queue.clear();
    std::size_t head = 0;
    std::size_t seen = 0;
    for (std::size_t s = 0; s < starts.count; ++s) {
      const std::size_t from = starts.step_of(s) + range.begin;
      const std::size_t to = std::min(starts.step_of(s) + range.end, values.size());
      for (seen = std::max(seen, from); seen < to; ++seen) {
        if (std::isnan(values[seen])) continue;
        while (queue.size() > head && is_beyond(values[seen], values[queue.back()]))
          queue.pop_back();
        queue.push_back(seen);
      }
      while (head < queue.size() && queue[head] < from) ++head;
      if (head == queue.size()) continue;
      Peak& peak = peaks[s];
      const double value = values[queue[head]];
      if (!peak.step || is_beyond(value, peak.value)) peak = {value, queue[head]};
    }
  }
  return peaks;
}

}  // namespace slackwater::twin

#include "twin/risk/workability/step_range.h"

#include <algorithm>
#include <cstring>

namespace slackwater::twin {

StepRanges runs_of(std::span<const std::uint8_t> marks) {
  StepRanges runs;
  const std::uint8_t* const first = marks.data();
  // memchr looks at many bytes at once; a loop over them would decide at each.
  const auto next = [&](std::size_t from, int mark) {
    const void* found =
        from < marks.size() ? std::memchr(first + from, mark, marks.size() - from) : nullptr;
    return found == nullptr
               ? marks.size()
               : static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - first);
  };
  for (std::size_t begin = next(0, 1); begin < marks.size();) {
    const std::size_t end = next(begin, 0);
    runs.push_back({begin, end});
    begin = next(end, 1);
  }
  return runs;
}

StepRanges outside(const StepRanges& ranges, std::size_t steps) {
  StepRanges rest;
  std::size_t at = 0;
  for (const StepRange& range : ranges) {
    if (range.begin > at) rest.push_back({at, range.begin});
    at = range.end;
  }
  if (at < steps) rest.push_back({at, steps});
  return rest;
}

StepRanges common_to(const StepRanges& a, const StepRanges& b) {
  StepRanges both;
  for (auto i = a.begin(), j = b.begin(); i != a.end() && j != b.end();) {
    const std::size_t begin = std::max(i->begin, j->begin);
    const std::size_t end = std::min(i->end, j->end);
    if (begin < end) both.push_back({begin, end});
    if (i->end < j->end)
      ++i;
    else
      ++j;
  }
  return both;
}

std::size_t steps_in(const StepRanges& ranges) noexcept {
  std::size_t sum = 0;
  for (const StepRange& range : ranges) sum += range.steps();
  return sum;
}

}  // namespace slackwater::twin

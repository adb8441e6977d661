#include "twin/risk/workability/waiting_time.h"

#include <algorithm>
#include <array>

#include "fields/base/numbers/quantile.h"

namespace slackwater::twin {

std::size_t add_waits(const StepRange& range, const StepRanges& starts, std::size_t next,
                      Waits& waits) {
  std::size_t at = range.begin;
  while (next < starts.size() && starts[next].end <= at) ++next;
  for (std::size_t j = next; at < range.end; ++j) {
    if (j == starts.size()) {
      waits.censored += range.end - at;
      break;
    }
    const std::size_t begin = std::min(starts[j].begin, range.end);
    if (begin > at) {
      waits.runs.push_back({starts[j].begin - (begin - 1), starts[j].begin - at});
      at = begin;
    }
    const std::size_t end = std::min(starts[j].end, range.end);
    if (end > at) {
      waits.none += end - at;
      at = end;
    }
  }
  return next;
}

WaitingTime WaitingTimes::of(const std::vector<const Waits*>& parts, double step_h) {
  WaitingTime result;
  std::size_t longest = 0;
  std::size_t none = 0;
  std::int64_t sum = 0;  // of waits in steps: some 1e11 for a century of hours
  for (const Waits* part : parts) {
    none += part->none;
    result.counted += part->none;
    result.censored += part->censored;
    for (const RunOfWaits& run : part->runs) {
      const std::size_t count = run.high - run.low + 1;
      result.counted += count;
      sum += static_cast<std::int64_t>((run.low + run.high) * count / 2);
      longest = std::max(longest, run.high);
    }
  }
  if (result.counted == 0) return result;

  change_.assign(longest + 2, 0);
  change_[0] += static_cast<std::int64_t>(none);
  change_[1] -= static_cast<std::int64_t>(none);
  for (const Waits* part : parts) {
    for (const RunOfWaits& run : part->runs) {
      ++change_[run.low];
      --change_[run.high + 1];
    }
  }

  constexpr std::array<std::size_t, 4> percents{10, 50, 80, 90};
  const std::array<double*, 4> out{&result.p10_h, &result.p50_h, &result.p80_h, &result.p90_h};
  std::size_t q = 0;
  PercentilePlace place = percentile_place(result.counted, percents[0]);
  std::int64_t occurrences = 0;
  std::size_t up_to = 0;  // how many waits are no longer than `wait`
  for (std::size_t wait = 0; wait <= longest && q < percents.size(); ++wait) {
    occurrences += change_[wait];
    up_to += static_cast<std::size_t>(occurrences);
    while (q < percents.size() && place.below < up_to) {
      const double low = static_cast<double>(wait);
      double value = low;
      if (place.hundredths > 0 && place.below + 1 >= up_to) {
        std::size_t above = wait + 1;
        for (std::int64_t more = occurrences + change_[above]; more == 0; more += change_[above])
          ++above;
        value = place.between(low, static_cast<double>(above));
      }
      *out[q] = value * step_h;
      if (++q < percents.size()) place = percentile_place(result.counted, percents[q]);
    }
  }
  result.mean_h = static_cast<double>(sum) / static_cast<double>(result.counted) * step_h;
  return result;
}

}  // namespace slackwater::twin

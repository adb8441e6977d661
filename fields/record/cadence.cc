#include "fields/record/cadence.h"

#include <algorithm>

namespace slackwater {
namespace {

constexpr Duration shortest_gap = std::chrono::hours(12);

/// The wider of the pauses before and after the one that follows `times[i]`; 0 where there are
/// none.
Duration pause_beside(std::span<const UtcTime> times, std::size_t i) {
  Duration widest(0);
  if (i > 0) widest = times[i] - times[i - 1];
  if (i + 2 < times.size()) widest = std::max(widest, times[i + 2] - times[i + 1]);
  return widest;
}

}  // namespace

bool is_hole(std::span<const UtcTime> times, std::size_t i) {
  const Duration beside = pause_beside(times, i);
  return beside > Duration(0) && 2 * (times[i + 1] - times[i]) > 5 * beside;
}

bool may_interpolate(std::span<const UtcTime> times, std::size_t i) {
  return times[i + 1] - times[i] <= std::max(shortest_gap, 5 * pause_beside(times, i) / 4);
}

bool hangs_on(std::span<const UtcTime> times, std::size_t i) {
  return !is_hole(times, i - 1) && may_interpolate(times, i - 1);
}

std::vector<TimeSpan> whole_parts(
    std::span<const UtcTime> times,
    const std::function<bool(UtcTime after, UtcTime before)>& is_cut) {
  std::vector<TimeSpan> parts;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (i == 0 || !hangs_on(times, i) || (is_cut && is_cut(times[i - 1], times[i])))
      parts.push_back({times[i], times[i]});
    parts.back().to = times[i];
  }
  return parts;
}

void TakenTime::take(const TimeSpan& span) {
  TimeSpan whole = span;
  std::vector<TimeSpan> spans;
  for (const TimeSpan& other : spans_) {
    if (other.to < whole.from || other.from > whole.to) {
      spans.push_back(other);
      continue;
    }
    whole = {std::min(whole.from, other.from), std::max(whole.to, other.to)};
  }
  const auto place =
      std::lower_bound(spans.begin(), spans.end(), whole.from,
                       [](const TimeSpan& other, UtcTime from) { return other.from < from; });
  spans.insert(place, whole);
  spans_ = std::move(spans);
}

bool TakenTime::holds(UtcTime time) const {
  const auto after =
      std::upper_bound(spans_.begin(), spans_.end(), time,
                       [](UtcTime wanted, const TimeSpan& span) { return wanted < span.from; });
  return after != spans_.begin() && time <= std::prev(after)->to;
}

bool TakenTime::reaches_into(UtcTime from, UtcTime to) const {
  return std::any_of(spans_.begin(), spans_.end(),
                     [&](const TimeSpan& span) { return span.from < to && span.to > from; });
}

}  // namespace slackwater

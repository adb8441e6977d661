#pragma once
#include <functional>
#include <span>
#include <vector>

#include "fields/base/time.h"

namespace slackwater {

/// Whether the pause after `times[i]` is a hole in a series and not its usual step: more than two
/// and a half times the wider of the pauses beside it. A series may change its cadence.
/// @param times  ascending; i + 1 is inside
[[nodiscard]] bool is_hole(std::span<const UtcTime> times, std::size_t i);

/// Whether the pause after `times[i]` may be crossed on a line: at most 12 h, or one and a quarter
/// times the wider of the pauses beside it, so that no single value of a six-hourly series is
/// missed and a twelve-hourly series has no gaps.
[[nodiscard]] bool may_interpolate(std::span<const UtcTime> times, std::size_t i);

/// Whether `times[i]` hangs together with the one before it: neither a hole nor a pause that may
/// not be interpolated lies in between.
[[nodiscard]] bool hangs_on(std::span<const UtcTime> times, std::size_t i);

/// From the first to the last value of a part of a series.
struct TimeSpan {
  UtcTime from;
  UtcTime to;
  bool operator==(const TimeSpan&) const = default;
};

/// The parts of a series that hang together.
/// @param is_cut  whether it is cut after one time and before the next all the same; empty: never
[[nodiscard]] std::vector<TimeSpan> whole_parts(
    std::span<const UtcTime> times,
    const std::function<bool(UtcTime after, UtcTime before)>& is_cut = {});

/// Time that is taken: spans joined where they overlap.
class TakenTime {
 public:
  void take(const TimeSpan& span);
  [[nodiscard]] bool holds(UtcTime time) const;
  /// Whether anything of (from, to) is taken.
  [[nodiscard]] bool reaches_into(UtcTime from, UtcTime to) const;

 private:
  std::vector<TimeSpan> spans_;  ///< ascending, apart
};

}  // namespace slackwater

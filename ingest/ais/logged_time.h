#pragma once
#include <optional>
#include <string_view>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// A time that a receiver's log puts before or behind a sentence.
struct LoggedTime {
  UtcTime clock{};
  bool states_zone = true;  ///< false: a date and a time of nobody knows which zone
};

/// The first time in what stands around a sentence:
///
///   2025-03-08T00:00:00.250Z   2025-03-08 01:00:00+01:00   2025/03/08 00:00:00 UTC
///   1741392000   1741392000.250   1741392000250             since 1970, seconds or milliseconds
///   timestamp: 20250308000000   "rxtime":"20250308000000"    AIS-catcher, UTC
///
/// Nothing where there is none, or one of a clock that was never set (before 1990, after 2100).
[[nodiscard]] std::optional<LoggedTime> logged_time_in(std::string_view text);

/// Nothing for a time of a clock that was never set.
[[nodiscard]] std::optional<UtcTime> believable_time(UtcTime time) noexcept;

}  // namespace slackwater::ingest

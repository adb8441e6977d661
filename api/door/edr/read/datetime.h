#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "fields/base/time.h"

namespace slackwater::api::edr {

/// What `datetime` asks for: an instant, or a closed interval; an end that is absent is open.
struct TimeRange {
  std::optional<UtcTime> from;
  std::optional<UtcTime> to;

  [[nodiscard]] bool is_instant() const noexcept { return from && to && *from == *to; }
  [[nodiscard]] bool contains(UtcTime time) const noexcept {
    return (!from || *from <= time) && (!to || time <= *to);
  }
  bool operator==(const TimeRange&) const = default;
};

/// Reads `datetime` of OGC API-EDR 1.1 (/req/core/datetime-response):
///
///   2025-03-09T06:00:00Z   A/B   ../B or /B   A/.. or A/   ../.. (all there is)
///
/// Each end is an RFC 3339 time with Z or an offset (seconds may be missing; a blank stands for the
/// '+' of an offset, as that is what an unencoded '+' becomes in a query), or a day: 2025-03-09
/// alone is that day, [00:00, 24:00]; at the end of an interval its 24:00. The standard has no
/// lists here. Throws Error(usage) for anything else and where the end lies before the start.
[[nodiscard]] TimeRange parse_datetime(std::string_view text);

/// "2025-03-09T06:00:00Z", "../2025-03-09T06:00:00Z".
[[nodiscard]] std::string format_datetime(const TimeRange& range);

}  // namespace slackwater::api::edr

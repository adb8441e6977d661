#pragma once
#include <chrono>
#include <optional>
#include <string_view>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// A time as people's tables write it, with the zone that it states.
struct WrittenTime {
  UtcTime clock{};                             ///< what the clock showed, as if it were UTC's
  std::optional<std::chrono::minutes> offset;  ///< local minus UTC; absent: nobody says

  [[nodiscard]] UtcTime utc() const noexcept {
    return clock - offset.value_or(std::chrono::minutes(0));
  }
};

/// Reads "2002-01-01T00:00", "2002-01-01 00:00:00.5", each perhaps with a Z, " UTC" or an offset
/// (+01:00, +0100, +01), and a bare date, which is its midnight. Nothing for anything else.
[[nodiscard]] std::optional<WrittenTime> read_written_time(std::string_view text);

}  // namespace slackwater::ingest

#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::dds {

/// A message as it is on the wire: XCDR1, little endian, behind its encapsulation header of four.
using Bytes = std::vector<std::uint8_t>;
using Payload = std::span<const std::uint8_t>;

/// A time as messages have it.
struct Stamp {
  std::int32_t seconds = 0;  ///< since 1970, UTC
  std::uint32_t nanoseconds = 0;
  bool operator==(const Stamp&) const = default;
};

/// @param t_s  since the epoch, 0 or more
[[nodiscard]] Stamp stamp_of(UtcTime epoch, double t_s);
[[nodiscard]] std::int64_t nanoseconds_of(const Stamp& stamp) noexcept;
/// To the millisecond that lies before.
[[nodiscard]] UtcTime time_of(const Stamp& stamp) noexcept;

}  // namespace slackwater::dds

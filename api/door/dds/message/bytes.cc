#include "api/door/dds/message/bytes.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::dds {

Stamp stamp_of(UtcTime epoch, double t_s) {
  expects(t_s >= 0 && t_s < 1e9, "a time of a run");
  constexpr std::int64_t second_ns = 1'000'000'000;
  const std::int64_t ns = epoch.time_since_epoch().count() * 1'000'000 + std::llround(t_s * 1e9);
  return {static_cast<std::int32_t>(ns / second_ns), static_cast<std::uint32_t>(ns % second_ns)};
}

std::int64_t nanoseconds_of(const Stamp& stamp) noexcept {
  return std::int64_t{stamp.seconds} * 1'000'000'000 + stamp.nanoseconds;
}

UtcTime time_of(const Stamp& stamp) noexcept {
  return UtcTime(Duration(nanoseconds_of(stamp) / 1'000'000));
}

}  // namespace slackwater::dds

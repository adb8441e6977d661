#pragma once
#include <chrono>
#include <string>
#include <string_view>

namespace slackwater {

/// An instant, UTC, to the millisecond.
using UtcTime = std::chrono::sys_time<std::chrono::milliseconds>;
/// A UTC calendar day (midnight to midnight).
using UtcDay = std::chrono::sys_days;
using Duration = std::chrono::milliseconds;

/// Reads "2024-02-29T12:00:00Z" (seconds and fraction optional, the Z is not; a bare date is
/// refused). Throws Error(invalid_input) that shows the text found and the form expected.
[[nodiscard]] UtcTime parse_utc(std::string_view text);
/// Reads "2024-02-29"; throws Error(invalid_input).
[[nodiscard]] UtcDay parse_day(std::string_view text);
/// "2024-02-29T12:00:00Z", with milliseconds only where they are not zero.
[[nodiscard]] std::string format_utc(UtcTime time);
/// "2024-02-29".
[[nodiscard]] std::string format_day(UtcDay day);
/// Reads "72h", "90min", "3d", "1h30min"; throws Error(invalid_input). The result is positive or
/// zero.
[[nodiscard]] Duration parse_duration(std::string_view text);

[[nodiscard]] constexpr double hours_of(Duration duration) noexcept {
  return std::chrono::duration<double, std::ratio<3600>>(duration).count();
}
[[nodiscard]] constexpr double hours_between(UtcTime from, UtcTime to) noexcept {
  return hours_of(to - from);
}
[[nodiscard]] constexpr double seconds_between(UtcTime from, UtcTime to) noexcept {
  return std::chrono::duration<double>(to - from).count();
}
[[nodiscard]] constexpr UtcTime add_hours(UtcTime time, double hours) noexcept {
  const double ms = hours * 3.6e6;
  return time + Duration(static_cast<Duration::rep>(ms < 0 ? ms - 0.5 : ms + 0.5));
}
[[nodiscard]] inline UtcDay day_of(UtcTime time) noexcept {
  return std::chrono::floor<std::chrono::days>(time);
}

/// When a value holds: an instant (start == end) or the mean over (start, end).
struct TimeCell {
  UtcTime start{};
  UtcTime end{};

  [[nodiscard]] static constexpr TimeCell instant(UtcTime time) noexcept { return {time, time}; }
  [[nodiscard]] constexpr bool is_mean() const noexcept { return start != end; }
  [[nodiscard]] constexpr UtcTime centre() const noexcept { return start + (end - start) / 2; }
  constexpr bool operator==(const TimeCell&) const = default;
};

/// Whether a value belongs to the closed day [00:00, 24:00]: an instant at 24:00 does; a mean
/// belongs to the day that holds its interval.
[[nodiscard]] bool belongs_to_day(const TimeCell& cell, UtcDay day) noexcept;

/// The present moment, handed in so that nothing below `api` reads the wall clock.
class Clock {
 public:
  virtual ~Clock() = default;
  [[nodiscard]] virtual UtcTime now() const = 0;
};

}  // namespace slackwater

#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/local_time.h"
#include "fields/base/step_clock.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// The steps of a series that begin in one month of one year.
struct MonthSteps {
  int year = 0;
  int month = 0;  ///< 1 to 12
  StepRange steps;
};

/// The months of a series in order, none empty. A step belongs to the month in which it begins.
/// @param zone  whose months they are; absent: UTC
[[nodiscard]] std::vector<MonthSteps> months_of(const StepClock& clock,
                                                const std::optional<TimeZone>& zone);

/// The first step of a date in one year.
struct YearDate {
  int year = 0;
  std::size_t step = 0;
};
/// The first step at or after midnight of a date, for each year in which the series comes to that
/// date and does not begin after it.
[[nodiscard]] std::vector<YearDate> dates_of(const StepClock& clock,
                                             const std::chrono::month_day& date,
                                             const std::optional<TimeZone>& zone);

/// A stretch of the day, [from, to); over midnight where `to` is not after `from`. From 00:00 to
/// 24:00 is the whole day.
struct DayHours {
  std::chrono::minutes from{0};
  std::chrono::minutes to{24 * 60};
  /// @param minute  of the day, 0 to 1439
  [[nodiscard]] constexpr bool holds(std::chrono::minutes minute) const noexcept {
    return from < to ? minute >= from && minute < to : minute >= from || minute < to;
  }
  bool operator==(const DayHours&) const = default;
};

/// Reads "6-18", "06:30-18:00", "20-4". @throws Error(invalid_input) for anything else
[[nodiscard]] DayHours parse_day_hours(const std::string& text);
/// "06:30 to 18:00".
[[nodiscard]] std::string text_of(const DayHours& hours);

/// The steps that begin within these hours of the zone's day.
[[nodiscard]] StepRanges steps_at(const StepClock& clock, const DayHours& hours,
                                  const std::optional<TimeZone>& zone);

}  // namespace slackwater::twin

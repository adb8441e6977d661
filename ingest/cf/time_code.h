#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::ingest {

/// How a CF time variable codes instants: a unit, a reference and a calendar.
///
///   instant = reference + value * unit
///
/// Units from nanoseconds to weeks; months and years are errors (they have no fixed length). The
/// reference takes the forms met in the wild: "1900-01-01 00:00:00.0", "1950-1-1",
/// "2023-07-20T10:00:00Z", "... UTC", "... +01:00". Calendars: standard, gregorian,
/// proleptic_gregorian; `julian`, `noleap` and `365_day` with a reference after 1900 are read as
/// Gregorian with a warning (files lie about it); any other is an error. A reference before 15
/// October 1582 in the standard calendar is a Julian date. Source: CF conventions 1.11,
/// section 4.4.
class TimeCode {
 public:
  /// Throws Error(invalid_input) showing the text found and the form expected.
  [[nodiscard]] static TimeCode parse(std::string_view units, std::string_view calendar,
                                      std::vector<std::string>& warnings);

  /// Throws Error(invalid_input) for a value that is not finite or not between the years 1600 and
  /// 2500.
  [[nodiscard]] UtcTime decode(double value) const;
  /// Milliseconds of one unit.
  [[nodiscard]] double unit_ms() const noexcept { return unit_ms_; }

 private:
  double unit_ms_ = 1000.0;
  std::int64_t reference_ms_ = 0;
};

/// Refuses stamps that repeat or run backward (which, and the two times); says where a regular
/// series has a gap.
void check_stamps(const std::vector<UtcTime>& stamps, std::vector<std::string>& warnings);

/// A date read from a text.
struct FoundDate {
  UtcTime time{};
  bool has_clock = false;  ///< false: a day, `time` is its midnight
};

/// The first date, with or without a time of day, inside a text: "forecast 20140516 12:00",
/// "20221020", "2017-05-03 00:00:00", "2024-03-01T05:00:00+01:00". UTC where no offset follows the
/// time of day. Nothing where there is none.
[[nodiscard]] std::optional<FoundDate> find_date_and_clock(std::string_view text);
/// The same without the question whether there was a time of day.
[[nodiscard]] std::optional<UtcTime> find_date(std::string_view text);

}  // namespace slackwater::ingest

#include "ingest/history/written_time.h"

#include <cmath>

#include "ingest/cf/text_scanner.h"

namespace slackwater::ingest {
namespace {

std::optional<UtcTime> take_day(TextScanner& scan) {
  const auto year = scan.number(4, 4);
  if (!year || !scan.take('-')) return std::nullopt;
  const auto month = scan.number(2, 2);
  if (!month || !scan.take('-')) return std::nullopt;
  const auto day = scan.number(2, 2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return UtcTime(std::chrono::sys_days(date));
}

/// "HH:MM", "HH:MM:SS", "HH:MM:SS.fff"; 24:00 is the end of the day.
std::optional<Duration> take_time_of_day(TextScanner& scan) {
  const auto hour = scan.number(2, 2);
  if (!hour || *hour > 24 || !scan.take(':')) return std::nullopt;
  const auto minute = scan.number(2, 2);
  if (!minute || *minute > 59) return std::nullopt;
  double second = 0;
  if (scan.take(':')) {
    const auto found = scan.decimal();
    if (!found || *found >= 60) return std::nullopt;
    second = *found;
  }
  const Duration since_midnight = std::chrono::hours(*hour) + std::chrono::minutes(*minute) +
                                  Duration(std::llround(second * 1000));
  if (since_midnight > std::chrono::hours(24)) return std::nullopt;
  return since_midnight;
}

/// The end of the text: nothing, Z, UTC or an offset. False for anything else.
bool take_zone(TextScanner& scan, std::optional<std::chrono::minutes>& offset) {
  scan.skip_blanks();
  if (scan.at_end()) return true;
  if (scan.take_word("z") || scan.take_word("utc")) {
    offset = std::chrono::minutes(0);
    return scan.at_end();
  }
  const int sign = scan.take('+') ? 1 : scan.take('-') ? -1 : 0;
  const auto hours = sign == 0 ? std::nullopt : scan.number(2, 2);
  if (!hours || *hours > 14) return false;
  int minutes = 0;
  if (!scan.at_end()) {
    scan.take(':');
    const auto found = scan.number(2, 2);
    if (!found || *found > 59) return false;
    minutes = *found;
  }
  offset = sign * std::chrono::minutes(60 * *hours + minutes);
  return scan.at_end();
}

}  // namespace

std::optional<WrittenTime> read_written_time(std::string_view text) {
  TextScanner scan(text);
  const auto day = take_day(scan);
  if (!day) return std::nullopt;
  WrittenTime time{*day, std::nullopt};
  if (scan.at_end()) return time;
  if (!scan.take('T') && !scan.take(' ')) return std::nullopt;
  const auto since_midnight = take_time_of_day(scan);
  if (!since_midnight) return std::nullopt;
  time.clock += *since_midnight;
  if (!take_zone(scan, time.offset)) return std::nullopt;
  return time;
}

}  // namespace slackwater::ingest

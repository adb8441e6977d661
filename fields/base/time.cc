#include "fields/base/time.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

using std::chrono::floor;

/// Reads exactly `digits` decimal digits at `position`, which moves past them.
std::optional<int> read_digits(std::string_view text, std::size_t& position, std::size_t digits) {
  if (position + digits > text.size()) return std::nullopt;
  int value = 0;
  for (std::size_t i = 0; i < digits; ++i) {
    const char c = text[position + i];
    if (c < '0' || c > '9') return std::nullopt;
    value = value * 10 + (c - '0');
  }
  position += digits;
  return value;
}

bool read_char(std::string_view text, std::size_t& position, char wanted) {
  if (position >= text.size() || text[position] != wanted) return false;
  ++position;
  return true;
}

std::optional<UtcDay> read_day(std::string_view text, std::size_t& position) {
  const auto year = read_digits(text, position, 4);
  if (!year || !read_char(text, position, '-')) return std::nullopt;
  const auto month = read_digits(text, position, 2);
  if (!month || !read_char(text, position, '-')) return std::nullopt;
  const auto day = read_digits(text, position, 2);
  if (!day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok()) return std::nullopt;
  return UtcDay(date);
}

std::optional<UtcTime> read_time(std::string_view text) {
  std::size_t position = 0;
  const auto day = read_day(text, position);
  if (!day || !read_char(text, position, 'T')) return std::nullopt;
  const auto hour = read_digits(text, position, 2);
  if (!hour || *hour > 24 || !read_char(text, position, ':')) return std::nullopt;
  const auto minute = read_digits(text, position, 2);
  if (!minute || *minute > 59) return std::nullopt;
  int second = 0;
  int millisecond = 0;
  if (read_char(text, position, ':')) {
    const auto read = read_digits(text, position, 2);
    if (!read || *read > 59) return std::nullopt;
    second = *read;
    if (read_char(text, position, '.')) {
      int scale = 100;
      std::size_t count = 0;
      while (position < text.size() && text[position] >= '0' && text[position] <= '9') {
        millisecond += scale * (text[position] - '0');
        scale /= 10;
        ++position;
        ++count;
      }
      if (count == 0) return std::nullopt;
    }
  }
  if (!read_char(text, position, 'Z') || position != text.size()) return std::nullopt;
  if (*hour == 24 && (*minute != 0 || second != 0 || millisecond != 0)) return std::nullopt;
  return UtcTime(*day) + std::chrono::hours(*hour) + std::chrono::minutes(*minute) +
         std::chrono::seconds(second) + Duration(millisecond);
}

/// A time as people write it without a zone, "2024-02-29 12:00": the same with T and Z. Nothing for
/// anything else.
std::optional<UtcTime> read_time_without_zone(std::string_view text) {
  std::string with_zone = std::string(text) + "Z";
  if (with_zone.size() > 10 && with_zone[10] == ' ') with_zone[10] = 'T';
  return read_time(with_zone);
}

/// A time with an offset from UTC, "2024-02-29T13:00:00+01:00", "+0100" or "+01".
std::optional<UtcTime> read_time_with_offset(std::string_view text) {
  const auto sign = text.find_first_of("+-", std::min<std::size_t>(11, text.size()));
  if (sign == std::string_view::npos) return std::nullopt;
  const auto time = read_time_without_zone(text.substr(0, sign));
  std::size_t position = sign + 1;
  const auto hours = read_digits(text, position, 2);
  if (!time || !hours) return std::nullopt;
  int minutes = 0;
  if (position != text.size()) {
    static_cast<void>(read_char(text, position, ':'));
    const auto read = read_digits(text, position, 2);
    if (!read || position != text.size()) return std::nullopt;
    minutes = *read;
  }
  const auto offset = std::chrono::hours(*hours) + std::chrono::minutes(minutes);
  return text[sign] == '+' ? *time - offset : *time + offset;
}

/// What to write instead of a time that is none.
std::string advice_on_time(std::string_view text) {
  if (const auto time = read_time_without_zone(text))
    return ", but it has no Z, so it may be local time; times are UTC: if this one is, write " +
           format_utc(*time);
  if (const auto time = read_time_with_offset(text))
    return ", but it has an offset; in UTC it is " + format_utc(*time);
  std::size_t position = 0;
  if (const auto day = read_day(text, position); day && position == text.size())
    return ", but it is a day; write the hour too, as " + format_utc(UtcTime(*day));
  return "; write it as 2024-02-29T12:00:00Z, with the Z";
}

}  // namespace

UtcTime parse_utc(std::string_view text) {
  if (const auto time = read_time(text)) return *time;
  throw Error(
      ErrorKind::invalid_input,
      "found '" + std::string(text) + "' where a UTC time was expected" + advice_on_time(text));
}

UtcDay parse_day(std::string_view text) {
  std::size_t position = 0;
  const auto day = read_day(text, position);
  if (day && position == text.size()) return *day;
  throw Error(
      ErrorKind::invalid_input,
      "found '" + std::string(text) + "' where a UTC day was expected; write it as 2024-02-29");
}

std::string format_day(UtcDay day) {
  const std::chrono::year_month_day date(day);
  return formatted("{:04}-{:02}-{:02}", static_cast<int>(date.year()),
                   static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()));
}

std::string format_utc(UtcTime time) {
  const auto day = floor<std::chrono::days>(time);
  const auto ms = (time - day).count();
  const std::string fraction = ms % 1000 == 0 ? "" : formatted(".{:03}", ms % 1000);
  return formatted("{}T{:02}:{:02}:{:02}{}Z", format_day(day), ms / 3600000, ms / 60000 % 60,
                   ms / 1000 % 60, fraction);
}

Duration parse_duration(std::string_view text) {
  const auto refuse = [&] {
    return Error(ErrorKind::invalid_input,
                 "found '" + std::string(text) +
                     "' where a duration was expected; write it as 72h, 90min, 3d or 1h30min");
  };
  Duration total{0};
  std::string_view rest = text;
  if (rest.empty()) throw refuse();
  while (!rest.empty()) {
    long count = 0;
    const auto [end, problem] = std::from_chars(rest.data(), rest.data() + rest.size(), count);
    if (problem != std::errc() || count < 0 || count > 100000) throw refuse();
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    if (rest.starts_with("min")) {
      total += std::chrono::minutes(count);
      rest.remove_prefix(3);
    } else if (rest.starts_with("h")) {
      total += std::chrono::hours(count);
      rest.remove_prefix(1);
    } else if (rest.starts_with("d")) {
      total += std::chrono::days(count);
      rest.remove_prefix(1);
    } else {
      throw refuse();
    }
  }
  return total;
}

bool belongs_to_day(const TimeCell& cell, UtcDay day) noexcept {
  const UtcTime from(day);
  const UtcTime to = from + std::chrono::days(1);
  return cell.start >= from && cell.end <= to;
}

}  // namespace slackwater

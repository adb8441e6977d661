#include "api/door/edr/read/datetime.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "api/door/edr/read/bad_parameter.h"
#include "fields/base/error.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_datetime_bytes = 128;
constexpr std::string_view forms_of_time =
    "a time such as 2025-03-09T06:00:00Z, a day such as 2025-03-09, or an interval such as "
    "2025-03-09T00:00:00Z/2025-03-10T00:00:00Z, ../2025-03-10 or 2025-03-09/..";

/// A time with its offset cut off, and the offset.
struct Split {
  std::string local;
  Duration offset{0};
};

bool digits_at(std::string_view text, std::size_t at) {
  return std::isdigit(static_cast<unsigned char>(text[at])) != 0 &&
         std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
}

int two_digits(std::string_view text, std::size_t at) {
  return (text[at] - '0') * 10 + (text[at + 1] - '0');
}

/// Cuts "+01:00", " 01:00", "-01:00" or "Z" from the end; nothing where there is none of them.
std::optional<Split> split_offset(std::string_view text) {
  if (text.ends_with('Z') || text.ends_with('z')) {
    return Split{std::string(text.substr(0, text.size() - 1)), Duration(0)};
  }
  constexpr std::size_t length = 6;
  if (text.size() <= length) return std::nullopt;
  const std::string_view end = text.substr(text.size() - length);
  const bool has_sign = end[0] == '+' || end[0] == ' ' || end[0] == '-';
  if (!has_sign || end[3] != ':' || !digits_at(end, 1) || !digits_at(end, 4)) return std::nullopt;
  const int hours = two_digits(end, 1);
  const int minutes = two_digits(end, 4);
  if (hours > 23 || minutes > 59) return std::nullopt;
  const Duration offset = std::chrono::hours(hours) + std::chrono::minutes(minutes);
  return Split{std::string(text.substr(0, text.size() - length)), end[0] == '-' ? -offset : offset};
}

/// One end of an interval: an instant, or a day as its two midnights.
TimeRange moment_of(std::string_view text) {
  try {
    constexpr std::size_t length_of_a_day = 10;
    if (text.size() == length_of_a_day) {
      const UtcTime midnight(parse_day(text));
      return {midnight, midnight + std::chrono::days(1)};
    }
    auto split = split_offset(text);
    if (!split)
      throw bad_parameter("datetime", text,
                          std::string(forms_of_time) + "; Z or an offset is missing");
    std::replace(split->local.begin(), split->local.end(), 't', 'T');
    const UtcTime time = parse_utc(split->local + "Z") - split->offset;
    return {time, time};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::usage) throw;
    throw bad_parameter("datetime", text, forms_of_time);
  }
}

bool is_open(std::string_view end) { return end.empty() || end == ".."; }

}  // namespace

TimeRange parse_datetime(std::string_view text) {
  expect_short("datetime", text, max_datetime_bytes);
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) return moment_of(text);
  const std::string_view start = text.substr(0, slash);
  const std::string_view end = text.substr(slash + 1);
  if (end.find('/') != std::string_view::npos ||
      (is_open(start) && is_open(end) && text != "../..")) {
    throw bad_parameter("datetime", text, forms_of_time);
  }
  TimeRange range;
  if (!is_open(start)) range.from = moment_of(start).from;
  if (!is_open(end)) range.to = moment_of(end).to;
  if (range.from && range.to && *range.to < *range.from) {
    throw bad_parameter("datetime", text,
                        "an interval that ends after it starts; exchange its two times");
  }
  return range;
}

std::string format_datetime(const TimeRange& range) {
  if (range.is_instant()) return format_utc(*range.from);
  return (range.from ? format_utc(*range.from) : "..") + "/" +
         (range.to ? format_utc(*range.to) : "..");
}

}  // namespace slackwater::api::edr

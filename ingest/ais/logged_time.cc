#include "ingest/ais/logged_time.h"

#include <algorithm>
#include <charconv>
#include <string>

#include "ingest/history/written_time.h"

namespace slackwater::ingest {
namespace {

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

std::size_t digits_at(std::string_view text, std::size_t at) noexcept {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

std::int64_t whole_number(std::string_view digits) noexcept {
  std::int64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

/// "2025-03-08T00:00:00.250Z" and its kin, at the beginning of the text.
std::optional<LoggedTime> calendar_time(std::string_view text) {
  constexpr std::string_view form = "dddd-dd-ddTdd:dd";
  if (text.size() < form.size()) return std::nullopt;
  std::string written(text.substr(0, std::min<std::size_t>(text.size(), 40)));
  if (written[4] == '/' && written[7] == '/') written[4] = written[7] = '-';
  if (written[10] == 't' || written[10] == '_') written[10] = 'T';
  for (std::size_t i = 0; i < form.size(); ++i) {
    const bool fits = form[i] == 'd'   ? is_digit(written[i])
                      : form[i] == 'T' ? written[i] == 'T' || written[i] == ' '
                                       : written[i] == form[i];
    if (!fits) return std::nullopt;
  }
  std::size_t end = form.size();
  if (end < written.size() && written[end] == ':' && digits_at(written, end + 1) == 2) {
    end += 3;
    const bool has_fraction = end + 1 < written.size() &&
                              (written[end] == '.' || written[end] == ',') &&
                              is_digit(written[end + 1]);
    if (has_fraction) {
      written[end] = '.';
      end += 1 + digits_at(written, end + 1);
    }
  }
  // The zone, where one stands: the longest text that reads as a time.
  for (std::size_t most = std::min(written.size(), end + 7); most >= end; --most) {
    const auto time = read_written_time(std::string_view(written).substr(0, most));
    if (!time) continue;
    const auto utc = believable_time(time->utc());
    if (!utc) return std::nullopt;
    return LoggedTime{*utc, time->offset.has_value()};
  }
  return std::nullopt;
}

/// "20250308000000"
std::optional<UtcTime> packed_time(std::string_view digits) {
  const auto part = [&](std::size_t from, std::size_t length) {
    return std::string(digits.substr(from, length));
  };
  const auto time = read_written_time(part(0, 4) + '-' + part(4, 2) + '-' + part(6, 2) + 'T' +
                                      part(8, 2) + ':' + part(10, 2) + ':' + part(12, 2));
  if (!time) return std::nullopt;
  return believable_time(time->clock);
}

}  // namespace

std::optional<UtcTime> believable_time(UtcTime time) noexcept {
  constexpr UtcTime earliest = UtcDay(std::chrono::year(1990) / 1 / 1);
  constexpr UtcTime latest = UtcDay(std::chrono::year(2100) / 1 / 1);
  if (time < earliest || time >= latest) return std::nullopt;
  return time;
}

std::optional<LoggedTime> logged_time_in(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t digits = digits_at(text, at);
    if (digits == 0) {
      ++at;
      continue;
    }
    const char before = at == 0 ? ' ' : text[at - 1];
    const bool begins = before != '.' && before != '-';
    const std::string_view number = text.substr(at, digits);
    std::optional<UtcTime> since_1970;
    if (begins && digits == 4) {
      if (const auto time = calendar_time(text.substr(at))) return time;
    } else if (begins && digits == 10) {
      Duration part(0);
      if (at + digits + 1 < text.size() && text[at + digits] == '.') {
        std::string thousandths(text.substr(at + digits + 1, 3));
        thousandths.resize(std::min<std::size_t>(3, digits_at(text, at + digits + 1)));
        thousandths.resize(3, '0');
        part = Duration(whole_number(thousandths));
      }
      since_1970 = believable_time(UtcTime(Duration(whole_number(number) * 1000) + part));
    } else if (begins && digits == 13) {
      since_1970 = believable_time(UtcTime(Duration(whole_number(number))));
    } else if (begins && digits == 14) {
      const std::string_view said = text.substr(0, at);
      const bool is_ais_catcher = said.find("timestamp") != std::string_view::npos ||
                                  said.find("rxtime") != std::string_view::npos;
      if (const auto time = packed_time(number)) return LoggedTime{*time, is_ais_catcher};
    }
    if (since_1970) return LoggedTime{*since_1970, true};
    at += digits;
  }
  return std::nullopt;
}

}  // namespace slackwater::ingest

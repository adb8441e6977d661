#include "api/door/edr/write/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace slackwater::api::edr {
namespace {

constexpr std::array<std::uint64_t, 12> powers{1,         10,         100,         1000,
                                               10000,     100000,     1000000,     10000000,
                                               100000000, 1000000000, 10000000000, 100000000000};

/// digits * 10^-decimals, without trailing zeros behind the point.
void append_decimal(std::string& out, bool is_negative, std::uint64_t digits,
                    std::size_t decimals) {
  while (decimals > 0 && digits % 10 == 0) {
    digits /= 10;
    --decimals;
  }
  std::array<char, 40> buffer{};
  char* const end = buffer.data() + buffer.size();
  char* start = end;
  for (std::size_t written = 0; written <= decimals || digits > 0; ++written) {
    if (written == decimals && decimals > 0) *--start = '.';
    *--start = static_cast<char>('0' + digits % 10);
    digits /= 10;
  }
  if (is_negative) *--start = '-';
  out.append(start, static_cast<std::size_t>(end - start));
}

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

/// Bytes of the UTF-8 character at the start of a text, 0 where there is none (RFC 3629, 4).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  std::size_t length = 0;
  unsigned char low = 0x80;
  unsigned char high = 0xBF;
  if (first >= 0xC2 && first <= 0xDF) length = 2;
  if (first >= 0xE0 && first <= 0xEF) length = 3;
  if (first >= 0xF0 && first <= 0xF4) length = 4;
  if (first == 0xE0) low = 0xA0;   // overlong
  if (first == 0xED) high = 0x9F;  // surrogates
  if (first == 0xF0) low = 0x90;   // overlong
  if (first == 0xF4) high = 0x8F;  // beyond U+10FFFF
  if (length == 0 || text.size() < length || byte(1) < low || byte(1) > high) return 0;
  const std::string_view tail = text.substr(2, length - 2);
  return std::all_of(tail.begin(), tail.end(), continues) ? length : 0;
}

void append_control(std::string& out, char c) {
  constexpr std::string_view hexadecimal = "0123456789abcdef";
  const auto byte = static_cast<unsigned char>(c);
  out += "\\u00";
  out += hexadecimal[byte >> 4U];
  out += hexadecimal[byte & 15U];
}

bool is_plain(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0x20 && byte < 0x7F && c != '"' && c != '\\';
}

void append_two(std::string& out, unsigned value) {
  out += static_cast<char>('0' + value / 10);
  out += static_cast<char>('0' + value % 10);
}

}  // namespace

void append_string(std::string& out, std::string_view text) {
  out += '"';
  while (!text.empty()) {
    const auto plain = static_cast<std::size_t>(
        std::find_if_not(text.begin(), text.end(), is_plain) - text.begin());
    out.append(text.substr(0, plain));
    text.remove_prefix(plain);
    if (text.empty()) break;
    std::size_t length = 1;
    if (text[0] == '"' || text[0] == '\\') {
      out += '\\';
      out += text[0];
    } else if (static_cast<unsigned char>(text[0]) < 0x80) {
      append_control(out, text[0]);
    } else if (const std::size_t character = utf8_length(text); character > 0) {
      out.append(text.substr(0, character));
      length = character;
    } else {
      out += "\\ufffd";
    }
    text.remove_prefix(length);
  }
  out += '"';
}

void append_value(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  const double size = std::abs(value);
  if (size == 0) {
    out += '0';
    return;
  }
  if (size < 1e-5 || size >= 1e6) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                   std::chars_format::general, 6);
    out.append(buffer.data(), end.ptr);
    return;
  }
  // Six digits before the point: the powers are exact, so that the product errs by one rounding.
  std::size_t decimals = 0;
  while (size * static_cast<double>(powers[decimals]) < 1e5) ++decimals;
  const double scaled = size * static_cast<double>(powers[decimals]);
  // NOLINTNEXTLINE(bugprone-incorrect-roundings): exact below 2^52, and no call.
  append_decimal(out, value < 0, static_cast<std::uint64_t>(scaled + 0.5), decimals);
}

void append_coordinate(std::string& out, double value) {
  constexpr std::size_t decimals = 7;
  const double scaled = std::abs(value) * static_cast<double>(powers[decimals]) + 0.5;
  if (!(scaled < 1e15)) {
    append_value(out, value);
    return;
  }
  const auto digits = static_cast<std::uint64_t>(scaled);
  append_decimal(out, value < 0 && digits > 0, digits, decimals);
}

void append_time(std::string& out, UtcTime time) {
  const auto day = std::chrono::floor<std::chrono::days>(time);
  const std::chrono::year_month_day date(day);
  const auto ms = static_cast<unsigned>((time - day).count());
  const int year = static_cast<int>(date.year());
  if (year < 0 || year > 9999 || ms % 1000 != 0) {
    out += format_utc(time);
    return;
  }
  append_two(out, static_cast<unsigned>(year) / 100);
  append_two(out, static_cast<unsigned>(year) % 100);
  out += '-';
  append_two(out, static_cast<unsigned>(date.month()));
  out += '-';
  append_two(out, static_cast<unsigned>(date.day()));
  out += 'T';
  append_two(out, ms / 3'600'000);
  out += ':';
  append_two(out, ms / 60'000 % 60);
  out += ':';
  append_two(out, ms / 1'000 % 60);
  out += 'Z';
}

}  // namespace slackwater::api::edr

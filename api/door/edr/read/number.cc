#include "api/door/edr/read/number.h"

#include <charconv>
#include <cmath>

namespace slackwater::api::edr {
namespace {

bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }

}  // namespace

std::optional<double> take_number(std::string_view& text) noexcept {
  std::string_view rest = text;
  if (rest.starts_with('+')) rest.remove_prefix(1);
  // from_chars reads "inf" and "nan" too: a number starts with a digit, or a point before one.
  std::string_view digits = rest;
  if (!text.starts_with('+') && digits.starts_with('-')) digits.remove_prefix(1);
  const bool starts =
      !digits.empty() &&
      (is_digit(digits[0]) || (digits.size() > 1 && digits[0] == '.' && is_digit(digits[1])));
  if (!starts) return std::nullopt;
  double value = 0;
  const char* const last = rest.data() + rest.size();
  const auto [end, problem] = std::from_chars(rest.data(), last, value);
  if (problem != std::errc() || !std::isfinite(value)) return std::nullopt;
  text = std::string_view(end, static_cast<std::size_t>(last - end));
  return value;
}

std::optional<double> number_of(std::string_view text) noexcept {
  const auto value = take_number(text);
  return text.empty() ? value : std::nullopt;
}

std::optional<std::size_t> count_of(std::string_view text) noexcept {
  if (text.empty() || text.size() > 9) return std::nullopt;
  std::size_t count = 0;
  for (const char c : text) {
    if (!is_digit(c)) return std::nullopt;
    count = count * 10 + static_cast<std::size_t>(c - '0');
  }
  return count;
}

}  // namespace slackwater::api::edr

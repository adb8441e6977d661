#include "fields/base/advice.h"

#include <algorithm>

#include "fields/base/config.h"

namespace slackwater {

std::optional<std::string> with_decimal_point(std::string_view text) {
  const std::string_view digits =
      text.starts_with('-') || text.starts_with('+') ? text.substr(1) : text;
  const auto comma = digits.find(',');
  const auto are_digits = [](std::string_view part) {
    return !part.empty() &&
           std::all_of(part.begin(), part.end(), [](char c) { return c >= '0' && c <= '9'; });
  };
  if (comma == std::string_view::npos || !are_digits(digits.substr(0, comma)) ||
      !are_digits(digits.substr(comma + 1)))
    return std::nullopt;
  std::string meant(text);
  meant[text.find(',')] = '.';
  return meant;
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
  const auto nearest = nearest_word(word, known);
  return nearest ? " (did you mean '" + *nearest + "'?)" : std::string();
}

}  // namespace slackwater

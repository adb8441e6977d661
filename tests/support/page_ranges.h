#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "tests/support/page_keys.h"

// Ranges of keys as a page tells them, and as readers have them in C++. An end that is no number in
// either is NaN.

namespace slackwater::tests {

/// NaN for what is no number, whole.
[[nodiscard]] inline double number_in(std::string_view text) {
  std::string digits(trimmed(text));
  std::erase(digits, '\'');  // 1'000
  while (!digits.empty() && (digits.back() == ';' || digits.back() == ',')) digits.pop_back();
  char* end = nullptr;
  const double value = std::strtod(digits.c_str(), &end);
  return digits.empty() || *end != '\0' ? constants::nan : value;
}

/// "0.05 … 200; of air 1 … 1e6", "±360".
[[nodiscard]] inline std::vector<Range> ranges_told(const std::string& cell) {
  static const std::regex pair(R"re((\S+) … (\S+)|±(\S+))re");
  std::vector<Range> told;
  for (std::sregex_iterator at(cell.begin(), cell.end(), pair), end; at != end; ++at) {
    const double both = number_in((*at)[3].str());
    if ((*at)[3].matched)
      told.push_back({-both, both});
    else
      told.push_back({number_in((*at)[1].str()), number_in((*at)[2].str())});
  }
  return told;
}

/// What stands after a text, up to a mark; nothing where it is not.
[[nodiscard]] inline std::string after(const std::string& source, const std::string& text,
                                       char mark) {
  const std::size_t at = source.find(text);
  if (at == std::string::npos) return {};
  const std::size_t begin = at + text.size();
  return source.substr(begin, source.find(mark, begin) - begin);
}

/// A product of numbers and constants of the source.
[[nodiscard]] inline double evaluated(const std::string& expression, const std::string& source) {
  double product = 1;
  for (std::size_t at = 0; at <= expression.size();) {
    const std::size_t end = std::min(expression.find('*', at), expression.size());
    const std::string factor(trimmed(std::string_view(expression).substr(at, end - at)));
    if (is_word(factor)) {
      const std::string named = after(source, " " + factor + " = ", ';');
      product *= named.empty() ? constants::nan : evaluated(named, source);
    } else {
      product *= number_in(factor);
    }
    at = end + 1;
  }
  return product;
}

/// What a reader passes as a range: `{0, 5}`, the name of one, or `0, 5`.
[[nodiscard]] inline Range range_passed(std::string arguments, const std::string& source) {
  if (is_word(arguments)) arguments = after(source, "Range " + arguments + "{", '}');
  std::erase_if(arguments, [](char c) { return c == '{' || c == '}'; });
  const std::size_t comma = arguments.find(',');
  if (comma == std::string::npos) return {constants::nan, constants::nan};
  return {evaluated(arguments.substr(0, comma), source),
          evaluated(arguments.substr(comma + 1), source)};
}

}  // namespace slackwater::tests

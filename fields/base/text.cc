#include "fields/base/text.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater {

std::string formatted_values(std::string_view format, std::span<const FormatValue> values) {
  fmt::dynamic_format_arg_store<fmt::format_context> arguments;
  arguments.reserve(values.size(), 0);
  for (const FormatValue& value : values)
    std::visit([&](const auto& plain) { arguments.push_back(plain); }, value);
  try {
    return fmt::vformat(format, arguments);
  } catch (const fmt::format_error& error) {
    const std::string message =
        "found the format '" + std::string(format) + "', which cannot be: " + error.what();
    expects(false, message.c_str());
    throw;
  }
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return lower;
}

bool contains_ignoring_case(std::string_view text, std::string_view part) {
  return lower_case(text).find(lower_case(part)) != std::string::npos;
}

}  // namespace slackwater

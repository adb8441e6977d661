#pragma once
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace slackwater::tests {

/// How much a long run wants of what `make test` does a little of: SLACKWATER_KILLS and the like.
/// @throws std::invalid_argument for what is no whole number above 0: a test of nothing would pass
inline int asked_number(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  if (text == nullptr) return otherwise;
  char* end = nullptr;
  const long asked = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || asked < 1 || asked > 1'000'000'000)
    throw std::invalid_argument(std::string(variable) + " is '" + text +
                                "'; expected a whole number from 1 to 1000000000");
  return static_cast<int>(asked);
}

}  // namespace slackwater::tests

#pragma once
#include <cstdlib>

namespace slackwater::tests {

/// How much a long run wants of what `make test` does a little of: SLACKWATER_KILLS and the like.
inline int asked_number(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atoi(text);
}

}  // namespace slackwater::tests

#pragma once
#include <gtest/gtest.h>

#include <string_view>

namespace slackwater::tests {

/// Whether the text holds the part; a failure shows the text.
inline testing::AssertionResult contains(std::string_view text, std::string_view part) {
  if (text.find(part) != std::string_view::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

}  // namespace slackwater::tests

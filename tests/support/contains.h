#pragma once
#include <gtest/gtest.h>

#include <string>
#include <string_view>

namespace slackwater::tests {

/// Whether the text holds the part; a failure shows the text.
inline testing::AssertionResult contains(const std::string& text, std::string_view part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

}  // namespace slackwater::tests

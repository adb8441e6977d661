#pragma once
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "fields/base/error.h"
#include "tests/support/contains.h"

namespace slackwater::tests {

/// The message with which `parse` refuses, of kind usage; "" (and a failure) where it does not.
template <typename Parse>
std::string refusal_of(const Parse& parse) {
  try {
    parse();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage) << error.message();
    // The parameter, eighty bytes of what was found, and what was expected.
    EXPECT_LT(error.message().size(), 1000U);
    for (const char c : error.message()) {
      EXPECT_TRUE(c >= ' ' && c <= '~') << "a byte " << static_cast<int>(c) << " in a message";
    }
    return error.message();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

/// A prefix and `count` times a character. (GCC 12 warns wrongly of
/// "prefix" + std::string(count, c).)
inline std::string long_text(std::string_view prefix, std::size_t count, char c) {
  std::string text(prefix);
  text.append(count, c);
  return text;
}

}  // namespace slackwater::tests

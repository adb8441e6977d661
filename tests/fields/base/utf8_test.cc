#include "fields/base/encode/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace slackwater::utf8_test {
namespace {

/// RFC 3629, section 3, by arithmetic.
std::string coded(std::uint32_t c) {
  const auto follower = [c](unsigned shift) {
    return static_cast<char>(0x80 | (c >> shift & 0x3f));
  };
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xc0 | c >> 6U), follower(0)};
  if (c < 0x10000) return {static_cast<char>(0xe0 | c >> 12U), follower(6), follower(0)};
  return {static_cast<char>(0xf0 | c >> 18U), follower(12), follower(6), follower(0)};
}

TEST(Utf8, EachCharacterIsReadWholeAndItsBeginningsWaitForTheRest) {
  for (std::uint32_t c = 0; c <= 0x10ffff; c += c < 0x900 ? 1 : 37) {
    const std::string text = coded(c);
    const bool is_one = c < 0xd800 || c > 0xdfff;
    std::string_view left = text;
    const auto read = take_character(left);
    ASSERT_EQ(read.has_value(), is_one) << c;
    if (!is_one) continue;
    ASSERT_EQ(*read, c);
    ASSERT_TRUE(left.empty());
    for (std::size_t bytes = 1; bytes <= text.size(); ++bytes)
      ASSERT_EQ(is_begun_character(text.substr(0, bytes)), bytes < text.size()) << c;
  }
}

TEST(Utf8, WhatIsNoCharacterIsNeitherReadNorWaitedFor) {
  for (const char* bad :
       {"\x80", "\xbf", "\xc0\xaf", "\xc1", "\xe0\x80\xaf", "\xe0\x9f", "\xed\xa0", "\xf0\x8f",
        "\xf4\x90", "\xf5", "\xff", "\xc3(", "\xe2\x82(", "\xf0\x9f("}) {
    std::string_view left = bad;
    EXPECT_FALSE(take_character(left)) << bad;
    EXPECT_EQ(left, bad);
    EXPECT_FALSE(is_begun_character(bad)) << bad;
  }
}

TEST(Utf8, WhatSteersATerminalIsKnown) {
  for (const std::uint32_t c :
       {0x00, 0x07, 0x0a, 0x1b, 0x7f, 0x85, 0x9b, 0x61c, 0x200e, 0x2028, 0x202e, 0x2066, 0x2069})
    EXPECT_TRUE(steers(c)) << c;
  for (const std::uint32_t c : {0x20, 0x7e, 0xa0, 0xe9, 0x2026, 0x2192, 0x1f30a})
    EXPECT_FALSE(steers(c)) << c;
}

}  // namespace
}  // namespace slackwater::utf8_test

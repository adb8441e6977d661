#include "api/door/cli/plain_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace slackwater::api::plain_text_test {
namespace {

std::string plain(std::string_view text) { return PlainText().next(text); }

TEST(PlainText, OurOwnTextStaysAsItIs) {
  const std::string text = "Synthetic bay:\t0.38 m/s to 093°, 80 % … → é 日本 🌊\n";
  EXPECT_EQ(plain(text), text);
}

TEST(PlainText, WhatSteersATerminalIsShown) {
  EXPECT_EQ(plain("a\x1b[31m\r\a\x7f\u0085\u202e\u2028z"),
            R"(a\u001b[31m\u000d\u0007\u007f\u0085\u202e\u2028z)");
}

TEST(PlainText, BytesThatAreNoUtf8AreShown) {
  EXPECT_EQ(plain("a\xff\xc3(\xed\xa0\x80z"), R"(a\xff\xc3(\xed\xa0\x80z)");
}

/// A stream hands a text over in pieces, and cuts where it likes.
TEST(PlainText, ItDoesNotMatterWhereATextIsCut) {
  const std::string text = "°🌊\x1b\xff日\u202e\xf0\x9f\x8c|\n";
  for (std::size_t first = 0; first <= text.size(); ++first)
    for (std::size_t second = first; second <= text.size(); ++second) {
      PlainText cut;
      const std::string told = cut.next(text.substr(0, first)) +
                               cut.next(text.substr(first, second - first)) +
                               cut.next(text.substr(second));
      ASSERT_EQ(told, plain(text)) << first << " " << second;
    }
}

TEST(PlainText, JsonSaysTheSame) {
  const nlohmann::json document = {{"name\u202e", "\x1b[31m\u0085\u2028 \"\\ é 🌊"}};
  for (const bool is_ascii : {false, true})
    EXPECT_EQ(nlohmann::json::parse(plain(document.dump(2, ' ', is_ascii))), document);
}

}  // namespace
}  // namespace slackwater::api::plain_text_test

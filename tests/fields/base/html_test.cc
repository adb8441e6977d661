#include "fields/base/encode/html.h"

#include <gtest/gtest.h>

#include <string>

namespace slackwater::html_test {
namespace {

TEST(EscapedHtml, NoTextBecomesATagOrEndsAnAttribute) {
  EXPECT_EQ(escaped_html("<b onclick=\"f('x')\">R&D</b>"),
            "&lt;b onclick=&quot;f(&#39;x&#39;)&quot;&gt;R&amp;D&lt;/b&gt;");
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  EXPECT_EQ(escaped_html(all).find_first_of("<>\"'"), std::string::npos);
}

TEST(EscapedHtml, KeepsEveryOtherByte) {
  std::string others;
  for (int byte = 0; byte < 256; ++byte)
    if (std::string("&<>\"'").find(static_cast<char>(byte)) == std::string::npos)
      others += static_cast<char>(byte);
  EXPECT_EQ(escaped_html(others), others);
  EXPECT_EQ(escaped_html("Saint-Brieuc, 10 °C"), "Saint-Brieuc, 10 °C");
}

TEST(EscapedHtml, WhatIsEscapedTwiceReadsAsItWasEscapedOnce) {
  EXPECT_EQ(escaped_html(escaped_html("a<b")), "a&amp;lt;b");
}

}  // namespace
}  // namespace slackwater::html_test

#include "fields/base/encode/base64.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace slackwater::tests::base64_test {
namespace {

std::string coded(std::string_view text) {
  return base64_of(std::vector<std::uint8_t>(text.begin(), text.end()));
}

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10.
  EXPECT_EQ(coded(""), "");
  EXPECT_EQ(coded("f"), "Zg==");
  EXPECT_EQ(coded("fo"), "Zm8=");
  EXPECT_EQ(coded("foo"), "Zm9v");
  EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64_of(std::vector<std::uint8_t>{0xff, 0xfe, 0xfb}), "//77");
}

}  // namespace
}  // namespace slackwater::tests::base64_test

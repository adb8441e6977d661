#include "fields/base/encode/percent.h"

#include <gtest/gtest.h>

namespace slackwater::percent_test {
namespace {

TEST(PercentCoding, RoundTripsEveryByte) {
  std::string all;
  for (int byte = 0; byte < 256; ++byte) all += static_cast<char>(byte);
  const std::string coded = percent_encoded(all);
  EXPECT_EQ(percent_decoded(coded), all);
  EXPECT_EQ(coded.find_first_of(" \"<>&=+/\r\n"), std::string::npos);
}

TEST(PercentCoding, IsDecodedOnceOrRefused) {
  EXPECT_EQ(percent_decoded("a%20b%2B%c3%A9"), "a b+\xc3\xa9");
  EXPECT_EQ(percent_decoded("%2541"), "%41");
  for (const char* bad : {"%", "%4", "%4g", "a%"}) EXPECT_FALSE(percent_decoded(bad)) << bad;
}

}  // namespace
}  // namespace slackwater::percent_test

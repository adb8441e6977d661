#include "data/bag/crc32.h"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace slackwater::bag::tests {
namespace {

std::uint32_t sum_of(std::string_view text, std::uint32_t before = 0) {
  return crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, before);
}

/// The check values of the catalogue of CRCs (reveng, CRC-32/ISO-HDLC).
TEST(Crc32, IsThatOfTheCatalogue) {
  EXPECT_EQ(sum_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(sum_of(""), 0U);
  EXPECT_EQ(sum_of("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
}

TEST(Crc32, GoesOnFromAnySum) {
  const std::string_view text = "The quick brown fox jumps over the lazy dog";
  for (std::size_t i = 0; i <= text.size(); ++i)
    EXPECT_EQ(sum_of(text.substr(i), sum_of(text.substr(0, i))), sum_of(text)) << i;
}

}  // namespace
}  // namespace slackwater::bag::tests

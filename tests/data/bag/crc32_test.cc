#include "data/bag/crc32.h"

#include <gtest/gtest.h>

#include <string_view>

namespace slackwater::bag::tests::crc32_test {
namespace {

std::uint32_t sum_of(std::string_view text) {
  return crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// The check values of the catalogue of CRCs (reveng, CRC-32/ISO-HDLC).
TEST(Crc32, IsThatOfTheCatalogue) {
  EXPECT_EQ(sum_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(sum_of(""), 0U);
  EXPECT_EQ(sum_of("The quick brown fox jumps over the lazy dog"), 0x414FA339U);
}

}  // namespace
}  // namespace slackwater::bag::tests::crc32_test

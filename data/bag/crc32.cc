#include "data/bag/crc32.h"

#include <array>
#include <cstddef>

namespace slackwater::bag {
namespace {

using Table = std::array<std::array<std::uint32_t, 256>, 8>;

/// Table k holds what a byte does to the sum after k further bytes of zero: eight bytes are taken
/// at a time ("slicing by 8").
constexpr Table table_of_bytes() {
  Table table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1U) ^ ((sum & 1U) != 0 ? 0xEDB88320U : 0U);
    table[0][byte] = sum;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte)
      table[k][byte] = (table[k - 1][byte] >> 8U) ^ table[0][table[k - 1][byte] & 0xFFU];
  return table;
}

constexpr Table table = table_of_bytes();

}  // namespace

std::uint32_t crc32(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  std::uint32_t sum = ~before;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    const std::uint8_t* p = bytes.data() + i;
    const std::uint32_t low = sum ^ (p[0] | std::uint32_t{p[1]} << 8U | std::uint32_t{p[2]} << 16U |
                                     std::uint32_t{p[3]} << 24U);
    sum = table[7][low & 0xFFU] ^ table[6][low >> 8U & 0xFFU] ^ table[5][low >> 16U & 0xFFU] ^
          table[4][low >> 24U] ^ table[3][p[4]] ^ table[2][p[5]] ^ table[1][p[6]] ^ table[0][p[7]];
  }
  for (; i < bytes.size(); ++i) sum = (sum >> 8U) ^ table[0][(sum ^ bytes[i]) & 0xFFU];
  return ~sum;
}

}  // namespace slackwater::bag

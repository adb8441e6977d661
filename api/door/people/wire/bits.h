#pragma once
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace slackwater::people {

/// Writes numbers bit by bit, the highest bit of a byte first; those near zero take few bits.
class BitWriter {
 public:
  /// Begins anew; what was taken of the heap stays.
  void clear() noexcept {
    bytes_.clear();
    free_ = 0;
  }
  /// The lowest `count` bits of it, at most 32.
  void put(std::uint32_t value, int count) {
    for (int i = count - 1; i >= 0; --i) {
      if (free_ == 0) {
        bytes_.push_back(0);
        free_ = 8;
      }
      --free_;
      bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | ((value >> i & 1U) << free_));
    }
  }
  /// Exponential Golomb: 0 is `1`, 1 `010`, 2 `011`, 3 `00100`. Below 2^31.
  void put_count(std::uint32_t value) {
    const auto digits = static_cast<int>(std::bit_width(value + 1));
    put(0, digits - 1);
    put(value + 1, digits);
  }
  /// 0, -1, 1, -2, 2 as the counts 0, 1, 2, 3, 4. Within 2^30.
  void put_signed(std::int32_t value) {
    const auto doubled = 2 * static_cast<std::int64_t>(value);
    put_count(static_cast<std::uint32_t>(value < 0 ? -doubled - 1 : doubled));
  }
  /// The bits so far; the last byte ends with zeros.
  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const noexcept { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
  int free_ = 0;  ///< bits of the last byte
};

}  // namespace slackwater::people

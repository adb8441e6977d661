#pragma once
#include <cstdint>
#include <span>

namespace slackwater::dds {

/// Reads fields of RTPS one behind the other, and never beyond the end: what is not there is 0, and
/// from then on it is not good.
class Cursor {
 public:
  Cursor() = default;
  Cursor(std::span<const std::uint8_t> bytes, bool is_little_endian) noexcept
      : bytes_(bytes), is_little_endian_(is_little_endian) {}

  [[nodiscard]] bool is_good() const noexcept { return is_good_; }
  [[nodiscard]] std::size_t at() const noexcept { return at_; }
  [[nodiscard]] std::span<const std::uint8_t> rest() const noexcept { return bytes_.subspan(at_); }

  void skip(std::size_t count) noexcept {
    is_good_ = is_good_ && count <= bytes_.size() - at_;
    if (is_good_) at_ += count;
  }
  std::uint16_t u16() noexcept { return static_cast<std::uint16_t>(read(2, is_little_endian_)); }
  std::uint32_t u32() noexcept { return read(4, is_little_endian_); }
  /// Of a writer or reader: four octets as they stand (RTPS 2.3, 9.3.1.2).
  std::uint32_t entity() noexcept { return read(4, false); }
  /// Of a sample: the high half first, each half in the order of the rest (9.3.2).
  std::int64_t number() noexcept {
    const std::uint64_t high = u32(), low = u32();
    return static_cast<std::int64_t>((high << 32U) | low);
  }

 private:
  std::uint32_t read(std::size_t count, bool is_little_endian) noexcept {
    const std::size_t begin = at_;
    skip(count);
    std::uint32_t value = 0;
    for (std::size_t i = 0; is_good_ && i < count; ++i) {
      const std::size_t place = is_little_endian ? begin + count - 1 - i : begin + i;
      value = (value << 8U) | bytes_[place];
    }
    return value;
  }

  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  bool is_little_endian_ = true;
  bool is_good_ = true;
};

}  // namespace slackwater::dds

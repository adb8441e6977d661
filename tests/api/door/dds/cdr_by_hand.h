#pragma once
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <string>

#include "api/door/dds/message/bytes.h"

namespace slackwater::tests {

// XCDR1 as the rules have it (OMG DDSI-RTPS 10, CORBA 3.1 9.3): a number lies at a multiple of its
// own size, counted behind the encapsulation header of four; a string is its length with the NUL,
// then its bytes; a sequence its count, then its elements. Written and read here without the
// library that api/door/dds has, so that the one can be held against the other.

enum class Order { little, big };

/// Bytes of a number as they lie in memory, turned round where the order is not the machine's.
template <typename Number>
[[nodiscard]] std::array<std::uint8_t, sizeof(Number)> bytes_of(Number number, Order order) {
  static_assert(std::endian::native == std::endian::little);
  std::array<std::uint8_t, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &number, sizeof number);
  if (order == Order::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Writes a message field by field.
class HandWriter {
 public:
  explicit HandWriter(Order order = Order::little)
      : order_(order), bytes_{0, static_cast<std::uint8_t>(order == Order::little ? 1 : 0), 0, 0} {}

  template <typename Number>
  HandWriter& put(Number number) {
    while ((bytes_.size() - 4) % sizeof number != 0) bytes_.push_back(0);
    const auto bytes = bytes_of(number, order_);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  HandWriter& string(const std::string& text) {
    put(static_cast<std::uint32_t>(text.size() + 1));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.push_back(0);
    return *this;
  }
  HandWriter& doubles(std::initializer_list<double> numbers) {
    for (const double number : numbers) put(number);
    return *this;
  }
  HandWriter& header(std::int32_t seconds, std::uint32_t nanoseconds, const std::string& frame_id) {
    return put(seconds).put(nanoseconds).string(frame_id);
  }
  [[nodiscard]] const dds::Bytes& bytes() const noexcept { return bytes_; }

 private:
  Order order_;
  dds::Bytes bytes_;
};

/// Reads a message field by field; what does not fit is told as a failure of the test.
class HandReader {
 public:
  explicit HandReader(dds::Bytes bytes) : bytes_(std::move(bytes)) {
    const dds::Bytes encapsulation{0, 1, 0, 0};
    EXPECT_TRUE(bytes_.size() > 4 &&
                std::equal(encapsulation.begin(), encapsulation.end(), bytes_.begin()))
        << "XCDR1, little endian";
  }

  template <typename Number>
  Number get() {
    while ((at_ - 4) % sizeof(Number) != 0) ++at_;
    Number number{};
    if (at_ + sizeof(Number) > bytes_.size()) {
      ADD_FAILURE() << "the message ends before byte " << at_ + sizeof(Number);
      return number;
    }
    std::memcpy(&number, &bytes_[at_], sizeof number);
    at_ += sizeof number;
    return number;
  }
  double real() { return get<double>(); }
  float real32() { return get<float>(); }
  std::uint32_t count() { return get<std::uint32_t>(); }
  std::uint8_t octet() { return get<std::uint8_t>(); }
  std::string string() {
    const std::uint32_t size = count();
    if (size == 0 || at_ + size > bytes_.size() || bytes_[at_ + size - 1] != 0) {
      ADD_FAILURE() << "no string at byte " << at_;
      return {};
    }
    std::string text(bytes_.begin() + static_cast<std::ptrdiff_t>(at_),
                     bytes_.begin() + static_cast<std::ptrdiff_t>(at_ + size - 1));
    at_ += size;
    return text;
  }
  std::vector<double> reals(std::size_t n) {
    std::vector<double> numbers;
    for (std::size_t i = 0; i < n; ++i) numbers.push_back(real());
    return numbers;
  }
  void expect_header(const dds::Stamp& stamp, const std::string& frame_id) {
    EXPECT_EQ(get<std::int32_t>(), stamp.seconds);
    EXPECT_EQ(get<std::uint32_t>(), stamp.nanoseconds);
    EXPECT_EQ(string(), frame_id);
  }
  /// Behind the encapsulation header.
  [[nodiscard]] std::size_t offset() const noexcept { return at_ - 4; }
  void expect_end() const { EXPECT_EQ(at_, bytes_.size()) << "bytes behind the last field"; }

 private:
  dds::Bytes bytes_;
  std::size_t at_ = 4;
};

/// "00 01 00 00 ..." as bytes.
[[nodiscard]] inline dds::Bytes hex(const std::string& text) {
  dds::Bytes bytes;
  for (std::size_t i = 0; i + 1 < text.size();) {
    if (text[i] == ' ' || text[i] == '\n') {
      ++i;
      continue;
    }
    bytes.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
    i += 2;
  }
  return bytes;
}

}  // namespace slackwater::tests

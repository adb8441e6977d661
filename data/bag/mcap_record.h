#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater::bag {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// The kinds of record of an MCAP file that matter here, and the eight bytes at either end of it.
/// Source: MCAP specification, https://mcap.dev/spec.
enum class McapOp : std::uint8_t {
  none = 0x00,  ///< of no record: a file with a hole in it
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  summary_offset = 0x0E,
  data_end = 0x0F,
};
inline constexpr std::array<std::uint8_t, 8> mcap_magic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t mcap_record_head = 9;    ///< kind and length
inline constexpr std::size_t mcap_message_head = 22;  ///< channel, sequence, two times
inline constexpr std::size_t mcap_footer = 20;

/// Writes records at the end of `bytes`. Numbers are little endian.
class McapRecords {
 public:
  explicit McapRecords(Bytes& bytes) : bytes_(&bytes) {}
  void begin(McapOp op);
  void end();  ///< the length is known now

  template <typename Number>
  void number(Number value) {
    const std::size_t at = bytes_->size();
    bytes_->resize(at + sizeof(Number));
    store(at, value);
  }
  void text(std::string_view value);  ///< 32 bits of length, then the bytes
  void raw(ByteView value) { bytes_->insert(bytes_->end(), value.begin(), value.end()); }

  /// Keeps room for the length of a map or array, which `end_list` fills in.
  void begin_list();
  void end_list();

 private:
  template <typename Number>
  void store(std::size_t at, Number value) {
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      (*bytes_)[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  }

  Bytes* bytes_;
  std::size_t record_ = 0;  ///< where the length of the record stands
  std::size_t list_ = 0;
};

/// Reads the fields of a record one after the other. What goes beyond the record throws
/// Error(invalid_input).
class McapFields {
 public:
  explicit McapFields(ByteView bytes) : bytes_(bytes) {}

  template <typename Number>
  Number number() {
    const ByteView field = raw(sizeof(Number));
    Number value = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i)
      value = static_cast<Number>(value | static_cast<Number>(field[i]) << (8 * i));
    return value;
  }
  std::string text();
  ByteView raw(std::uint64_t length);
  [[nodiscard]] std::size_t left() const noexcept { return bytes_.size(); }
  /// A time of a message, in nanoseconds; beyond the year 2262 it is damage.
  std::int64_t time_ns();

 private:
  ByteView bytes_;
};

/// A record within bytes that hold nothing but records.
struct McapRecord {
  McapOp op{};
  ByteView content;
};

/// Takes the next record from the front of `bytes`, which must not be empty. A record that goes
/// beyond them throws Error(invalid_input).
[[nodiscard]] McapRecord take_record(ByteView& bytes);

}  // namespace slackwater::bag

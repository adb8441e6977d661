#pragma once
#include <initializer_list>

#include "api/door/dds/intake/datagram.h"
#include "tests/api/door/dds/cdr_by_hand.h"

namespace slackwater::tests {

// Entities of discovery (OMG DDSI-RTPS 2.3, table 9.2 and 9.3), as a pair of writer and reader.
struct Ends {
  std::uint32_t writer, reader;
};
inline constexpr Ends participants{0x000100C2, 0x000100C7};
inline constexpr Ends publications{0x000003C2, 0x000003C7};
inline constexpr Ends subscriptions{0x000004C2, 0x000004C7};
inline constexpr Ends liveliness{0x000200C2, 0x000200C7};
inline constexpr Ends all_discovery[] = {participants, publications, subscriptions, liveliness};
inline constexpr Ends of_a_topic{0x00000103, 0x00000104};

/// Fields one behind the other, little endian, as a body of RTPS has them.
class Fields {
 public:
  template <typename Number>
  Fields& put(Number number) {
    const auto bytes = bytes_of(number, Order::little);
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  Fields& raw(dds::Payload bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    return *this;
  }
  Fields& entity(std::uint32_t id) { return raw(bytes_of(id, Order::big)); }
  /// As most bodies have them.
  Fields& ends(const Ends& of) { return entity(of.reader).entity(of.writer); }
  Fields& number(std::int64_t of_sample) {
    return put(static_cast<std::uint32_t>(static_cast<std::uint64_t>(of_sample) >> 32U))
        .put(static_cast<std::uint32_t>(of_sample));
  }
  Fields& zeros(std::size_t count) { return raw(dds::Bytes(count)); }
  Fields& parameter(std::uint16_t id, const Fields& value) {
    const std::size_t padded = (value.bytes_.size() + 3) / 4 * 4;
    return put(id)
        .put(static_cast<std::uint16_t>(padded))
        .raw(value.bytes_)
        .zeros(padded - value.bytes_.size());
  }
  /// Ends a list of parameters.
  Fields& end() { return put(std::uint16_t{1}).put(std::uint16_t{0}); }
  [[nodiscard]] const dds::Bytes& bytes() const noexcept { return bytes_; }

 private:
  dds::Bytes bytes_;
};

/// Where a forged participant says that it listens.
struct ForgedPlace {
  std::uint16_t port = 7;
  std::uint32_t lease_s = 20;
};

/// A sample that announces a participant.
[[nodiscard]] inline dds::Bytes forged_announcement(const dds::Prefix& of,
                                                    const ForgedPlace& place = {}) {
  constexpr std::uint32_t as_fast_dds = 0x0C3F;  // announces, detects, tells of liveliness
  const auto locator = [&] {
    return Fields()
        .put(1U)
        .put(std::uint32_t{place.port})
        .zeros(12)
        .raw(std::array<std::uint8_t, 4>{127, 0, 0, 1});
  };
  return Fields()
      .raw(std::array<std::uint8_t, 4>{0, 3, 0, 0})
      .parameter(0x15, Fields().put(std::uint16_t{0x0302}))
      .parameter(0x16, Fields().put(std::uint16_t{0x0F01}))
      .parameter(0x50, Fields().raw(of).entity(0x000001C1))
      .parameter(0x32, locator())
      .parameter(0x31, locator())
      .parameter(0x02, Fields().put(place.lease_s).put(0U))
      .parameter(0x58, Fields().put(as_fast_dds))
      .end()
      .bytes();
}

/// A datagram, submessage by submessage, and whatever of it is wrong.
class ForgedRtps {
 public:
  explicit ForgedRtps(const dds::Prefix& from) {
    made_.raw(std::array<std::uint8_t, 8>{'R', 'T', 'P', 'S', 2, 3, 1, 0x0F}).raw(from);
  }
  /// @param length  as it says; 0: to the end of the datagram
  ForgedRtps& part(std::uint8_t kind, std::uint8_t flags, const Fields& body,
                   std::optional<std::uint16_t> length = {}) {
    made_.put(kind).put(flags).put(
        length.value_or(static_cast<std::uint16_t>(body.bytes().size())));
    made_.raw(body.bytes());
    return *this;
  }
  ForgedRtps& to(const dds::Prefix& participant) {
    return part(0x0E, 1, Fields().raw(participant));
  }
  ForgedRtps& data(const Ends& ends, std::int64_t number, dds::Payload sample,
                   std::uint16_t to_inline_qos = 16, std::uint8_t flags = 5) {
    return part(
        0x15, flags,
        Fields().put(std::uint16_t{0}).put(to_inline_qos).ends(ends).number(number).raw(sample));
  }
  ForgedRtps& announce(const dds::Prefix& participant, const ForgedPlace& place = {},
                       std::int64_t number = 1) {
    return data({participants.writer, 0}, number, forged_announcement(participant, place));
  }
  struct PieceOf {
    std::int64_t number = 1;
    std::uint32_t first = 1;
    std::uint16_t count = 1;
    std::uint16_t piece_bytes = 1024;
    std::uint32_t sample_bytes = 4096;
    std::size_t sent = 1024;
  };
  ForgedRtps& piece(const Ends& ends, const PieceOf& of) {
    return part(0x16, 1,
                Fields()
                    .put(std::uint16_t{0})
                    .put(std::uint16_t{28})
                    .ends(ends)
                    .number(of.number)
                    .put(of.first)
                    .put(of.count)
                    .put(of.piece_bytes)
                    .put(of.sample_bytes)
                    .zeros(of.sent));
  }
  ForgedRtps& heartbeat(const Ends& ends, std::int64_t first, std::int64_t last,
                        std::uint32_t count = 1) {
    return part(0x07, 1, Fields().ends(ends).number(first).number(last).put(count));
  }
  /// @param words  of the set that follow, whatever its bits
  ForgedRtps& gap(const Ends& ends, std::int64_t start, std::int64_t base, std::uint32_t bits = 0,
                  std::size_t words = 0) {
    return part(0x08, 1, Fields().ends(ends).number(start).number(base).put(bits).zeros(4 * words));
  }
  ForgedRtps& acknack(const Ends& ends, std::int64_t base, std::uint32_t bits, dds::Payload set,
                      std::uint32_t count = 1) {
    return part(0x06, 1, Fields().ends(ends).number(base).put(bits).raw(set).put(count));
  }
  [[nodiscard]] const dds::Bytes& bytes() const noexcept { return made_.bytes(); }

 private:
  Fields made_;
};

}  // namespace slackwater::tests

#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace slackwater::dds {

/// A participant, by its GUID prefix.
using Prefix = std::array<std::uint8_t, 12>;

/// A part of a sample that is too long for one datagram (DATA_FRAG).
struct Piece {
  Prefix from{};
  std::uint32_t writer = 0;  ///< its entity
  std::int64_t number = 0;   ///< of the sample
  std::uint16_t piece_bytes = 0;
  std::uint32_t sample_bytes = 0;
};

/// What a datagram of RTPS claims, as far as somebody has to pay for it who believes it.
struct Datagram {
  std::string_view fault;           ///< why it is none, in words; empty: it is sound
  Prefix from{};                    ///< the participant that speaks
  bool is_announcement = false;     ///< says that this participant is there, and nothing else
  std::size_t discovery_bytes = 0;  ///< of what it says of its readers and writers
  std::uint64_t skipped = 0;        ///< samples that are said never to come (GAP)
  bool has_pieces = false;
  /// Where the seconds of an announcement's lease stand. A peer may say it again in one datagram.
  struct Lease {
    std::size_t at = 0;
    bool is_little_endian = true;
  };
  static constexpr std::size_t most_leases = 4;
  std::array<Lease, most_leases> lease{};
  std::size_t leases = 0;
};

/// Beyond these, a claim is none that a peer of ours makes. Fast DDS 2.9.1 counts up to a number
/// that it is told one by one, at 0.2 us each, and makes room for a sample by what is said of it.
constexpr std::int64_t most_samples = 1LL << 26;            ///< of a writer: 7.7 days at 100 Hz
constexpr std::int64_t most_discovery_samples = 1LL << 20;  ///< of one that tells of the others
constexpr std::uint32_t most_sample_bytes = 4U << 20U;
constexpr std::uint32_t most_discovery_sample_bytes = 256U << 10U;
constexpr std::uint16_t least_piece_bytes = 256;

/// Reads header and submessages, each to its end. What it lets pass is within its datagram and
/// within the limits above, and speaks for nobody but its sender; whether it makes sense to anybody
/// is the library's to find out. Kinds that nobody knows are passed over, as RTPS has it.
/// Source: OMG DDSI-RTPS 2.3 (formal/2019-04-03), 8.3.7 and 9.4.5; discovery: 9.6.2.2.
[[nodiscard]] Datagram read_datagram(std::span<const std::uint8_t> bytes) noexcept;

/// Of one that is sound.
void for_each_piece(std::span<const std::uint8_t> bytes,
                    const std::function<void(const Piece&)>& visit);

}  // namespace slackwater::dds

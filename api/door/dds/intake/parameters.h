#pragma once
#include <optional>

#include "api/door/dds/intake/datagram.h"

namespace slackwater::dds {

/// A list of parameters (RTPS 2.3, 9.4.2.11): each with its length, a multiple of four, up to the
/// one that ends it.
/// @return its octets; 0: it has no end
[[nodiscard]] std::size_t end_of_parameters(std::span<const std::uint8_t> bytes,
                                            bool is_little_endian) noexcept;

/// Whether a sample says of itself that it is such a list.
[[nodiscard]] bool is_parameter_list(std::span<const std::uint8_t> sample) noexcept;

/// What discovery tells of a participant, a reader or a writer, as far as it matters here.
struct Announced {
  bool is_list = false;  ///< else all below is nothing
  bool is_little_endian = true;
  bool is_of_sender = true;             ///< who tells it is the participant that it is about
  std::optional<std::size_t> lease_at;  ///< of the seconds of its lease, in the sample
};
[[nodiscard]] Announced read_announced(std::span<const std::uint8_t> sample,
                                       const Prefix& sender) noexcept;

}  // namespace slackwater::dds

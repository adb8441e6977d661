#pragma once
#include <map>
#include <utility>

#include "api/door/dds/intake/datagram.h"

namespace slackwater::dds {

/// Samples of which pieces have come. The library keeps what it was told of a sample with its first
/// piece, makes room by that, and believes every later piece: so all must tell the same. Of each
/// writer so many of the newest are remembered, and pieces of older ones refused.
class BegunSamples {
 public:
  enum class Found { known, begun, refused };
  /// Of a piece that is to be let in.
  Found look(const Piece& piece);
  void forget(const Prefix& participant);

 private:
  static constexpr std::size_t most_of_a_writer = 64;  ///< as many as a reader keeps out of order
  static constexpr std::size_t most = 16'384;

  using ByNumber = std::map<std::int64_t, Piece>;
  std::map<std::pair<Prefix, std::uint32_t>, ByNumber> writers_;
  std::size_t count_ = 0;
};

}  // namespace slackwater::dds

#pragma once
#include <map>

#include "api/door/dds/intake/datagram.h"

namespace slackwater::dds {

/// Samples of which pieces have come. The library keeps what it was told of a sample with its first
/// piece, makes room by that, and believes every later piece: so all must tell the same. Of each
/// writer and of each participant so many of the newest are remembered. The oldest make room, and
/// pieces of what made room are refused from then on, as of all that is older from that writer.
class BegunSamples {
 public:
  static constexpr std::size_t most_of_a_writer = 64;  ///< as many as a reader keeps out of order
  static constexpr std::size_t most_of_a_participant = 256;  ///< samples, and writers too

  enum class Found { known, fresh, refused };
  /// What a piece is of. It is remembered once it is let in.
  [[nodiscard]] Found look(const Piece& piece) const;
  /// @param piece  that was found fresh
  void remember(const Piece& piece);
  void forget(const Prefix& participant) { of_.erase(participant); }

 private:
  struct OfWriter {
    std::map<std::int64_t, Piece> samples;  ///< by their number
    std::int64_t made_room = 0;             ///< the greatest number that did
    void make_room();
  };
  struct OfParticipant {
    std::map<std::uint32_t, OfWriter> writers;
    std::size_t samples = 0;
  };
  std::map<Prefix, OfParticipant> of_;
};

}  // namespace slackwater::dds

#pragma once
#include <cstdint>
#include <memory>
#include <string_view>

#include "data/bag/mcap_record.h"

namespace slackwater::bag {

/// The largest chunk that is read, in bytes, on the disk or unpacked: it is held in memory whole.
inline constexpr std::uint64_t largest_chunk = std::uint64_t{512} << 20U;

/// Unpacks the records of a chunk into `out`, whose memory is used again.
///
/// @param compression  "", "zstd" or "lz4" (frames)
/// @param size         what it must come to, in bytes; no more than `largest_chunk`
/// Memory is taken as the data come, not as they claim. Throws Error(invalid_input) where they are
/// damaged, come to another size, or are compressed in another way.
void unpack_chunk(std::string_view compression, ByteView packed, std::uint64_t size, Bytes& out);

/// Packs with zstd, at its fastest regular level.
class ZstdPacker {
 public:
  ZstdPacker();
  ~ZstdPacker();
  ZstdPacker(const ZstdPacker&) = delete;
  ZstdPacker& operator=(const ZstdPacker&) = delete;
  /// At the end of `out`.
  void pack(ByteView bytes, Bytes& out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace slackwater::bag

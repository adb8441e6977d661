#pragma once
#include <cstdint>
#include <vector>

#include "data/bag/mcap_record.h"

namespace slackwater::bag {

/// Log times of messages, in nanoseconds; 0 and 0 where there are none.
struct McapTimes {
  std::int64_t first_ns = 0;
  std::int64_t last_ns = 0;
  bool is_empty = true;

  void take(std::int64_t time_ns) noexcept;
};

/// A chunk that was written.
struct McapChunk {
  McapTimes times;
  std::uint64_t offset = 0;          ///< of its record in the file
  std::uint64_t length = 0;          ///< of its record, with the head
  std::uint64_t indexes_length = 0;  ///< of the message indexes behind it
  std::uint64_t packed = 0;
  std::uint64_t unpacked = 0;
  Bytes index_offsets;  ///< channel and offset of each, as they stand in the chunk's index
};

/// Gathers what the end of an MCAP file says of the rest, and writes it: the end of the data, the
/// summary, where in it what stands, the footer.
class McapEnding {
 public:
  /// Records as they were written.
  void take_schema(ByteView record);
  void take_channel(ByteView record);
  void take_chunk(const McapChunk& chunk);
  /// Messages of a channel, which counts from 1.
  void count(std::uint16_t channel, std::uint64_t messages) { counts_[channel - 1U] += messages; }

  /// Appends to `out` what belongs at `offset` of the file.
  void write(std::uint64_t offset, Bytes& out) const;

 private:
  void write_statistics(McapRecords& records) const;

  Bytes schemas_;
  Bytes channels_;
  Bytes chunk_indexes_;
  std::uint16_t schema_count_ = 0;
  std::uint32_t chunk_count_ = 0;
  std::vector<std::uint64_t> counts_;  ///< messages of each channel
  McapTimes times_;
};

}  // namespace slackwater::bag

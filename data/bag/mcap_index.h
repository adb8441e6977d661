#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "data/bag/channel_table.h"
#include "data/bag/input_file.h"
#include "data/bag/mcap_record.h"

namespace slackwater::bag {

/// A stretch of an MCAP file with messages in it, which is read as a whole: a chunk, or records
/// that lie in the file one after the other.
struct McapStretch {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;   ///< in the file; of a chunk its record, with the head
  std::int64_t first_ns = 0;  ///< no message in it is earlier
  bool is_chunk = false;
};

/// Where the messages of an MCAP file are, and of which channels.
struct McapIndex {
  ChannelTable channels;
  std::vector<McapStretch> stretches;  ///< as they lie in the file
  std::vector<std::string> warnings;
};

/// Reads the summary, and whatever the summary does not speak of. Where there is none, or it is
/// damaged, every chunk is unpacked once, up to the first damage: of that and of a file that ends
/// too early a warning tells.
///
/// Throws Error(invalid_input) where it is no MCAP file or a channel is not CDR.
[[nodiscard]] McapIndex index_of(const InputFile& file);

/// The records of a stretch, unpacked and their sum checked. `file_bytes` is memory to work in.
/// Throws Error(invalid_input) where they are damaged.
void read_stretch(const InputFile& file, const McapStretch& stretch, Bytes& file_bytes,
                  Bytes& records);

}  // namespace slackwater::bag

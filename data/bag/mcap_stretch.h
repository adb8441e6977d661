#pragma once
#include <cstdint>

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

/// The records of a stretch, unpacked and their sum checked. `file_bytes` is memory to work in.
/// Throws Error(invalid_input) where they are damaged.
void read_stretch(const InputFile& file, const McapStretch& stretch, Bytes& file_bytes,
                  Bytes& records);

}  // namespace slackwater::bag

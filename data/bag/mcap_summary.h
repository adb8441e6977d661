#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "data/bag/input_file.h"
#include "data/bag/mcap_definitions.h"
#include "data/bag/mcap_stretch.h"

namespace slackwater::bag {

/// Where the chunks of an MCAP file are, as the end of the file tells.
struct McapSummary {
  struct Chunk {
    McapStretch stretch;
    std::uint64_t end = 0;  ///< of it and its message indexes
  };
  std::vector<Chunk> chunks;  ///< as they lie in the file, one after the other
};

/// The summary, its sum checked; its schemas and channels go into `definitions`. Nothing where the
/// file has none, or none that names channels. Throws Error(invalid_input) where it is damaged.
[[nodiscard]] std::optional<McapSummary> read_summary(const InputFile& file,
                                                      McapDefinitions& definitions);

}  // namespace slackwater::bag

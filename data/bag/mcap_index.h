#pragma once
#include <string>
#include <vector>

#include "data/bag/channel_table.h"
#include "data/bag/input_file.h"
#include "data/bag/mcap_stretch.h"

namespace slackwater::bag {

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

}  // namespace slackwater::bag

#pragma once
#include <filesystem>
#include <memory>

#include "data/bag/recording_format.h"

namespace slackwater::bag {

/// An MCAP file of profile "ros2": schemas in "ros2msg", messages in "cdr".
///
/// A batch is a chunk (zstd), followed by its message indexes, written in one piece; schemas and
/// channels stand before the first chunk that needs them. So a file that was left in the middle
/// lacks its summary and at most the last chunk, which readers of streams do without. When the disk
/// refuses a piece the file is cut back to the last whole one.
[[nodiscard]] std::unique_ptr<RecordingFormat> begin_mcap(const std::filesystem::path& file);

}  // namespace slackwater::bag

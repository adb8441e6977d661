#pragma once
#include <filesystem>
#include <memory>

#include "data/bag/recording_format.h"

namespace slackwater::bag {

/// A rosbag2 folder FOLDER: metadata.yaml (version 5) and FOLDER_0.db3 (SQLite, schema version 4).
///
/// A batch is a transaction, with a rollback journal and not with a write-ahead log: some readers
/// take the file for immutable, and see no log. metadata.yaml is there from the start and replaced
/// after each batch, so a folder that was left in the middle opens.
[[nodiscard]] std::unique_ptr<RecordingFormat> begin_rosbag(const std::filesystem::path& folder);

}  // namespace slackwater::bag

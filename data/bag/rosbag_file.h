#pragma once
#include <filesystem>
#include <memory>

#include "data/bag/bag.h"

namespace slackwater::bag {

/// A SQLite file of rosbag2, of any schema version. What an interrupted writer left half done is
/// rolled back, for which the folder must be writable. Nothing is run that the file brings along:
/// views, triggers, generated columns.
[[nodiscard]] std::unique_ptr<Bag> open_rosbag_file(const std::filesystem::path& file);

}  // namespace slackwater::bag

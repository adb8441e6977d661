#pragma once
#include <filesystem>
#include <memory>
#include <vector>

#include "data/bag/bag.h"

namespace slackwater::bag {

/// The files of a rosbag2 folder: those that metadata.yaml names, or where that is missing all
/// that are called *.db3 or *.mcap, by name. Throws as `open_bag` does.
[[nodiscard]] std::vector<std::filesystem::path> files_of_folder(
    const std::filesystem::path& folder);

/// Several files as one recording. Each is opened once for its channels and its first message, and
/// again when its time comes: no more are open than overlap in time.
[[nodiscard]] std::unique_ptr<Bag> open_files(std::vector<std::filesystem::path> files);

/// One file of either kind.
[[nodiscard]] std::unique_ptr<Bag> open_file(const std::filesystem::path& file);

}  // namespace slackwater::bag

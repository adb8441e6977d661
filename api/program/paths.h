#pragma once
#include <filesystem>
#include <vector>

namespace slackwater::api {

/// The folder that holds `products/` and `sites/`: $SLACKWATER_DATA, else `share/slackwater` beside
/// the installed program, else the source tree it was built from. Throws Error(not_found).
[[nodiscard]] std::filesystem::path data_folder();

/// Where sites are looked for: the store's own `sites/`, then the data folder's.
[[nodiscard]] std::vector<std::filesystem::path> site_folders(const std::filesystem::path& store);

}  // namespace slackwater::api

#pragma once
#include <filesystem>
#include <optional>
#include <vector>

namespace slackwater::api {

/// The folder that holds `products/` and `sites/`: $SLACKWATER_DATA, else `share/slackwater` beside
/// the installed program, else the source tree it was built from. Throws Error(not_found).
[[nodiscard]] std::filesystem::path data_folder();

/// Where the files of the detector of hands are looked for: `hands` in the data folder, else where
/// the build that made the program has fetched them. There may be none.
[[nodiscard]] std::filesystem::path hand_detector_folder();

/// The user's `$XDG_CONFIG_HOME/slackwater`, else `~/.config/slackwater`, whether it is there or
/// not; nothing where the user has no home.
[[nodiscard]] std::optional<std::filesystem::path> own_config_folder();

/// Where product descriptors are looked for beside the data folder's `products/`: `products` in the
/// user's own folder; nothing where there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> own_product_folders();

/// Where sites are looked for: the store's own `sites/`, then the data folder's.
[[nodiscard]] std::vector<std::filesystem::path> site_folders(const std::filesystem::path& store);

}  // namespace slackwater::api

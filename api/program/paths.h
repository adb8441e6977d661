#pragma once
#include <filesystem>
#include <vector>

namespace slackwater::api {

/// The folder that holds `products/` and `sites/`: $SLACKWATER_DATA, else `share/slackwater` beside
/// the installed program, else the source tree it was built from. Throws Error(not_found).
[[nodiscard]] std::filesystem::path data_folder();

/// Where product descriptors are looked for beside the data folder's `products/`: the user's
/// `$XDG_CONFIG_HOME/slackwater/products`, else `~/.config/slackwater/products`; nothing where
/// there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> own_product_folders();

/// Where sites are looked for: the store's own `sites/`, then the data folder's.
[[nodiscard]] std::vector<std::filesystem::path> site_folders(const std::filesystem::path& store);

}  // namespace slackwater::api

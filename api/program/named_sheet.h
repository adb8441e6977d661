#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::api {

/// Ids of the sheets (YAML) in a folder of the program's data, sorted; none where it is not there.
/// @param kind  the folder: "tasks", "vessels"
[[nodiscard]] std::vector<std::string> known_sheets(const std::string& kind);

/// A sheet of that folder by its id, else a file, counted from a folder.
/// @param key  under which it was named, for the error
/// @throws Error(not_found) that lists the ids and names the nearest
[[nodiscard]] Config load_sheet(const std::string& kind, const std::string& key,
                                const std::string& id, const std::filesystem::path& folder);

}  // namespace slackwater::api

#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "data/store/database.h"

namespace slackwater::store {

/// Size in bytes of each content file that a granule or a forecast names, by sha256.
[[nodiscard]] std::map<std::string, std::uint64_t> named_contents(Database& database);

struct FoundFile {
  std::filesystem::path path;
  std::string sha256;  ///< by its name; "" where the name is not that of a content file
  std::uint64_t bytes = 0;
};

/// Everything below files/, in order of path.
[[nodiscard]] std::vector<FoundFile> scan_files(const std::filesystem::path& folder);

}  // namespace slackwater::store

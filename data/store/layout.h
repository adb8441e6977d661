#pragma once
#include <filesystem>
#include <string>

namespace slackwater::store {

/// Where things lie in a store's folder.
[[nodiscard]] inline std::filesystem::path catalogue_file(const std::filesystem::path& folder) {
  return folder / "catalogue.sqlite";
}
[[nodiscard]] inline std::filesystem::path files_folder(const std::filesystem::path& folder) {
  return folder / "files";
}
[[nodiscard]] inline std::filesystem::path staging_root(const std::filesystem::path& folder) {
  return folder / "staging";
}
[[nodiscard]] inline std::filesystem::path content_file(const std::filesystem::path& folder,
                                                        const std::string& content_sha256) {
  return files_folder(folder) / content_sha256.substr(0, 2) / (content_sha256 + ".nc");
}

}  // namespace slackwater::store

#include "api/program/paths.h"

#include <cstdlib>

#include "fields/base/error.h"

namespace slackwater::api {

std::filesystem::path data_folder() {
  if (const char* named = std::getenv("SLACKWATER_DATA")) {
    if (std::filesystem::is_directory(std::filesystem::path(named) / "products")) return named;
    throw Error(ErrorKind::not_found,
                std::string("found no products folder below SLACKWATER_DATA=") + named +
                    "; point it at Slackwater's data folder");
  }
  std::error_code ignored;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
  const auto installed = program.parent_path().parent_path() / "share" / "slackwater";
  for (const std::filesystem::path& folder :
       {installed, std::filesystem::path(SLACKWATER_SOURCE_DATA)}) {
    if (std::filesystem::is_directory(folder / "products")) return folder;
  }
  throw Error(ErrorKind::not_found,
              "found no data folder with product descriptors; set SLACKWATER_DATA to it");
}

std::filesystem::path hand_detector_folder() {
  const std::filesystem::path own = data_folder() / "hands";
  std::error_code ignored;
  return std::filesystem::is_directory(own, ignored) ? own : SLACKWATER_BUILT_HAND_DETECTOR;
}

std::optional<std::filesystem::path> own_config_folder() {
  // A relative path is to be taken for none (XDG Base Directory Specification).
  const char* named = std::getenv("XDG_CONFIG_HOME");
  if (named != nullptr && std::filesystem::path(named).is_absolute())
    return std::filesystem::path(named) / "slackwater";
  const char* home = std::getenv("HOME");
  if (home != nullptr && std::filesystem::path(home).is_absolute())
    return std::filesystem::path(home) / ".config" / "slackwater";
  return std::nullopt;
}

std::vector<std::filesystem::path> own_product_folders() {
  const auto config = own_config_folder();
  if (!config) return {};
  const std::filesystem::path folder = *config / "products";
  std::error_code unreadable;
  if (!std::filesystem::is_directory(folder, unreadable)) return {};
  return {folder};
}

std::vector<std::filesystem::path> site_folders(const std::filesystem::path& store) {
  return {store / "sites", data_folder() / "sites"};
}

}  // namespace slackwater::api

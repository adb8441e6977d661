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

std::vector<std::filesystem::path> own_product_folders() {
  // A relative path is to be taken for none (XDG Base Directory Specification).
  std::filesystem::path config;
  const char* named = std::getenv("XDG_CONFIG_HOME");
  const char* home = std::getenv("HOME");
  if (named != nullptr && std::filesystem::path(named).is_absolute()) {
    config = named;
  } else if (home != nullptr && std::filesystem::path(home).is_absolute()) {
    config = std::filesystem::path(home) / ".config";
  }
  if (config.empty()) return {};
  const std::filesystem::path folder = config / "slackwater" / "products";
  std::error_code unreadable;
  if (!std::filesystem::is_directory(folder, unreadable)) return {};
  return {folder};
}

std::vector<std::filesystem::path> site_folders(const std::filesystem::path& store) {
  return {store / "sites", data_folder() / "sites"};
}

}  // namespace slackwater::api

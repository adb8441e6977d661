#include "twin/curve/named_file.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/error.h"

namespace slackwater::twin {

namespace {

/// What there is in its place; nothing where the name is one of those in the folder.
std::optional<std::string> why_not(const std::string& name, const std::filesystem::path& folder) {
  std::vector<std::string> known;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".yaml") known.push_back(entry.path().stem().string());
  }
  if (std::find(known.begin(), known.end(), name) != known.end()) return std::nullopt;
  std::sort(known.begin(), known.end());
  std::string list;
  for (const std::string& word : known) list += " " + word;
  return "found " + name + ", expected one of those in " + folder.string() + ":" +
         (list.empty() ? " (none)" : list);
}

}  // namespace

Config open_named(const Config& config, std::string_view key, const std::filesystem::path& folder) {
  const std::string name = config.text(key);
  if (const auto why = why_not(name, folder)) config.refuse(key, *why);
  return Config::load(folder / (name + ".yaml"));
}

Config open_named(const std::string& name, std::string_view what,
                  const std::filesystem::path& folder) {
  if (const auto why = why_not(name, folder))
    throw Error(ErrorKind::invalid_input, std::string(what) + ": " + *why);
  return Config::load(folder / (name + ".yaml"));
}

}  // namespace slackwater::twin

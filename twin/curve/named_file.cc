#include "twin/curve/named_file.h"

#include <algorithm>

namespace slackwater::twin {

Config open_named(const Config& config, std::string_view key, const std::filesystem::path& folder) {
  const std::string name = config.text(key);
  std::vector<std::string> known;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() == ".yaml") known.push_back(entry.path().stem().string());
  }
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    std::sort(known.begin(), known.end());
    std::string list;
    for (const std::string& word : known) list += " " + word;
    config.refuse(key, "found " + name + ", expected one of those in " + folder.string() + ":" +
                           (list.empty() ? " (none)" : list));
  }
  return Config::load(folder / (name + ".yaml"));
}

}  // namespace slackwater::twin

#pragma once
#include <map>
#include <string>
#include <string_view>

namespace slackwater {

/// Where the keys of a YAML file stand, for what is said of a value long after it was read.
struct KeyPlaces {
  std::string file;
  std::map<std::string, int, std::less<>> line;  ///< from 1, by dotted key: `mounts[0].direction`

  /// "FILE:LINE" of a key; of one that is not there, of the nearest one around it, else "FILE".
  [[nodiscard]] std::string of(std::string_view dotted_key) const {
    for (std::string_view key = dotted_key; !key.empty();) {
      if (const auto found = line.find(key); found != line.end())
        return file + ":" + std::to_string(found->second);
      const std::size_t end = key.find_last_of(".[");
      key = key.substr(0, end == std::string_view::npos ? 0 : end);
    }
    return file;
  }
};

}  // namespace slackwater

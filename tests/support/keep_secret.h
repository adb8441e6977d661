#pragma once
#include <filesystem>

namespace slackwater::tests {

/// A file of tokens, as its readers want it: nobody else's to read.
inline void keep_secret(const std::filesystem::path& file) {
  std::filesystem::permissions(
      file, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

}  // namespace slackwater::tests

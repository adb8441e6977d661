#include "tests/support/shared_data.h"

#include <cstdlib>

namespace slackwater::tests {

std::filesystem::path source_folder() { return SLACKWATER_SOURCE_DIR; }

std::optional<std::filesystem::path> shared_folder() {
  const char* named = std::getenv("SLACKWATER_SHARED");
  const std::filesystem::path folder =
      named != nullptr ? std::filesystem::path(named) : source_folder() / ".." / "shared";
  if (!std::filesystem::is_directory(folder / "data")) return std::nullopt;
  return std::filesystem::canonical(folder);
}

}  // namespace slackwater::tests

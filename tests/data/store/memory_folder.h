#pragma once
#include <stdlib.h>

#include <filesystem>
#include <optional>
#include <string>

#include "tests/support/temporary_folder.h"

namespace slackwater::store::tests {

/// A fresh folder in memory, where there is such a file system: its fsync costs nothing.
class MemoryFolder {
 public:
  MemoryFolder() {
    std::string form = "/dev/shm/slackwater-test-XXXXXX";
    if (::mkdtemp(form.data()) != nullptr) {
      path_ = form;
    } else {
      otherwise_.emplace();
      path_ = otherwise_->path();
    }
  }
  ~MemoryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  MemoryFolder(const MemoryFolder&) = delete;
  MemoryFolder& operator=(const MemoryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
  std::optional<slackwater::tests::TemporaryFolder> otherwise_;
};

}  // namespace slackwater::store::tests

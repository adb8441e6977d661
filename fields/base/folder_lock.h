#pragma once
#include <filesystem>

#include "fields/base/descriptor.h"

namespace slackwater {

/// Holds a folder for one process; let go when it is over, however it ends.
class FolderLock {
 public:
  /// @throws Error(unavailable) where another one holds it, or it cannot be locked
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  Descriptor folder_;
};

}  // namespace slackwater

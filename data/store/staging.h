#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "data/store/durable.h"

namespace slackwater::store {

/// A process's own folder below staging/, named <pid>-<random>. A lock (flock) on the folder says
/// that its owner lives; unlike the pid it is never reused and is seen from other containers. Gone
/// with its owner.
class StagingFolder {
 public:
  [[nodiscard]] static StagingFolder make(const std::filesystem::path& store_folder);
  StagingFolder(StagingFolder&&) noexcept = default;
  StagingFolder& operator=(StagingFolder&&) noexcept = default;
  ~StagingFolder();
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  StagingFolder(std::filesystem::path path, Descriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}
  std::filesystem::path path_;
  Descriptor lock_;
};

/// Folders whose owners are dead.
[[nodiscard]] std::vector<std::filesystem::path> stale_staging_folders(
    const std::filesystem::path& store_folder);
/// Removes them; the number removed.
std::size_t sweep_staging(const std::filesystem::path& store_folder);

}  // namespace slackwater::store

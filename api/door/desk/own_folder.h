#pragma once
#include <filesystem>

namespace slackwater::api::desk {

/// A folder for temporary files of one answer, of nobody else; gone with it.
class OwnFolder {
 public:
  /// @throws Error(unavailable)
  OwnFolder();
  ~OwnFolder();
  OwnFolder(const OwnFolder&) = delete;
  OwnFolder& operator=(const OwnFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace slackwater::api::desk

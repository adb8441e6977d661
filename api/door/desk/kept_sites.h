#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "fields/site/site.h"

namespace slackwater::api::desk {

/// The file of a site by its id; of no other file, whatever the id says.
/// @throws Error(not_found)
[[nodiscard]] SiteText described_text(const std::string& id,
                                      const std::filesystem::path& store_folder);

/// Sites as their files describe them, for who asks about all of them again and again. A file is
/// read each time, and its text is parsed anew only where it differs from what was parsed before:
/// an edit shows at once, whatever its time and size are. Thread-safe.
class KeptSites {
 public:
  /// What is kept at most, of texts: where more is asked for, all is dropped and begun anew.
  static constexpr std::size_t most_bytes = 16U << 20U;

  explicit KeptSites(std::filesystem::path store_folder, std::size_t most = most_bytes);

  /// By its id. @throws Error(not_found), Error(invalid_input); neither is kept
  [[nodiscard]] std::shared_ptr<const Site> site(const std::string& id);
  [[nodiscard]] std::size_t kept_bytes() const;
  [[nodiscard]] const std::filesystem::path& store_folder() const noexcept { return store_folder_; }

 private:
  struct Kept {
    std::string file;
    std::shared_ptr<const Site> site;
  };
  std::filesystem::path store_folder_;
  std::size_t most_;
  mutable std::mutex mutex_;
  std::map<std::string, Kept> kept_;
  std::size_t bytes_ = 0;
};

}  // namespace slackwater::api::desk

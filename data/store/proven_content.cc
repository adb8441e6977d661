#include "data/store/proven_content.h"

#include <sys/stat.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <map>
#include <mutex>

#include "data/store/layout.h"
#include "fields/base/check.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

/// What changes when a file is written, replaced or restored.
using Mark = std::array<std::int64_t, 7>;

Mark mark_of(const struct stat& found) {
  return {static_cast<std::int64_t>(found.st_dev),
          static_cast<std::int64_t>(found.st_ino),
          found.st_size,
          found.st_mtim.tv_sec,
          found.st_mtim.tv_nsec,
          found.st_ctim.tv_sec,
          found.st_ctim.tv_nsec};
}

struct Verdict {
  Mark mark{};
  std::optional<std::string> fault;
};

/// The verdicts of this process, by path.
class Verdicts {
 public:
  [[nodiscard]] std::optional<Verdict> find(const std::string& path, const Mark& mark) const {
    const std::lock_guard lock(guard_);
    const auto found = by_path_.find(path);
    if (found == by_path_.end() || found->second.mark != mark) return std::nullopt;
    return found->second;
  }
  void keep(const std::string& path, Verdict verdict) {
    const std::lock_guard lock(guard_);
    // A service that runs for months meets ever new files.
    if (by_path_.size() >= most) by_path_.clear();
    by_path_[path] = std::move(verdict);
  }

 private:
  static constexpr std::size_t most = 10'000;
  mutable std::mutex guard_;
  std::map<std::string, Verdict> by_path_;
};

Verdicts& verdicts() {
  static Verdicts all;
  return all;
}

}  // namespace

std::optional<std::string> content_fault(const std::filesystem::path& folder,
                                         const std::string& content_sha256) {
  expects(content_sha256.size() == 64, "a content file is named by 64 hexadecimal digits");
  const std::filesystem::path file = content_file(folder, content_sha256);
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return "is missing";
    return std::string("cannot be read: ") + std::strerror(errno);
  }
  const Mark mark = mark_of(found);
  std::error_code no_current_folder;  // then the path as given is as good a key
  const std::filesystem::path whole = std::filesystem::absolute(file, no_current_folder);
  const std::string path = no_current_folder ? file.string() : whole.string();
  if (const auto known = verdicts().find(path, mark)) return known->fault;
  Verdict verdict{mark, std::nullopt};
  try {
    if (sha256_of_file(file) != content_sha256)
      verdict.fault = "no longer holds the bytes that were stored (sha256 differs)";
  } catch (const Error& error) {
    return "cannot be read: " + error.message();  // may be over in a moment
  }
  // The verdict is on these bytes only if nobody wrote meanwhile.
  if (::stat(file.c_str(), &found) == 0 && mark_of(found) == mark) verdicts().keep(path, verdict);
  return verdict.fault;
}

std::filesystem::path proven_content(const std::filesystem::path& folder,
                                     const std::string& content_sha256) {
  std::filesystem::path file = content_file(folder, content_sha256);
  if (const auto fault = content_fault(folder, content_sha256)) {
    throw Error(ErrorKind::invalid_input,
                "content file " + file.string() + " " + *fault +
                    "; run `slackwater store check`, which says how to get it back");
  }
  return file;
}

}  // namespace slackwater::store

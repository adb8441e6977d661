#include "data/store/staging.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>

#include "data/store/layout.h"
#include "fields/base/error.h"

namespace slackwater::store {
namespace {

Descriptor locked(const std::filesystem::path& folder) {
  Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!descriptor.is_open()) return descriptor;
  return ::flock(descriptor.value(), LOCK_EX | LOCK_NB) == 0 ? std::move(descriptor)
                                                             : Descriptor(-1);
}

}  // namespace

StagingFolder StagingFolder::make(const std::filesystem::path& store_folder) {
  const std::filesystem::path root = staging_root(store_folder);
  make_folder(root);
  // Between making and locking, another process may take the new folder for a dead one's: then once
  // more.
  for (int attempt = 0; attempt < 100; ++attempt) {
    std::string form = (root / (std::to_string(::getpid()) + "-XXXXXX")).string();
    if (::mkdtemp(form.data()) == nullptr) {
      throw Error(ErrorKind::unavailable, "cannot make a staging folder in " + root.string() +
                                              ": " + std::strerror(errno) +
                                              "; check permissions and free space");
    }
    Descriptor lock = locked(form);
    struct stat ours {};
    struct stat named {};
    if (lock.is_open() && ::fstat(lock.value(), &ours) == 0 && ::stat(form.c_str(), &named) == 0 &&
        ours.st_ino == named.st_ino) {
      return {form, std::move(lock)};
    }
  }
  throw Error(ErrorKind::unavailable,
              "cannot lock a staging folder in " + root.string() +
                  "; its file system must support flock: choose another --store");
}

StagingFolder::~StagingFolder() {
  if (!lock_.is_open()) return;
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::vector<std::filesystem::path> stale_staging_folders(
    const std::filesystem::path& store_folder) {
  std::vector<std::filesystem::path> stale;
  std::error_code problem;
  for (std::filesystem::directory_iterator entry(staging_root(store_folder), problem), end;
       !problem && entry != end; entry.increment(problem)) {
    if (locked(entry->path()).is_open()) stale.push_back(entry->path());
  }
  std::ranges::sort(stale);
  return stale;
}

std::size_t sweep_staging(const std::filesystem::path& store_folder) {
  std::size_t removed = 0;
  for (const std::filesystem::path& folder : stale_staging_folders(store_folder)) {
    const Descriptor lock =
        locked(folder);  // held while removing, so that nobody else does the same
    std::error_code problem;
    if (lock.is_open() && std::filesystem::remove_all(folder, problem) > 0 && !problem) ++removed;
  }
  return removed;
}

}  // namespace slackwater::store

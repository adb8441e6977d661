#include "data/store/durable.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "fields/base/error.h"

namespace slackwater::store {
namespace {

Error trouble(const std::string& doing, const std::filesystem::path& path, int number) {
  std::string advice = "check the disk and its permissions";
  if (number == ENOSPC || number == EDQUOT) advice = "no space left; free some and run it again";
  if (number == EROFS || number == EACCES || number == EPERM) {
    advice = "it is not writable; choose another --store or give write permission";
  }
  return Error(ErrorKind::unavailable, "cannot " + doing + " " + path.string() + ": " +
                                           std::strerror(number) + "; " + advice);
}

void sync_path(const std::filesystem::path& path, int flags, const char* doing) {
  const Descriptor descriptor(::open(path.c_str(), flags | O_CLOEXEC));
  if (!descriptor.is_open() || ::fsync(descriptor.value()) != 0) throw trouble(doing, path, errno);
}

}  // namespace

void sync_file(const std::filesystem::path& file) { sync_path(file, O_RDONLY, "bring to disk"); }

void sync_folder(const std::filesystem::path& folder) {
  sync_path(folder, O_RDONLY | O_DIRECTORY, "bring to disk the names in");
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code ignored;
  if (std::filesystem::is_directory(folder, ignored)) return;
  const std::filesystem::path parent =
      folder.has_parent_path() ? folder.parent_path() : std::filesystem::path(".");
  if (parent != folder && !parent.empty()) make_folder(parent);
  if (::mkdir(folder.c_str(), 0777) != 0 && errno != EEXIST) {
    throw trouble("make the folder", folder, errno);
  }
  // Another process may have made it this instant; its name must be durable for us too.
  sync_folder(parent);
  if (!std::filesystem::is_directory(folder, ignored))
    throw trouble("use as a folder", folder, ENOTDIR);
}

void rename_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (std::rename(from.c_str(), to.c_str()) != 0) {
    throw trouble("move " + from.string() + " to", to, errno);
  }
}

}  // namespace slackwater::store

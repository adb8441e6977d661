#include "fields/base/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "fields/base/error.h"

namespace slackwater {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_.is_open() && ::flock(folder_.value(), LOCK_EX | LOCK_NB) == 0) return;
  const int why = errno;
  if (why == EWOULDBLOCK)
    throw Error(ErrorKind::unavailable, folder.string() +
                                            ": found another process at work in it; wait until "
                                            "that is over, or choose another folder");
  throw Error(ErrorKind::unavailable, "cannot lock " + folder.string() + ": " + std::strerror(why));
}

}  // namespace slackwater

#include "data/bag/append_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

int created(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0 && errno == EEXIST) refuse_existing(path);
  if (file < 0) {
    throw Error(ErrorKind::unavailable, "the recording " + path.string() +
                                            " cannot be made: " + std::strerror(errno) +
                                            "; check that its folder is there and may be written");
  }
  return file;
}

}  // namespace

void refuse_existing(const std::filesystem::path& path) {
  throw Error(ErrorKind::invalid_input,
              "found something at " + path.string() +
                  " already, and a recording never writes over another; choose another name, or "
                  "move it away");
}

AppendFile::AppendFile(const std::filesystem::path& path) : path_(path), file_(created(path)) {}

void AppendFile::append(std::span<const std::uint8_t> piece) {
  std::size_t done = 0;
  while (done < piece.size()) {
    const ssize_t written = ::pwrite(file_.value(), piece.data() + done, piece.size() - done,
                                     static_cast<off_t>(size_ + done));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int reason = written < 0 ? errno : EIO;
      // Where even this fails readers find a last record that is cut short, and do without it.
      if (::ftruncate(file_.value(), static_cast<off_t>(size_)) != 0) errno = 0;
      fail(reason);
    }
    done += static_cast<std::size_t>(written);
  }
  size_ += piece.size();
}

void AppendFile::sync() {
  if (::fsync(file_.value()) != 0) fail(errno);
}

void AppendFile::fail(int system_errno) const {
  throw Error(ErrorKind::unavailable,
              "the recording " + path_.string() +
                  " cannot be written: " + std::strerror(system_errno) +
                  "; what was recorded before stays readable; free some space or mend the disk, "
                  "and begin a new recording");
}

}  // namespace slackwater::bag

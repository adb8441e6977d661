#include "data/bag/input_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"

namespace slackwater::bag {
namespace {

constexpr std::uint64_t small_window = 512;
constexpr std::uint64_t large_window = std::uint64_t{64} << 10U;

[[noreturn]] void fail(const std::filesystem::path& path, int system_errno) {
  throw Error(system_errno == ENOENT ? ErrorKind::not_found : ErrorKind::unavailable,
              path.string() + " cannot be read: " + std::strerror(system_errno));
}

int opened(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) fail(path, errno);
  return file;
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) : path_(path), file_(opened(path)) {
  struct stat found {};
  if (::fstat(file_.value(), &found) != 0) fail(path_, errno);
  refuse_device(path_);
  size_ = static_cast<std::uint64_t>(found.st_size);
}

void InputFile::read(std::uint64_t offset, std::uint64_t length, Bytes& out) const {
  expects(has(offset, length), "read beyond the end of a file");
  out.resize(static_cast<std::size_t>(length));
  std::size_t done = 0;
  while (done < out.size()) {
    const ssize_t got = ::pread(file_.value(), out.data() + done, out.size() - done,
                                static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, errno);
    if (got == 0)
      throw Error(ErrorKind::unavailable, path_.string() + " became shorter while it was read");
    done += static_cast<std::size_t>(got);
  }
}

ByteView InputWindow::at(std::uint64_t offset, std::uint64_t length) {
  const bool is_inside = offset >= start_ && offset - start_ <= bytes_.size() &&
                         length <= bytes_.size() - (offset - start_);
  if (!is_inside) {
    // Who goes on from where the window ends reads on; who leaps may leap again.
    const bool goes_on = offset >= start_ && offset - start_ <= bytes_.size();
    const std::uint64_t wanted = std::max(length, goes_on ? large_window : small_window);
    file_->read(offset, std::min(wanted, file_->size() - offset), bytes_);
    start_ = offset;
  }
  return ByteView(bytes_).subspan(static_cast<std::size_t>(offset - start_));
}

}  // namespace slackwater::bag

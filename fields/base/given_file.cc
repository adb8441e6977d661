#include "fields/base/given_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "fields/base/descriptor.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater {
namespace {

[[noreturn]] void cannot_read(const std::filesystem::path& file, int problem) {
  const bool is_absent = problem == ENOENT || problem == ENOTDIR || problem == ENAMETOOLONG;
  throw Error(is_absent ? ErrorKind::not_found : ErrorKind::unavailable,
              "cannot read " + file.string() + ": " + std::strerror(problem) +
                  (is_absent ? "; check the path" : "; check its permissions"));
}

void expect_kind(const std::filesystem::path& file, mode_t mode, std::string_view what) {
  if (S_ISDIR(mode))
    refuse(formatted("found the folder {} where {} was expected; name a file in it", file.string(),
                     what));
  if (!S_ISREG(mode))
    refuse(
        formatted("found a pipe or a device, {}, where {} was expected; save what it gives to a "
                  "file, and name that",
                  file.string(), what));
}

/// Waits for nobody who writes to a pipe.
Descriptor opened(const std::filesystem::path& file, std::string_view what) {
  Descriptor given(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
  const int problem = errno;
  struct stat about {};
  if (!given.is_open()) {
    if (::stat(file.c_str(), &about) == 0) expect_kind(file, about.st_mode, what);
    cannot_read(file, problem);
  }
  if (::fstat(given.value(), &about) != 0) cannot_read(file, errno);
  expect_kind(file, about.st_mode, what);
  return given;
}

}  // namespace

void refuse_device(const std::filesystem::path& file) {
  struct stat about {};
  if (::stat(file.c_str(), &about) == 0 && !S_ISDIR(about.st_mode))
    expect_kind(file, about.st_mode, "a file");
}

void expect_given_file(const std::filesystem::path& file, std::string_view what) {
  static_cast<void>(opened(file, what));
}

std::string text_of_given_file(const std::filesystem::path& file, std::string_view what,
                               std::size_t most_bytes) {
  const Descriptor given = opened(file, what);
  constexpr std::size_t at_once = std::size_t{64} << 10U;
  std::string text;
  while (true) {
    const std::size_t had = text.size();
    text.resize(had + at_once);
    const ssize_t got = ::read(given.value(), text.data() + had, at_once);
    if (got < 0 && errno != EINTR) cannot_read(file, errno);
    text.resize(had + static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    if (got == 0) return text;
    if (text.size() > most_bytes)
      refuse(formatted("{}: longer than {} MiB where {} was expected", file.string(),
                       most_bytes >> 20U, what));
  }
}

}  // namespace slackwater

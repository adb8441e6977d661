#include "api/door/cli/plain_output.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <new>

#include "api/door/cli/plain_text.h"

namespace slackwater::api {
namespace {

/// Where the text goes, and what of a character has come so far. There for as long as the process.
struct Door {
  int descriptor;
  PlainText text;
};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// For fopencookie: all was taken, or nothing (0), which is an error.
ssize_t write_plain(void* door, const char* data, std::size_t size) noexcept {
  Door& to = *static_cast<Door*>(door);
  try {
    return write_all(to.descriptor, to.text.next({data, size})) ? static_cast<ssize_t>(size) : 0;
  } catch (const std::bad_alloc&) {
    errno = ENOMEM;
    return 0;
  }
}

/// Null where there is no memory: the stream then stays as it is.
std::FILE* plain_stream(Door& door, int buffering) {
  cookie_io_functions_t functions{};
  functions.write = write_plain;
  std::FILE* stream = ::fopencookie(&door, "w", functions);
  if (stream != nullptr) std::setvbuf(stream, nullptr, buffering, BUFSIZ);
  return stream;
}

}  // namespace

std::FILE* bare_stderr() {
  static std::FILE* const bare = stderr;
  return bare;
}

void print_plain_text() {
  static_cast<void>(bare_stderr());  // known before it is another one
  // Never destroyed: what waits in the buffers is written as the process ends.
  static Door& out = *new Door{STDOUT_FILENO, {}};
  static Door& problems = *new Door{STDERR_FILENO, {}};
  const int buffering = ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF;
  // In the GNU C library both are variables that may be set ("Standard Streams" of its manual).
  if (std::FILE* stream = plain_stream(out, buffering)) stdout = stream;
  if (std::FILE* stream = plain_stream(problems, _IONBF)) stderr = stream;
}

}  // namespace slackwater::api

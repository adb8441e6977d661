// A libc that records, and fails on request, the calls by which a program changes a folder. Loaded
// with LD_PRELOAD.
//
//   SLACKWATER_FAULT_ROOT    the folder watched; calls elsewhere pass unseen
//   SLACKWATER_FAULT_LOG     file that receives one record per call (format: call_log.h)
//   SLACKWATER_FAULT_AT      fail the Nth call (counted from 1, from the first line "begin" on
//                            standard output)
//   SLACKWATER_FAULT_ERRNO   with this errno; a failing write stores half of its bytes first, as a
//                            full disk may
//   SLACKWATER_FAULT_STICKY  "1": every later call fails as well
//   SLACKWATER_FAULT_ACTION  "kill": instead of failing, the process dies at once
//
// What the program writes to standard output is recorded too, as marks between the calls.
#include <dlfcn.h>
#include <fcntl.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "tests/data/store/call_log.h"

namespace {

constexpr int most_descriptors = 4096;

template <typename Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

struct Faults {
  std::string root;
  int log = -1;
  long at = 0;
  int error = EIO;
  bool sticky = false;
  bool kill = false;
  bool armed = false;
  long calls = 0;
  bool watched[most_descriptors] = {};

  Faults() {
    const auto text = [](const char* name) { return getenv(name) == nullptr ? "" : getenv(name); };
    root = text("SLACKWATER_FAULT_ROOT");
    at = atol(text("SLACKWATER_FAULT_AT"));
    if (*text("SLACKWATER_FAULT_ERRNO") != 0) error = atoi(text("SLACKWATER_FAULT_ERRNO"));
    sticky = strcmp(text("SLACKWATER_FAULT_STICKY"), "1") == 0;
    kill = strcmp(text("SLACKWATER_FAULT_ACTION"), "kill") == 0;
    if (const char* file = text("SLACKWATER_FAULT_LOG"); *file != 0) {
      log = static_cast<int>(
          syscall(SYS_openat, AT_FDCWD, file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
    }
  }
};

Faults& faults() {
  static Faults* const instance = new Faults;  // never destroyed: calls come until the very end
  return *instance;
}

std::string absolute(const char* path) {
  if (path[0] == '/') return path;
  char here[4096];
  return getcwd(here, sizeof here) == nullptr ? path : std::string(here) + "/" + path;
}

bool inside(const std::string& path) {
  const std::string& root = faults().root;
  return !root.empty() && path.compare(0, root.size(), root) == 0 &&
         (path.size() == root.size() || path[root.size()] == '/');
}

bool watched(int descriptor) {
  return descriptor >= 0 && descriptor < most_descriptors && faults().watched[descriptor];
}

void record(call_log::Call call, int descriptor, long long offset, const std::string& path,
            const std::string& other, const void* data, std::size_t bytes) {
  Faults& f = faults();
  if (f.log < 0) return;
  const call_log::Header header{call, descriptor, offset, path.size(), other.size(), bytes};
  std::string text(reinterpret_cast<const char*>(&header), sizeof header);
  text += path;
  text += other;
  text.append(static_cast<const char*>(data), bytes);
  syscall(SYS_write, f.log, text.data(), text.size());
}

/// Whether the call about to be made shall fail; errno is set.
bool fails() {
  Faults& f = faults();
  if (!f.armed) return false;
  ++f.calls;
  if (f.at == 0 || f.calls < f.at || (f.calls > f.at && !f.sticky)) return false;
  if (f.kill) syscall(SYS_exit_group, 137);
  errno = f.error;
  return true;
}

int open_watched(const char* name, const char* path, int flags, mode_t mode) {
  const std::string full = absolute(path);
  if (!inside(full)) return real<int(const char*, int, ...)>(name)(path, flags, mode);
  struct stat found;
  const bool existed = stat(path, &found) == 0;
  const bool changes = (flags & O_CREAT) != 0 && !existed;
  if (changes && fails()) return -1;
  const int descriptor = real<int(const char*, int, ...)>(name)(path, flags, mode);
  if (descriptor >= 0 && descriptor < most_descriptors) {
    faults().watched[descriptor] = true;
    record(call_log::Call::open, descriptor, 0, full, "", nullptr, 0);
    if ((flags & O_TRUNC) != 0 && existed) {
      record(call_log::Call::truncate, descriptor, 0, "", "", nullptr, 0);
    }
  }
  return descriptor;
}

mode_t mode_of(int flags, va_list arguments) {
  return (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(arguments, mode_t) : 0;
}

ssize_t write_at(int descriptor, const void* data, std::size_t bytes, off_t offset) {
  using Pwrite = ssize_t(int, const void*, std::size_t, off_t);
  if (!watched(descriptor)) return real<Pwrite>("pwrite64")(descriptor, data, bytes, offset);
  const bool fail = fails();
  const int error = errno;
  const std::size_t stored = fail ? bytes / 2 : bytes;
  const ssize_t written = real<Pwrite>("pwrite64")(descriptor, data, stored, offset);
  if (written > 0) {
    record(call_log::Call::write, descriptor, offset, "", "", data,
           static_cast<std::size_t>(written));
  }
  if (!fail) return written;
  errno = error;
  return -1;
}

int sync_with(const char* name, int descriptor) {
  if (watched(descriptor)) {
    if (fails()) return -1;
    record(call_log::Call::sync, descriptor, 0, "", "", nullptr, 0);
  }
  return real<int(int)>(name)(descriptor);
}

int truncate_to(int descriptor, off_t length) {
  if (watched(descriptor)) {
    if (fails()) return -1;
    record(call_log::Call::truncate, descriptor, length, "", "", nullptr, 0);
  }
  return real<int(int, off_t)>("ftruncate64")(descriptor, length);
}

int change_name(call_log::Call call, const char* name, const char* path) {
  const std::string full = absolute(path);
  if (inside(full) && fails()) return -1;
  const int result = real<int(const char*)>(name)(path);
  if (result == 0 && inside(full)) record(call, -1, 0, full, "", nullptr, 0);
  return result;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_watched("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = mode_of(flags, arguments);
  va_end(arguments);
  return open_watched("open64", path, flags, mode);
}

int close(int descriptor) {
  if (watched(descriptor)) {
    faults().watched[descriptor] = false;
    record(call_log::Call::close, descriptor, 0, "", "", nullptr, 0);
  }
  return real<int(int)>("close")(descriptor);
}

ssize_t write(int descriptor, const void* data, size_t bytes) {
  if (descriptor == STDOUT_FILENO && !faults().root.empty()) {
    record(call_log::Call::mark, descriptor, 0, "", "", data, bytes);
    if (bytes >= 5 && memcmp(data, "begin", 5) == 0) faults().armed = true;
  }
  if (watched(descriptor)) {
    const off_t offset = lseek(descriptor, 0, SEEK_CUR);
    const ssize_t written = write_at(descriptor, data, bytes, offset);
    if (written > 0) lseek(descriptor, offset + written, SEEK_SET);
    return written;
  }
  return real<ssize_t(int, const void*, size_t)>("write")(descriptor, data, bytes);
}

ssize_t pwrite(int descriptor, const void* data, size_t bytes, off_t offset) {
  return write_at(descriptor, data, bytes, offset);
}
ssize_t pwrite64(int descriptor, const void* data, size_t bytes, off_t offset) {
  return write_at(descriptor, data, bytes, offset);
}

int fsync(int descriptor) { return sync_with("fsync", descriptor); }
int fdatasync(int descriptor) { return sync_with("fdatasync", descriptor); }
int ftruncate(int descriptor, off_t length) noexcept { return truncate_to(descriptor, length); }
int ftruncate64(int descriptor, off_t length) noexcept { return truncate_to(descriptor, length); }

int rename(const char* from, const char* to) noexcept {
  const std::string full_from = absolute(from);
  const std::string full_to = absolute(to);
  if (inside(full_to) && fails()) return -1;
  const int result = real<int(const char*, const char*)>("rename")(from, to);
  if (result == 0 && inside(full_to)) {
    record(call_log::Call::rename, -1, 0, full_from, full_to, nullptr, 0);
  }
  return result;
}

int unlink(const char* path) noexcept {
  return change_name(call_log::Call::unlink, "unlink", path);
}
int rmdir(const char* path) noexcept { return change_name(call_log::Call::unlink, "rmdir", path); }
int remove(const char* path) noexcept {
  return change_name(call_log::Call::unlink, "remove", path);
}

int mkdir(const char* path, mode_t mode) noexcept {
  const std::string full = absolute(path);
  if (inside(full) && fails()) return -1;
  const int result = real<int(const char*, mode_t)>("mkdir")(path, mode);
  if (result == 0 && inside(full)) {
    record(call_log::Call::make_folder, -1, 0, full, "", nullptr, 0);
  }
  return result;
}

char* mkdtemp(char* form) noexcept {
  if (inside(absolute(form)) && fails()) return nullptr;
  char* const made = real<char*(char*)>("mkdtemp")(form);
  if (made != nullptr && inside(absolute(made))) {
    record(call_log::Call::make_folder, -1, 0, absolute(made), "", nullptr, 0);
  }
  return made;
}

}  // extern "C"

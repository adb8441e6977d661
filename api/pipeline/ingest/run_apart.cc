#include "api/pipeline/ingest/run_apart.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "api/program/pipe.h"
#include "fields/base/error.h"

// The pipe carries frames: a letter, the length in eight bytes, the bytes. 's' is a share, 'a' the
// answer, which comes last.

namespace slackwater::api {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;  // its shadow takes terabytes of address space
#else
constexpr bool is_sanitized = false;
#endif

constexpr std::size_t head_bytes = 1 + sizeof(std::uint64_t);

bool write_all(int descriptor, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t count = ::write(descriptor, data, size);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    data += count;
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

bool send(int descriptor, char kind, std::string_view bytes) {
  const std::uint64_t size = bytes.size();
  std::string frame(1, kind);
  frame.append(reinterpret_cast<const char*>(&size), sizeof size);
  frame += bytes;
  return write_all(descriptor, frame.data(), frame.size());
}

void limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard) {
  struct rlimit now {};
  if (::getrlimit(what, &now) != 0) return;
  now.rlim_cur = std::min(soft, now.rlim_cur);
  now.rlim_max = std::min(hard, now.rlim_max);
  ::setrlimit(what, &now);
}

/// In the child, before the work.
void bind_child(pid_t parent, const Allowance& allowance) {
  // Ends with its parent, also where only that one is killed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const auto seconds = static_cast<rlim_t>(allowance.processor.count());
  limit(RLIMIT_CPU, seconds, seconds + 5);
  limit(RLIMIT_CORE, 0, 0);
  if (!is_sanitized) limit(RLIMIT_AS, allowance.memory_bytes, allowance.memory_bytes);
}

[[noreturn]] void run_child(int descriptor,
                            const std::function<std::string(const TellShare&)>& work) {
  bool is_told = false;
  try {
    int last_permille = -1;
    const std::string answer = work([&](double share) {
      const int permille = static_cast<int>(1000 * share);
      if (permille == last_permille) return;
      last_permille = permille;
      send(descriptor, 's', std::to_string(permille));
    });
    is_told = send(descriptor, 'a', answer);
  } catch (...) {  // nothing may run on into what the parent was about to do
    is_told = false;
  }
  std::fflush(stdout);
  std::fflush(stderr);
  ::_exit(is_told ? 0 : 1);
}

/// Reads frames to the end of the pipe. @return whether the answer came
bool receive(int descriptor, std::string& answer, const std::function<void(double)>& on_share) {
  bool is_answered = false;
  std::string bytes;
  std::array<char, 65536> buffer{};
  while (true) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return is_answered;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    std::size_t at = 0;
    while (bytes.size() - at >= head_bytes) {
      std::uint64_t size = 0;
      std::memcpy(&size, bytes.data() + at + 1, sizeof size);
      if (bytes.size() - at - head_bytes < size) break;
      std::string content = bytes.substr(at + head_bytes, size);
      if (bytes[at] == 'a') {
        answer = std::move(content);
        is_answered = true;
      } else if (on_share) {
        on_share(std::strtod(content.c_str(), nullptr) / 1000);
      }
      at += head_bytes + size;
    }
    bytes.erase(0, at);
  }
}

bool is_of_a_fault(int signal) {
  constexpr std::array faults{SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, SIGTRAP, SIGSYS};
  return std::find(faults.begin(), faults.end(), signal) != faults.end();
}

/// Of a child that answered nothing.
Apart::End end_of(int status) {
  if (!WIFSIGNALED(status)) return Apart::End::crashed;
  if (WTERMSIG(status) == SIGXCPU) return Apart::End::out_of_time;
  return is_of_a_fault(WTERMSIG(status)) ? Apart::End::crashed : Apart::End::killed;
}

}  // namespace

Apart run_apart(const Allowance& allowance,
                const std::function<std::string(const TellShare&)>& work,
                const std::function<void(double)>& on_share) {
  Pipe pipe;
  const pid_t parent = ::getpid();
  std::fflush(stdout);  // what waits in the buffers would be printed twice
  std::fflush(stderr);
  const pid_t child = ::fork();
  if (child < 0) {
    throw Error(ErrorKind::unavailable, std::string("cannot start another process: ") +
                                            std::strerror(errno) + "; try again");
  }
  if (child == 0) {
    pipe.close_reading();
    bind_child(parent, allowance);
    run_child(pipe.writing(), work);
  }
  pipe.close_writing();
  Apart apart;
  const bool is_answered = receive(pipe.reading(), apart.answer, on_share);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (WIFSIGNALED(status)) apart.signal = WTERMSIG(status);
  if (!is_answered) apart.end = end_of(status);
  return apart;
}

}  // namespace slackwater::api

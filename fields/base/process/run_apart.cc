#include "fields/base/process/run_apart.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iterator>

#include "fields/base/error.h"
#include "fields/base/process/child.h"
#include "fields/base/process/frames.h"
#include "fields/base/process/pipe.h"

namespace slackwater {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_sanitized = true;  // its shadow takes terabytes of address space
#else
constexpr bool is_sanitized = false;
#endif

constexpr int not_confined = 79;  ///< how a child ends that could not be bound

void limit(decltype(RLIMIT_CPU) what, rlim_t soft, rlim_t hard) {
  struct rlimit now {};
  if (::getrlimit(what, &now) != 0) return;
  now.rlim_cur = std::min(soft, now.rlim_cur);
  now.rlim_max = std::min(hard, now.rlim_max);
  ::setrlimit(what, &now);
}

/// No file, lock or connection of the parent can be reached: only the pipe is left.
void close_all_but(int descriptor) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing >= 0) {
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    if (!is_sanitized) ::dup2(nothing, STDERR_FILENO);  // whose words are for us
  }
  const auto kept = static_cast<unsigned>(descriptor);
  const bool is_done = (kept <= 3 || ::syscall(SYS_close_range, 3U, kept - 1, 0U) == 0) &&
                       ::syscall(SYS_close_range, kept + 1, ~0U, 0U) == 0;
  if (is_done) return;
  for (int each = 3; each < static_cast<int>(::sysconf(_SC_OPEN_MAX)); ++each)  // before Linux 5.9
    if (each != descriptor) ::close(each);
}

/// In the child, before the work.
void bind_child(pid_t parent, int descriptor, const Allowance& allowance) {
  // Ends with its parent, also where only that one is killed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  const auto seconds = static_cast<rlim_t>(allowance.processor.count());
  limit(RLIMIT_CPU, seconds, seconds + 5);
  limit(RLIMIT_CORE, 0, 0);
  limit(RLIMIT_FSIZE, allowance.file_bytes, allowance.file_bytes);
  if (!is_sanitized) limit(RLIMIT_AS, allowance.memory_bytes, allowance.memory_bytes);
  close_all_but(descriptor);
  const Confinement confinement(allowance.reach);
  if (!confinement.apply()) ::_exit(not_confined);
}

[[noreturn]] void run_child(pid_t parent, int descriptor, const Allowance& allowance,
                            const std::function<std::string(const TellShare&)>& work) {
  bool is_told = false, is_bound = false;
  try {
    bind_child(parent, descriptor, allowance);
    is_bound = true;
    int last_permille = -1;
    const std::string answer = work([&](double share) {
      const int permille = static_cast<int>(1000 * share);
      if (permille == last_permille) return;
      last_permille = permille;
      send_share(descriptor, permille);
    });
    is_told = send_answer(descriptor, answer);
  } catch (...) {  // nothing may run on into what the parent was about to do
    is_told = false;
  }
  std::fflush(stderr);
  if (!is_bound) ::_exit(not_confined);
  ::_exit(is_told ? 0 : 1);
}

/// Listens to the child until it has ended, or ends it. @return why it was ended, where it was
Apart::End listen(const Child& child, int descriptor, const Allowance& allowance, Told& told,
                  const std::function<void(double)>& on_share) {
  using Clock = std::chrono::steady_clock;
  const auto latest = Clock::now() + 10 * allowance.processor;
  constexpr int look_every_ms = 50;
  auto look_at = Clock::now();
  std::array<char, 65536> buffer{};
  while (true) {
    pollfd wanted{descriptor, POLLIN, 0};
    if (::poll(&wanted, 1, look_every_ms) > 0) {
      const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return Apart::End::answered;
      told.take({buffer.data(), static_cast<std::size_t>(count)}, on_share);
      if (Clock::now() < look_at) continue;
    }
    look_at = Clock::now() + std::chrono::milliseconds(look_every_ms);
    const bool is_too_large =
        child.bytes_in_use() > allowance.memory_bytes || told.bytes.size() > allowance.memory_bytes;
    if (!is_too_large && Clock::now() < latest) continue;
    child.end();
    return is_too_large ? Apart::End::out_of_memory : Apart::End::out_of_time;
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
  if (WTERMSIG(status) == SIGXFSZ) return Apart::End::wrote_too_much;
  return is_of_a_fault(WTERMSIG(status)) ? Apart::End::crashed : Apart::End::killed;
}

std::ptrdiff_t threads_now() {
  std::error_code problem;
  const std::filesystem::directory_iterator threads("/proc/self/task", problem);
  return problem ? 1 : std::distance(begin(threads), end(threads));
}

/// Libraries may begin threads as they are loaded (OpenBLAS: one for each further core), which wait
/// for work of ours and hold no lock until then. It ends them at a fork.
std::ptrdiff_t threads_of_libraries = threads_now();

}  // namespace

bool is_alone() { return threads_now() <= threads_of_libraries; }

Apart run_apart(const Allowance& allowance,
                const std::function<std::string(const TellShare&)>& work,
                const std::function<void(double)>& on_share,
                const std::function<void()>& meanwhile) {
  Pipe pipe;
  const pid_t parent = ::getpid();
  std::fflush(stdout);  // what waits in the buffers would be printed twice
  std::fflush(stderr);
  Child child(::fork());
  if (child.process() < 0) {
    throw Error(ErrorKind::unavailable, std::string("cannot start another process: ") +
                                            std::strerror(errno) + "; try again");
  }
  if (child.process() == 0) {
    pipe.close_reading();
    run_child(parent, pipe.writing(), allowance, work);
  }
  pipe.close_writing();
  if (meanwhile) meanwhile();
  Apart apart;
  Told told;
  apart.end = listen(child, pipe.reading(), allowance, told, on_share);
  const int status = child.wait_a_while();
  threads_of_libraries = std::min(threads_of_libraries, threads_now());
  if (WIFEXITED(status) && WEXITSTATUS(status) == not_confined && !told.is_answered)
    throw Error(ErrorKind::unavailable,
                "cannot confine a process that is to read a file; try again, or free some memory");
  if (WIFSIGNALED(status)) apart.signal = WTERMSIG(status);
  if (apart.end == Apart::End::answered && !told.is_answered) apart.end = end_of(status);
  if (apart.end == Apart::End::answered) apart.answer = std::move(told.answer);
  return apart;
}

}  // namespace slackwater

#include "fields/base/process/run_program.h"

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
#include <cstring>
#include <optional>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/process/pipe.h"

namespace slackwater {
namespace {

using Clock = std::chrono::steady_clock;

/// As execve takes them.
std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  pointers.reserve(texts.size() + 1);
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

bool is_program(const std::string& place) {
  std::error_code problem;
  return std::filesystem::is_regular_file(place, problem) && access(place.c_str(), X_OK) == 0;
}

/// Where it is; nothing: no folder of PATH has it. Never in the folder of work by its bare name.
std::optional<std::string> found_by_path(const ProgramAsked& asked) {
  const std::string& program = asked.arguments.front();
  if (program.find('/') != std::string::npos)
    return is_program(program) ? std::optional(program) : std::nullopt;
  constexpr std::string_view name = "PATH=";
  for (const std::string& variable : asked.environment) {
    if (!variable.starts_with(name)) continue;
    for (std::size_t from = name.size(); from <= variable.size();) {
      const std::size_t to = std::min(variable.find(':', from), variable.size());
      const std::string place = variable.substr(from, to - from) + "/" + program;
      if (to > from && is_program(place)) return place;
      from = to + 1;
    }
  }
  return std::nullopt;
}

/// What the child needs, made before it is: between fork and exec it may allocate nothing.
struct Prepared {
  std::string program;
  std::string folder;
  std::vector<char*> arguments;
  std::vector<char*> environment;
  rlimit memory{};
  int says = -1;    ///< to where it writes
  int failed = -1;  ///< to where errno goes that keeps it from being run
  pid_t parent = 0;
};

[[noreturn]] void become(const Prepared& p) {
  setsid();  // a group of its own, and no terminal that it could ask a person at
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != p.parent) _exit(127);  // it was gone before that was said
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGHUP}) std::signal(number, SIG_DFL);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  setrlimit(RLIMIT_AS, &p.memory);
  // Out of the way of the four that it will have.
  constexpr int beyond = 10;
  const int nothing = fcntl(open("/dev/null", O_RDONLY), F_DUPFD, beyond);
  const int says = fcntl(p.says, F_DUPFD, beyond);
  const int fails = fcntl(p.failed, F_DUPFD, beyond);
  dup2(nothing, 0);
  dup2(says, 1);
  dup2(says, 2);
  const int failed = dup2(fails, 3);
  fcntl(failed, F_SETFD, FD_CLOEXEC);
  syscall(SYS_close_range, 4U, ~0U, 0U);
  if (p.folder.empty() || chdir(p.folder.c_str()) == 0)
    execve(p.program.c_str(), p.arguments.data(), p.environment.data());
  const int why = errno;
  const ssize_t told = write(failed, &why, sizeof why);
  _exit(told == sizeof why ? 127 : 126);
}

/// The last bytes of what came.
void keep(std::string& output, const char* bytes, std::size_t count, std::size_t most) {
  output.append(bytes, count);
  if (output.size() > 2 * most) output.erase(0, output.size() - most);
}

/// What is there to be read now, a megabyte at most: who writes without end is no reason to look at
/// nothing else. @return false: nobody writes any more
bool read_on(int from, std::string& output, std::size_t most) {
  std::array<char, 16384> bytes{};
  constexpr int most_reads = 64;
  for (int i = 0; i < most_reads; ++i) {
    const ssize_t count = read(from, bytes.data(), bytes.size());
    if (count > 0) {
      keep(output, bytes.data(), static_cast<std::size_t>(count), most);
    } else if (count == 0) {
      return false;
    } else if (errno != EINTR) {
      return errno == EAGAIN;
    }
  }
  return true;
}

/// A process group that is ended and waited for in every case.
class Group {
 public:
  explicit Group(pid_t leader) : leader_(leader) {}
  ~Group() {
    end();
    int status = 0;
    while (waitpid(leader_, &status, 0) < 0 && errno == EINTR) {
    }
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  void ask_to_end() const { kill(-leader_, SIGTERM); }
  void end() const { kill(-leader_, SIGKILL); }
  /// Whether the first of them is over. It stays a zombie until all are ended, so that its number
  /// is nobody else's.
  bool is_over() {
    siginfo_t how{};
    if (waitid(P_PID, static_cast<id_t>(leader_), &how, WEXITED | WNOHANG | WNOWAIT) != 0 ||
        how.si_pid != leader_)
      return false;
    was_killed_ = how.si_code != CLD_EXITED;
    status_ = how.si_status;
    return true;
  }
  [[nodiscard]] bool was_killed() const { return was_killed_; }
  /// With which it exited, or the signal that killed it.
  [[nodiscard]] int status() const { return status_; }

 private:
  pid_t leader_;
  int status_ = 0;
  bool was_killed_ = false;
};

/// errno that kept it from being run; 0: it runs, or has.
int start_failure(int from) {
  int why = 0;
  ssize_t count = 0;
  do count = read(from, &why, sizeof why);
  while (count < 0 && errno == EINTR);
  return count == sizeof why ? why : 0;
}

}  // namespace

ProgramEnded run_program(const ProgramAsked& asked, const std::atomic<bool>* is_stop_asked) {
  expects(!asked.arguments.empty(), "a program has a name");
  const std::optional<std::string> program = found_by_path(asked);
  if (!program) return {ProgramEnded::End::not_found, 0, 0, ""};
  Pipe says, failed;
  Prepared prepared;
  prepared.program = *program;
  prepared.folder = asked.folder.string();
  prepared.arguments = pointers_to(asked.arguments);
  prepared.environment = pointers_to(asked.environment);
  prepared.memory = {asked.memory_bytes, asked.memory_bytes};
  prepared.says = says.writing();
  prepared.failed = failed.writing();
  prepared.parent = getpid();
  const pid_t process = fork();
  if (process < 0)
    throw Error(ErrorKind::unavailable,
                std::string("cannot start another process: ") + std::strerror(errno));
  if (process == 0) become(prepared);
  Group group(process);
  says.close_writing();
  failed.close_writing();
  ProgramEnded out;
  if (const int why = start_failure(failed.reading()); why != 0) {
    out.end = ProgramEnded::End::not_found;
    out.output = prepared.program + ": " + std::strerror(why);
    return out;
  }
  fcntl(says.reading(), F_SETFL, O_NONBLOCK);
  constexpr std::chrono::seconds grace{5};
  const auto began = Clock::now();
  std::optional<Clock::time_point> asked_to_end;
  for (bool is_open = true; !group.is_over();) {
    pollfd ready{says.reading(), POLLIN, 0};
    constexpr int tick_ms = 100;
    if (is_open) {
      (void)poll(&ready, 1, tick_ms);
      is_open = read_on(says.reading(), out.output, asked.most_output);
    } else {
      (void)poll(nullptr, 0, tick_ms / 5);
    }
    const auto now = Clock::now();
    const bool is_stopped = is_stop_asked != nullptr && *is_stop_asked;
    if (!asked_to_end && (is_stopped || now - began > asked.longest)) {
      out.end = is_stopped ? ProgramEnded::End::stopped : ProgramEnded::End::out_of_time;
      group.ask_to_end();
      asked_to_end = now;
    }
    if (asked_to_end && now - *asked_to_end > grace) group.end();
  }
  group.end();
  (void)read_on(says.reading(), out.output, asked.most_output);
  if (out.output.size() > asked.most_output)
    out.output.erase(0, out.output.size() - asked.most_output);
  if (out.end != ProgramEnded::End::exited) return out;
  if (group.was_killed()) {
    out.end = ProgramEnded::End::killed;
    out.signal = group.status();
  } else {
    out.status = group.status();
  }
  return out;
}

}  // namespace slackwater

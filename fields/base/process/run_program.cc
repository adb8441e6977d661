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
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Where it is; as it is where no folder of PATH has it.
std::string found_by_path(const ProgramAsked& asked) {
  const std::string& program = asked.arguments.front();
  if (program.find('/') != std::string::npos) return program;
  constexpr std::string_view name = "PATH=";
  for (const std::string& variable : asked.environment) {
    if (!variable.starts_with(name)) continue;
    for (std::size_t from = name.size(); from <= variable.size();) {
      const std::size_t to = std::min(variable.find(':', from), variable.size());
      const std::string place = variable.substr(from, to - from) + "/" + program;
      if (to > from && access(place.c_str(), X_OK) == 0) return place;
      from = to + 1;
    }
  }
  return program;
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
  setpgid(0, 0);
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

/// What is there to be read now. @return false: nobody writes any more
bool read_on(int from, std::string& output, std::size_t most) {
  std::array<char, 16384> bytes{};
  for (;;) {
    const ssize_t count = read(from, bytes.data(), bytes.size());
    if (count > 0) {
      keep(output, bytes.data(), static_cast<std::size_t>(count), most);
    } else if (count == 0) {
      return false;
    } else if (errno != EINTR) {
      return errno == EAGAIN;
    }
  }
}

/// A process group that is ended and waited for in every case.
class Group {
 public:
  explicit Group(pid_t leader) : leader_(leader) {}
  ~Group() {
    kill(-leader_, SIGKILL);
    if (!is_over_) (void)waitpid(leader_, &status_, 0);
  }
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  void ask_to_end() const { kill(-leader_, SIGTERM); }
  void end() const { kill(-leader_, SIGKILL); }
  /// Whether the first of them is over.
  bool is_over() {
    if (!is_over_) is_over_ = waitpid(leader_, &status_, WNOHANG) == leader_;
    return is_over_;
  }
  [[nodiscard]] int status() const { return status_; }

 private:
  pid_t leader_;
  int status_ = 0;
  bool is_over_ = false;
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
  Pipe says, failed;
  Prepared prepared;
  prepared.program = found_by_path(asked);
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
  setpgid(process, process);  // whichever of the two is first
  Group group(process);
  says.close_writing();
  failed.close_writing();
  ProgramEnded out;
  if (start_failure(failed.reading()) != 0) {
    out.end = ProgramEnded::End::not_found;
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
  (void)read_on(says.reading(), out.output, asked.most_output);
  if (out.output.size() > asked.most_output)
    out.output.erase(0, out.output.size() - asked.most_output);
  if (out.end != ProgramEnded::End::exited) return out;
  if (WIFSIGNALED(group.status())) {
    out.end = ProgramEnded::End::killed;
    out.signal = WTERMSIG(group.status());
  } else {
    out.status = WEXITSTATUS(group.status());
  }
  return out;
}

}  // namespace slackwater

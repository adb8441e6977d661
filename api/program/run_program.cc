#include "api/program/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/process/pipe.h"

namespace slackwater::api {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t most_said = 4096;

pid_t start(const std::vector<std::string>& command, const Pipe& in, const Pipe& err) {
  std::vector<char*> arguments;
  arguments.reserve(command.size() + 1);
  for (const std::string& argument : command)
    arguments.push_back(const_cast<char*>(argument.c_str()));  // execvp's signature
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_adddup2(&actions, in.reading(), STDIN_FILENO);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, err.writing(), STDERR_FILENO);
  // A group of its own, so that all of it can be ended; and no signal blocked or ignored.
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(
      &attributes,
      static_cast<short>(POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
  pid_t child = -1;
  const int failure =
      ::posix_spawnp(&child, arguments[0], &actions, &attributes, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (failure != 0)
    throw Error(ErrorKind::unavailable, "found no program to start as " + command.front() + " (" +
                                            std::strerror(failure) +
                                            "); install it, or name one that is there");
  return child;
}

/// A signal handled otherwise for a while.
class SignalAs {
 public:
  SignalAs(int signal, void (*as)(int)) : signal_(signal), before_(std::signal(signal, as)) {}
  ~SignalAs() { std::signal(signal_, before_); }
  SignalAs(const SignalAs&) = delete;
  SignalAs& operator=(const SignalAs&) = delete;

 private:
  int signal_;
  void (*before_)(int);
};

/// What another program is told and what it says, a little at a time.
class Talk {
 public:
  Talk(Pipe& in, Pipe& err, const std::string& input) : in_(in), err_(err), input_(input) {
    ::fcntl(in_.writing(), F_SETFL, O_NONBLOCK);
    ::fcntl(err_.reading(), F_SETFL, O_NONBLOCK);
  }
  /// Waits a little for one of the two.
  void go_on(milliseconds wait) {
    if (written_ == input_.size()) in_.close_writing();
    std::array<pollfd, 2> ends{pollfd{err_.reading(), POLLIN, 0},
                               pollfd{in_.writing(), POLLOUT, 0}};
    if (::poll(ends.data(), ends.size(), static_cast<int>(wait.count())) <= 0) return;
    if ((ends[1].revents & POLLERR) != 0) {
      written_ = input_.size();  // it does not care to read
    } else if ((ends[1].revents & POLLOUT) != 0) {
      const auto n = ::write(in_.writing(), input_.data() + written_, input_.size() - written_);
      if (n > 0) written_ += static_cast<std::size_t>(n);
    }
    if ((ends[0].revents & (POLLIN | POLLHUP)) != 0) hear();
  }
  /// Hears what there is.
  void hear() {
    std::array<char, 1024> buffer{};
    ssize_t n = 0;
    while (err_.reading() >= 0 && (n = ::read(err_.reading(), buffer.data(), buffer.size())) > 0)
      said_.append(buffer.data(), std::min(static_cast<std::size_t>(n), most_said - said_.size()));
    if (n == 0) err_.close_reading();
  }
  [[nodiscard]] std::string said() && { return std::move(said_); }

 private:
  Pipe& in_;
  Pipe& err_;
  const std::string& input_;
  std::size_t written_ = 0;
  std::string said_;
};

/// Whether it has ended; it is not laid to rest yet, and its group keeps its number.
bool has_ended(pid_t child) {
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         info.si_pid == child;
}

}  // namespace

ProgramEnd run_program(const std::vector<std::string>& command, const std::string& input,
                       milliseconds limit) {
  expects(!command.empty(), "a program has a name");
  const Clock::time_point end = Clock::now() + limit;
  Pipe in, err;
  // One who does not read what is written is no reason to die; and how it ended is to be had,
  // whatever the one who started us does with the ends of children.
  const SignalAs heedless(SIGPIPE, SIG_IGN), heard(SIGCHLD, SIG_DFL);
  const pid_t child = start(command, in, err);
  in.close_reading();
  err.close_writing();
  Talk talk(in, err, input);
  bool is_over = false;
  while (!(is_over = has_ended(child)) && Clock::now() < end) talk.go_on(milliseconds(20));
  talk.hear();
  ::kill(-child, SIGKILL);  // with whatever it left running
  int status = 0;
  ::waitpid(child, &status, 0);
  return {!is_over, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status),
          std::move(talk).said()};
}

}  // namespace slackwater::api

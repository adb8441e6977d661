#include "ingest/ais/filter_program.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <thread>
#include <utility>

#include "fields/base/descriptor.h"
#include "fields/base/error.h"
#include "fields/base/process/confinement.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t most_line_bytes = 65536;

[[noreturn]] void unavailable(const FilterProgram& program, const std::string& what) {
  throw Error(ErrorKind::unavailable,
              program.command.front() + " " + what + "; try `" + program.command.front() +
                  "` by hand, or install it anew: " + program.install_advice);
}

/// A connected pair of sockets: unlike a pipe it can be written to without a SIGPIPE when the
/// reader is gone.
std::pair<Descriptor, Descriptor> make_pair_of_sockets(const FilterProgram& program) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    unavailable(program, std::string("cannot be connected to: ") + std::strerror(errno));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
}

/// Where a command is, as a shell finds it; empty: nowhere.
std::filesystem::path found_on_path(const std::string& command) {
  const char* const path = std::getenv("PATH");
  std::stringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    auto file = std::filesystem::path(folder) / command;
    std::error_code problem;
    if (std::filesystem::is_regular_file(file, problem) && ::access(file.c_str(), X_OK) == 0)
      return file;
  }
  return {};
}

/// A copy of this process that becomes the program. Between the two nothing is allocated, as other
/// threads of ours may hold the lock of that. @return the process; -1: none, as errno says
pid_t start_confined(const std::filesystem::path& file, char* const* arguments,
                     char* const* environment, const Descriptor& input, const Descriptor& output) {
  Reach reach;
  reach.programs = {file, "/lib64/ld-linux-x86-64.so.2", "/lib/ld-linux-aarch64.so.1"};
  reach.readable = {"/lib", "/lib64", "/usr/lib", "/usr/local/lib", "/etc/ld.so.cache"};
  const Confinement confinement(reach);
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  const bool is_ready = ::dup2(input.value(), STDIN_FILENO) >= 0 &&
                        ::dup2(output.value(), STDOUT_FILENO) >= 0 &&
                        ::dup2(nothing, STDERR_FILENO) >= 0 && confinement.apply();
  if (is_ready) ::execve(file.c_str(), arguments, environment);
  ::_exit(127);
}

/// A started program; killed and waited for unless it was seen to end.
class Child {
 public:
  Child(const FilterProgram& program, const Descriptor& input, const Descriptor& output) {
    std::vector<std::string> words = program.command;
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::string locale = "LC_ALL=C";  // decimal points
    std::vector<char*> environment;
    for (char** entry = environ; *entry != nullptr; ++entry) {
      if (!std::string_view(*entry).starts_with("LC_ALL=")) environment.push_back(*entry);
    }
    environment.push_back(locale.data());
    environment.push_back(nullptr);

    const int problem = program.is_confined ? confined(arguments, environment, input, output)
                                            : spawned(arguments, environment, input, output);
    if (problem == 0) return;
    process_ = -1;
    if (problem != ENOENT)
      unavailable(program, std::string("does not start: ") + std::strerror(problem));
    throw Error(ErrorKind::unavailable,
                "found no program " + words.front() +
                    " on the PATH, which is needed here; install it: " + program.install_advice);
  }
  ~Child() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// @return what kept it from starting; 0: nothing
  int spawned(std::vector<char*>& arguments, std::vector<char*>& environment,
              const Descriptor& input, const Descriptor& output) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input.value(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output.value(), STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int problem = ::posix_spawnp(&process_, arguments.front(), &actions, nullptr,
                                       arguments.data(), environment.data());
    ::posix_spawn_file_actions_destroy(&actions);
    return problem;
  }
  int confined(std::vector<char*>& arguments, std::vector<char*>& environment,
               const Descriptor& input, const Descriptor& output) {
    const std::filesystem::path file = found_on_path(arguments.front());
    if (file.empty()) return ENOENT;
    process_ = start_confined(file, arguments.data(), environment.data(), input, output);
    return process_ < 0 ? errno : 0;
  }

  /// Waits for its end, which must be a good one.
  void finish(const FilterProgram& program) {
    constexpr Duration step = std::chrono::milliseconds(5);
    int status = 0;
    for (Duration waited{}; waited <= program.patience; waited += step) {
      const pid_t ended = ::waitpid(process_, &status, WNOHANG);
      if (ended == 0 || (ended < 0 && errno == EINTR)) {
        std::this_thread::sleep_for(step);
        continue;
      }
      process_ = -1;
      if (ended < 0) return;  // ours ignores SIGCHLD: nobody can say how it ended
      if (WIFSIGNALED(status)) {
        unavailable(program, "was ended by signal " + std::to_string(WTERMSIG(status)));
      }
      if (WEXITSTATUS(status) != 0) {
        unavailable(program, "failed with exit code " + std::to_string(WEXITSTATUS(status)));
      }
      return;
    }
    unavailable(program, "closed its output but does not end");
  }

 private:
  pid_t process_ = -1;
};

/// Cuts what is read into lines.
class LineCutter {
 public:
  LineCutter(const FilterProgram& program, const Consume& consume)
      : program_(program), consume_(consume) {}
  void take(std::string_view bytes) {
    while (!bytes.empty()) {
      const std::size_t end = bytes.find('\n');
      pending_.append(bytes.substr(0, end));
      if (pending_.size() > most_line_bytes)
        unavailable(program_, "answers with a line without end");
      if (end == std::string_view::npos) return;
      if (!pending_.empty() && pending_.back() == '\r') pending_.pop_back();
      consume_(pending_);
      pending_.clear();
      bytes.remove_prefix(end + 1);
    }
  }

 private:
  const FilterProgram& program_;
  const Consume& consume_;
  std::string pending_;
};

bool would_block() noexcept { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

void run_filter(const FilterProgram& program, const Produce& produce, const Consume& consume) {
  auto [ours_in, theirs_in] = make_pair_of_sockets(program);
  auto [ours_out, theirs_out] = make_pair_of_sockets(program);
  Child child(program, theirs_in, theirs_out);
  theirs_in.close();
  theirs_out.close();

  LineCutter lines(program, consume);
  std::string input;
  std::size_t sent = 0;
  std::array<char, 65536> bytes{};
  while (ours_out.is_open()) {
    if (ours_in.is_open() && sent == input.size()) {
      input.clear();
      sent = 0;
      if (!produce(input) && input.empty())
        ours_in.close();
      else if (input.empty())
        continue;
    }
    std::array<pollfd, 2> wanted{pollfd{ours_out.value(), POLLIN, 0},
                                 pollfd{ours_in.value(), POLLOUT, 0}};
    const int ready =
        ::poll(wanted.data(), wanted.size(), static_cast<int>(program.patience.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) unavailable(program, "does not answer");
    if (wanted[1].revents != 0) {
      const ssize_t count = ::send(ours_in.value(), input.data() + sent, input.size() - sent,
                                   MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count >= 0) {
        sent += static_cast<std::size_t>(count);
      } else if (!would_block()) {
        ours_in.close();  // it reads no more; how it ends tells why
      }
    }
    if (wanted[0].revents != 0) {
      const ssize_t count = ::recv(ours_out.value(), bytes.data(), bytes.size(), MSG_DONTWAIT);
      if (count > 0) {
        lines.take({bytes.data(), static_cast<std::size_t>(count)});
      } else if (count == 0 || !would_block()) {
        ours_out.close();
      }
    }
  }
  const bool was_fed = !ours_in.is_open() && sent == input.size();
  ours_in.close();
  child.finish(program);
  if (!was_fed) unavailable(program, "ended before it had read everything");
}

}  // namespace slackwater::ingest

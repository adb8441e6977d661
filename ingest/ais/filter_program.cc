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
#include <cstring>
#include <thread>
#include <utility>

#include "fields/base/error.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t most_line_bytes = 65536;

[[noreturn]] void unavailable(const FilterProgram& program, const std::string& what) {
  throw Error(ErrorKind::unavailable,
              program.command.front() + " " + what + "; try `" + program.command.front() +
                  "` by hand, or install it anew: " + program.install_advice);
}

/// A file descriptor that is closed.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) noexcept : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  [[nodiscard]] int number() const noexcept { return number_; }
  [[nodiscard]] bool is_open() const noexcept { return number_ >= 0; }
  void close() noexcept {
    if (is_open()) ::close(std::exchange(number_, -1));
  }

 private:
  int number_;
};

/// A connected pair of sockets: unlike a pipe it can be written to without a SIGPIPE when the
/// reader is gone.
std::pair<Descriptor, Descriptor> make_pair_of_sockets(const FilterProgram& program) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    unavailable(program, std::string("cannot be connected to: ") + std::strerror(errno));
  }
  return {Descriptor(ends[0]), Descriptor(ends[1])};
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

    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, input.number(), STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, output.number(), STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    const int problem = ::posix_spawnp(&process_, words.front().c_str(), &actions, nullptr,
                                       arguments.data(), environment.data());
    ::posix_spawn_file_actions_destroy(&actions);
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
    std::array<pollfd, 2> wanted{pollfd{ours_out.number(), POLLIN, 0},
                                 pollfd{ours_in.number(), POLLOUT, 0}};
    const int ready =
        ::poll(wanted.data(), wanted.size(), static_cast<int>(program.patience.count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) unavailable(program, "does not answer");
    if (wanted[1].revents != 0) {
      const ssize_t count = ::send(ours_in.number(), input.data() + sent, input.size() - sent,
                                   MSG_NOSIGNAL | MSG_DONTWAIT);
      if (count >= 0) {
        sent += static_cast<std::size_t>(count);
      } else if (!would_block()) {
        ours_in.close();  // it reads no more; how it ends tells why
      }
    }
    if (wanted[0].revents != 0) {
      const ssize_t count = ::recv(ours_out.number(), bytes.data(), bytes.size(), MSG_DONTWAIT);
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

#include "tests/data/store/worker_process.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <sstream>
#include <stdexcept>

extern char** environ;

namespace slackwater::store::tests {

WorkerProcess::WorkerProcess(const std::filesystem::path& store,
                             const std::vector<std::string>& steps,
                             const std::map<std::string, std::string>& environment) {
  std::vector<std::string> arguments{SLACKWATER_STORE_WORKER, store.string()};
  arguments.insert(arguments.end(), steps.begin(), steps.end());
  std::vector<std::string> settings;
  for (char** entry = environ; *entry != nullptr; ++entry) settings.emplace_back(*entry);
  for (const auto& [name, value] : environment) settings.push_back(name + "=" + value);
  const auto pointers = [](std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
  };
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int problem = ::posix_spawn(&pid_, arguments[0].c_str(), &actions, nullptr,
                                    pointers(arguments).data(), pointers(settings).data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  pipe_ = ends[0];
  if (problem != 0) throw std::runtime_error("cannot start " + arguments[0]);
}

WorkerProcess::~WorkerProcess() {
  kill();
  static_cast<void>(finish());
  ::close(pipe_);
}

void WorkerProcess::kill() const {
  if (pid_ > 0) ::kill(pid_, SIGKILL);
}

bool WorkerProcess::read_more() {
  char buffer[4096];
  ssize_t count = 0;
  do {
    count = ::read(pipe_, buffer, sizeof buffer);
  } while (count < 0 && errno == EINTR);
  if (count <= 0) return false;
  said_.append(buffer, static_cast<std::size_t>(count));
  return true;
}

bool WorkerProcess::wait_for(const std::string& line) {
  while (("\n" + said_).find("\n" + line + "\n") == std::string::npos) {
    if (!read_more()) return false;
  }
  return true;
}

std::vector<std::string> WorkerProcess::finish() {
  while (read_more()) {
  }
  if (pid_ > 0) {
    int status = 0;
    ::waitpid(pid_, &status, 0);
    exit_code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    pid_ = -1;
  }
  std::vector<std::string> lines;
  std::istringstream stream(said_.substr(0, said_.rfind('\n') + 1));
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::map<std::string, std::string> fault_environment(const std::filesystem::path& root,
                                                     const std::filesystem::path& log, long at,
                                                     int error, bool sticky) {
  return {{"LD_PRELOAD", SLACKWATER_FAULT_INJECTION},
          // Under AddressSanitizer the preloaded library comes first, which it would refuse.
          {"ASAN_OPTIONS", "verify_asan_link_order=0"},
          {"SLACKWATER_FAULT_ROOT", root.string()},
          {"SLACKWATER_FAULT_LOG", log.string()},
          {"SLACKWATER_FAULT_AT", std::to_string(at)},
          {"SLACKWATER_FAULT_ERRNO", std::to_string(error)},
          {"SLACKWATER_FAULT_STICKY", sticky ? "1" : "0"}};
}

bool has_line(const std::vector<std::string>& lines, const std::string& line) {
  return std::ranges::find(lines, line) != lines.end();
}

}  // namespace slackwater::store::tests

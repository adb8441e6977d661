#include "tests/bench/timed_child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bench {
namespace {

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ChildCost timed_child(const std::vector<std::string>& command) {
  const tests::TemporaryFolder folder;
  const std::string out = (folder / "out").string();
  std::vector<std::string> copies = command;
  std::vector<char*> argv;
  for (std::string& argument : copies) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(),
                                   O_WRONLY | O_CREAT | O_APPEND, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);

  ChildCost cost;
  pid_t child = -1;
  const auto from = std::chrono::steady_clock::now();
  const int failed = ::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    cost.exit_code = 127;
    cost.out = "cannot start " + command.front();
    return cost;
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  cost.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
  cost.cpu_s = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  cost.peak_resident_bytes = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  cost.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  std::ostringstream text;
  text << std::ifstream(out, std::ios::binary).rdbuf();
  cost.out = text.str();
  return cost;
}

ChildCost timed_slackwater(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), tests::program_path().string());
  return timed_child(arguments);
}

ChildCost slackwater_or_throw(std::vector<std::string> arguments) {
  std::string line = "slackwater";
  for (const std::string& argument : arguments) line += " " + argument;
  ChildCost cost = timed_slackwater(std::move(arguments));
  if (cost.exit_code != 0) {
    throw std::runtime_error(line + " ended with " + std::to_string(cost.exit_code) + ": " +
                             cost.out);
  }
  return cost;
}

}  // namespace slackwater::bench

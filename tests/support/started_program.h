#pragma once
#include <csignal>
#include <utility>

#include "tests/support/program.h"

namespace slackwater::tests {

/// A program that runs beside the test, and not for longer.
class StartedProgram {
 public:
  /// @param process  see `start_program`
  explicit StartedProgram(pid_t process) : process_(process) {}
  ~StartedProgram() {
    if (process_ > 0) (void)end(SIGKILL);
  }
  StartedProgram(const StartedProgram&) = delete;
  StartedProgram& operator=(const StartedProgram&) = delete;

  [[nodiscard]] pid_t process() const noexcept { return process_; }
  /// @return its exit code, 128 + signal where a signal ended it
  int end(int signal) {
    ::kill(process_, signal);
    return wait_for_program(std::exchange(process_, 0));
  }

 private:
  pid_t process_;
};

}  // namespace slackwater::tests

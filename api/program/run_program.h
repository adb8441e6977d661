#pragma once
#include <chrono>
#include <string>
#include <vector>

namespace slackwater::api {

/// How another program ended.
struct ProgramEnd {
  bool is_out_of_time = false;  ///< it was ended, with all that it had started
  int exit_code = 0;            ///< 128 + signal where a signal ended it
  std::string err;              ///< the first 4 KiB of what it said on standard error
};

/// Runs another program, without a shell: its path or its name on PATH, then its arguments as they
/// are. It reads `input` and nothing else; what it prints on standard output is dropped. At the
/// time limit, or when it ends, its process group is killed.
/// @param command     not empty
/// @throws Error(unavailable) where it cannot be started
[[nodiscard]] ProgramEnd run_program(const std::vector<std::string>& command,
                                     const std::string& input, std::chrono::milliseconds limit);

}  // namespace slackwater::api

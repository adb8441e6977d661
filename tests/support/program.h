#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slackwater::tests {

/// What a run of the program left behind.
struct ProgramResult {
  int exit_code = -1;  ///< 128 + signal where a signal ended it
  std::string out;
  std::string err;
};

/// Runs the built `slackwater` with these arguments and waits for it; `environment` adds to ours.
[[nodiscard]] ProgramResult run_program(const std::vector<std::string>& arguments,
                                        const std::map<std::string, std::string>& environment = {});

/// Starts it and returns at once, standard output and error to files (discarded unless named); the
/// caller waits or kills.
[[nodiscard]] pid_t start_program(const std::vector<std::string>& arguments,
                                  const std::map<std::string, std::string>& environment = {},
                                  const std::filesystem::path& out = "/dev/null",
                                  const std::filesystem::path& err = "/dev/null");

/// The same of another program, whose standard error goes where its output goes.
[[nodiscard]] pid_t start_other_program(const std::filesystem::path& program,
                                        const std::vector<std::string>& arguments,
                                        const std::filesystem::path& out = "/dev/null",
                                        const std::map<std::string, std::string>& environment = {});

/// Waits for a started program. @return its exit code, 128 + signal where a signal ended it.
int wait_for_program(pid_t program);

/// The path of the built program.
[[nodiscard]] std::filesystem::path program_path();

}  // namespace slackwater::tests

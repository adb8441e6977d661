#pragma once
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace slackwater {

/// A program to be run, without a shell.
struct ProgramAsked {
  std::vector<std::string> arguments;    ///< the first is the program: a path, or found by PATH
  std::vector<std::string> environment;  ///< all that it has: "NAME=value"; PATH from it
  std::filesystem::path folder;          ///< in which it works; empty: that of this process
  std::chrono::seconds longest{3600};    ///< by the clock
  std::uint64_t memory_bytes = std::uint64_t{8} << 30U;  ///< address space of each of its processes
  std::size_t most_output = std::size_t{256}
                            << 10U;  ///< of what it says the last so many bytes are kept
};

/// How it ended.
struct ProgramEnded {
  enum class End {
    exited,       ///< with `status`
    not_found,    ///< there is no such program, or it cannot be run: `output` says why
    killed,       ///< by `signal`, of whomever
    out_of_time,  ///< and was ended
    stopped,      ///< because that was asked for
  };
  End end = End::exited;
  int status = 0;
  int signal = 0;
  std::string output;  ///< the last of what it said, stdout and stderr as they came
};

/// Runs a program to its end. It has no descriptor of ours, no terminal and nothing to read; all
/// that it starts is ended with it. It dies with this process, which what it started may outlive.
/// From any thread, beside others.
/// @param is_stop_asked  looked at ten times a second; null: nobody asks
/// @throws Error(unavailable) where the system has no room for another process
[[nodiscard]] ProgramEnded run_program(const ProgramAsked& asked,
                                       const std::atomic<bool>* is_stop_asked = nullptr);

}  // namespace slackwater

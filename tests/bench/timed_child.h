#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace slackwater::bench {

/// What a whole process cost.
struct ChildCost {
  int exit_code = -1;  ///< 128 + signal where a signal ended it, 127 where it could not be started
  double wall_s = 0;   ///< from before it is started until it has been waited for
  double cpu_s = 0;    ///< user and system
  /// Largest resident set. The kernel counts the caller's own pages of the moment of starting, so a
  /// driver that stays small itself measures the child.
  std::uint64_t peak_resident_bytes = 0;
  std::string out;  ///< standard output, then standard error
};

/// Runs a program (looked up in PATH) with these arguments and waits for it.
[[nodiscard]] ChildCost timed_child(const std::vector<std::string>& command);

/// The same for the built `slackwater`.
[[nodiscard]] ChildCost timed_slackwater(std::vector<std::string> arguments);

/// `timed_slackwater` that must end with 0: else throws with what it said.
ChildCost slackwater_or_throw(std::vector<std::string> arguments);

}  // namespace slackwater::bench

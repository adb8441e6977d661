#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace slackwater::api {

/// What a process of its own may use before it is ended.
struct Allowance {
  std::chrono::seconds processor{600};  ///< of all its threads together
  std::uint64_t memory_bytes = std::uint64_t{8}
                               << 30U;  ///< of address space; no bound under a sanitizer
};

/// How work in a process of its own ended.
struct Apart {
  enum class End {
    answered,     ///< `answer` is what the work returned
    crashed,      ///< by a signal of a fault, or without a word
    out_of_time,  ///< its processor time was used up
    killed,       ///< by a signal from outside
  };
  End end = End::answered;
  std::string answer;
  int signal = 0;  ///< that ended it; 0: none
};

/// Says how far the work is, a share in [0, 1].
using TellShare = std::function<void(double)>;

/// Runs `work` in a child of this process, made for it, and returns what it returned: whatever the
/// libraries in it do to their memory, this process lives on. The child dies with this process.
///
/// The child is a copy of this process: what `work` shares with it (handles of a database, above
/// all) must not be open when this is called, and no other thread may be alive. `work` should let
/// no exception out; one that leaves it counts as a crash. Nothing that the child leaves in memory
/// is cleaned up: what must be closed, `work` closes.
///
/// @param on_share  hears, in this process, what `work` tells
/// @throws Error(unavailable) where the system has no room for another process
[[nodiscard]] Apart run_apart(const Allowance& allowance,
                              const std::function<std::string(const TellShare&)>& work,
                              const std::function<void(double)>& on_share);

}  // namespace slackwater::api

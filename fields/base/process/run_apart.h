#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "fields/base/process/confinement.h"

namespace slackwater {

/// What a process of its own may use before it is ended.
struct Allowance {
  std::chrono::seconds processor{60};  ///< of all its threads together; ten times that by the clock
  /// Of address space (without sanitizers, whose shadow takes terabytes), and in use (with them).
  std::uint64_t memory_bytes = std::uint64_t{4} << 30U;
  std::uint64_t file_bytes = std::uint64_t{64} << 30U;  ///< of each file that it writes
  Reach reach;
};

/// How work in a process of its own ended.
struct Apart {
  enum class End {
    answered,        ///< `answer` is what the work returned
    crashed,         ///< by a signal of a fault, or without a word
    out_of_time,     ///< its processor time was used up, or ten times that by the clock
    out_of_memory,   ///< it used more than it may
    wrote_too_much,  ///< to one file
    killed,          ///< by a signal from outside
  };
  End end = End::answered;
  std::string answer;
  int signal = 0;  ///< that ended it; 0: none
};

/// Whether no thread is alive in this process but this one and those that libraries began when they
/// were loaded.
[[nodiscard]] bool is_alone();

/// Says how far the work is, a share in [0, 1].
using TellShare = std::function<void(double)>;

/// Runs `work` in a child of this process, made for it and confined to its reach, and returns what
/// it returned: whatever the libraries in it do to their memory, this process lives on, and whoever
/// takes them over has no network, no other program and no file but these. The child dies with this
/// process. No descriptor of ours is open in it, but stderr under a sanitizer.
///
/// The child is a copy of this process: no other thread may be alive (`is_alone`). `work` should
/// let no exception out; one that leaves it counts as a crash. Nothing that the child leaves in
/// memory is cleaned up: what must be closed, `work` closes.
///
/// @param on_share  hears, in this process, what `work` tells
/// @param meanwhile  is done in this process once the child has begun, before it is listened to
/// @throws Error(unavailable) where the system has no room for another process
[[nodiscard]] Apart run_apart(const Allowance& allowance,
                              const std::function<std::string(const TellShare&)>& work,
                              const std::function<void(double)>& on_share,
                              const std::function<void()>& meanwhile = {});

}  // namespace slackwater

#pragma once
#include <atomic>
#include <deque>
#include <limits>
#include <mutex>

#include "twin/run/command.h"

namespace slackwater::twin {

/// Commands on their way into a run, by the step they ask for and then as they came. Thread-safe.
class CommandQueue {
 public:
  void put(Command command);
  /// Takes those that are due at a step. Where none is: no lock, no allocation.
  [[nodiscard]] std::vector<Command> take(std::uint64_t step);

  [[nodiscard]] std::vector<Command> waiting() const;
  /// Forgets what is waiting for these.
  void restore(std::vector<Command> waiting);

 private:
  static constexpr std::uint64_t never = std::numeric_limits<std::uint64_t>::max();
  void note_first();

  mutable std::mutex mutex_;
  std::deque<Command> waiting_;  ///< that is taken from the front
  std::atomic<std::uint64_t> first_step_{never};
};

}  // namespace slackwater::twin

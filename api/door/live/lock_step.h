#pragma once
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>

namespace slackwater::live {

/// Waits for the one answer to a step that another process gives: the run's thread asks, a thread
/// of the door answers. Answers to other steps are late, and dropped.
template <typename T>
class LockStep {
 public:
  /// What is handed in for this step alone counts from now on.
  void ask(std::uint64_t step) {
    const std::lock_guard lock(mutex_);
    step_ = step;
    answer_.reset();
    is_given_up_ = false;
  }
  /// @return whether anybody waits for it
  bool answer(std::uint64_t step, T value) {
    {
      const std::lock_guard lock(mutex_);
      if (step_ != step) return false;
      answer_ = std::move(value);
    }
    came_.notify_one();
    return true;
  }
  /// Nobody will answer any more: who waits goes on at once.
  void give_up() {
    {
      const std::lock_guard lock(mutex_);
      is_given_up_ = true;
    }
    came_.notify_one();
  }
  /// Nothing where it did not come in time, was given up, or not before the run was stopped.
  template <typename IsStopped>
  [[nodiscard]] std::optional<T> wait(std::chrono::duration<double> at_most,
                                      const IsStopped& is_stopped) {
    using namespace std::chrono;
    const auto until = steady_clock::now() + duration_cast<steady_clock::duration>(at_most);
    std::unique_lock lock(mutex_);
    while (!answer_ && !is_given_up_ && steady_clock::now() < until && !is_stopped())
      came_.wait_until(lock, std::min(until, steady_clock::now() + milliseconds(100)));
    step_.reset();
    return std::exchange(answer_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::condition_variable came_;
  std::optional<std::uint64_t> step_;
  std::optional<T> answer_;
  bool is_given_up_ = false;  ///< since it was asked
};

}  // namespace slackwater::live

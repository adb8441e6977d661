#pragma once
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>

#include "twin/run/awaited.h"

namespace slackwater::twin {

/// What people do to a run from another thread: pause it, let it make a step, go on, stop, and how
/// fast it goes. Thread-safe. It changes when steps are made, never what they are.
class RunControl {
 public:
  using WallClock = std::chrono::steady_clock;

  /// @param real_time_factor  1: as the clock on the wall; 0: as fast as the machine can
  explicit RunControl(double real_time_factor = 0) : factor_(real_time_factor) {}

  void pause();
  /// Lets a paused run make so many steps more, behind those that it was let make before.
  /// @return how many the run has made once it has made these; nothing: it is not paused
  std::optional<std::uint64_t> allow_steps(std::uint64_t steps);
  void resume();
  void stop();
  [[nodiscard]] bool is_paused() const;
  [[nodiscard]] bool is_stopped() const;

  /// For the run: where the clock on the wall starts.
  void start_clock(std::uint64_t step);
  /// Waits until the next step may be made. @return whether it may: not when stopped
  [[nodiscard]] bool may_step(std::uint64_t step, double step_s);
  /// When the step was due that was let go last; nothing: by hand, or as fast as the machine can.
  [[nodiscard]] std::optional<WallClock::time_point> due() const;
  /// Who keeps the run from its next step: said by those that wait for another process.
  [[nodiscard]] Awaited& awaited() noexcept { return awaited_; }
  [[nodiscard]] const Awaited& awaited() const noexcept { return awaited_; }

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  double factor_;
  bool paused_ = false;
  bool stopped_ = false;
  std::uint64_t allowed_ = 0;
  std::uint64_t let_go_ = 0;  ///< steps, the one under way included
  std::uint64_t first_step_ = 0;
  WallClock::time_point started_;
  std::optional<WallClock::time_point> due_;
  Awaited awaited_;
};

}  // namespace slackwater::twin

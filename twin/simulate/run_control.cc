#include "twin/simulate/run_control.h"

namespace slackwater::twin {

void RunControl::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  changed_.notify_all();
}

void RunControl::allow_steps(std::uint64_t steps) {
  const std::lock_guard lock(mutex_);
  allowed_ += steps;
  changed_.notify_all();
}

void RunControl::resume() {
  const std::lock_guard lock(mutex_);
  paused_ = false;
  allowed_ = 0;
  changed_.notify_all();
}

void RunControl::stop() {
  const std::lock_guard lock(mutex_);
  stopped_ = true;
  changed_.notify_all();
}

bool RunControl::is_paused() const {
  const std::lock_guard lock(mutex_);
  return paused_;
}

bool RunControl::is_stopped() const {
  const std::lock_guard lock(mutex_);
  return stopped_;
}

void RunControl::start_clock(std::uint64_t step) {
  const std::lock_guard lock(mutex_);
  first_step_ = step;
  started_ = WallClock::now();
}

std::optional<RunControl::WallClock::time_point> RunControl::due() const {
  const std::lock_guard lock(mutex_);
  return due_;
}

bool RunControl::may_step(std::uint64_t step, double step_s) {
  std::unique_lock lock(mutex_);
  due_.reset();
  while (!stopped_) {
    if (paused_) {
      if (allowed_ > 0) {
        --allowed_;
        return true;
      }
      changed_.wait(lock);
      // The time that was spent waiting is not caught up with.
      first_step_ = step;
      started_ = WallClock::now();
      continue;
    }
    if (factor_ <= 0) return true;
    const std::chrono::duration<double> due(static_cast<double>(step - first_step_) * step_s /
                                            factor_);
    const auto at = started_ + std::chrono::duration_cast<WallClock::duration>(due);
    if (WallClock::now() >= at) {
      due_ = at;
      return true;
    }
    changed_.wait_until(lock, at);
  }
  return false;
}

}  // namespace slackwater::twin

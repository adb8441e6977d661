#include "twin/run/run_control.h"

namespace slackwater::twin {

void RunControl::pause() {
  const std::lock_guard lock(mutex_);
  paused_ = true;
  changed_.notify_all();
}

std::optional<std::uint64_t> RunControl::allow_steps(std::uint64_t steps) {
  const std::lock_guard lock(mutex_);
  if (!paused_) return std::nullopt;
  allowed_ += steps;
  changed_.notify_all();
  return let_go_ + allowed_;
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
  let_go_ = step;
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
    if (paused_ && allowed_ == 0) {
      changed_.wait(lock);
      // The time that was spent waiting is not caught up with.
      first_step_ = step;
      started_ = WallClock::now();
      continue;
    }
    if (paused_) {
      --allowed_;
    } else if (factor_ > 0) {
      const std::chrono::duration<double> after(static_cast<double>(step - first_step_) * step_s /
                                                factor_);
      const auto at = started_ + std::chrono::duration_cast<WallClock::duration>(after);
      if (WallClock::now() < at) {
        changed_.wait_until(lock, at);
        continue;
      }
      due_ = at;
    }
    let_go_ = step + 1;
    return true;
  }
  return false;
}

}  // namespace slackwater::twin

#pragma once
#include <algorithm>
#include <chrono>

namespace slackwater::dds {

/// So much at once, and from then on so much a second: a bucket that fills up again.
class Budget {
 public:
  using Time = std::chrono::steady_clock::time_point;
  Budget(double at_once, double per_s) : at_once_(at_once), per_s_(per_s), left_(at_once) {}

  /// @return whether there is as much left, which is then taken
  bool take(double amount, Time now) noexcept {
    const std::chrono::duration<double> since = now - last_;
    last_ = now;
    left_ = std::min(at_once_, left_ + per_s_ * since.count());
    if (amount > left_) return false;
    left_ -= amount;
    return true;
  }

 private:
  double at_once_;
  double per_s_;
  double left_;
  Time last_{};
};

}  // namespace slackwater::dds

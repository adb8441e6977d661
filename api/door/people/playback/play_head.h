#pragma once
#include <algorithm>

#include "api/door/people/role.h"

namespace slackwater::people {

/// Where in a log a station is, and how fast it goes on. Times of the run are seconds, of the clock
/// that carries it milliseconds.
class PlayHead {
 public:
  static constexpr double least_rate = 0.1, most_rate = 100;

  PlayHead(double from_s, double to_s) : from_s_(from_s), to_s_(to_s), base_s_(from_s) {}

  [[nodiscard]] double at_s(Milliseconds now) const noexcept {
    if (!is_playing_) return base_s_;
    return std::min(to_s_, base_s_ + rate_ * seconds(now - base_at_));
  }
  [[nodiscard]] bool is_playing() const noexcept { return is_playing_; }
  [[nodiscard]] double rate() const noexcept { return rate_; }
  [[nodiscard]] bool is_at_end(Milliseconds now) const noexcept { return at_s(now) >= to_s_; }

  /// On from where it is. @param rate  of the run to the clock
  void play(double rate, Milliseconds now) noexcept {
    settle(at_s(now), now);
    rate_ = rate;
    is_playing_ = true;
  }
  void pause(Milliseconds now) noexcept {
    settle(at_s(now), now);
    is_playing_ = false;
  }
  /// To the nearest time of the log; it plays on if it played.
  void seek(double time_s, Milliseconds now) noexcept {
    settle(std::clamp(time_s, from_s_, to_s_), now);
  }

 private:
  void settle(double at_s, Milliseconds now) noexcept {
    base_s_ = at_s;
    base_at_ = now;
  }
  double from_s_, to_s_;
  double base_s_;
  Milliseconds base_at_ = 0;
  double rate_ = 1;
  bool is_playing_ = false;
};

}  // namespace slackwater::people

#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "twin/simulate/scheduler.h"

namespace slackwater::live {

/// How punctual the steps of a run at the pace of a clock are: when each began, beside when it was
/// due. An observer, at the opening of each step.
///
/// A second behind and more is taken for a pause, after which the clock of the run starts anew;
/// so does this one. A run as fast as the machine can is never late.
class Punctuality {
 public:
  using WallClock = std::chrono::steady_clock;
  static constexpr double late_s = 0.01;  ///< beyond which a step counts as late
  static constexpr double pause_s = 1;

  /// @param factor  of real time; 0: as fast as the machine can
  Punctuality(double factor, double step_s) : factor_(factor), step_s_(step_s) {}

  void begin(std::uint64_t step, WallClock::time_point now);

  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
  [[nodiscard]] std::uint64_t late_steps() const noexcept { return late_steps_; }
  [[nodiscard]] double worst_s() const noexcept { return worst_s_; }
  [[nodiscard]] std::uint64_t pauses() const noexcept { return pauses_; }
  /// "12000 steps, 3 of them (0.025 %) began more than 10 ms late, the worst by 14.2 ms".
  [[nodiscard]] std::string text() const;

 private:
  double factor_;
  double step_s_;
  std::uint64_t first_step_ = 0;
  WallClock::time_point first_{};
  std::uint64_t steps_ = 0;
  std::uint64_t late_steps_ = 0;
  std::uint64_t pauses_ = 0;
  double worst_s_ = 0;
};

}  // namespace slackwater::live

#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "twin/run/run_control.h"

namespace slackwater::live {

/// How punctual the steps of a run at the pace of a clock are: when each began, beside when it was
/// due by the clock of the run, which goes on while a step or who answers for it is slow, and
/// stands in a pause. An observer, at the opening of each step.
class Punctuality {
 public:
  using WallClock = twin::RunControl::WallClock;
  static constexpr double late_s = 0.01;  ///< beyond which a step counts as late

  /// @param factor  of real time; 0: as fast as the machine can
  explicit Punctuality(double factor) : factor_(factor) {}

  /// @param due  nothing: of a step by hand, or as fast as it goes, which is never late
  void begin(std::optional<WallClock::time_point> due, WallClock::time_point now);

  /// By the clock.
  [[nodiscard]] std::uint64_t steps() const noexcept { return steps_; }
  [[nodiscard]] std::uint64_t late_steps() const noexcept { return late_steps_; }
  [[nodiscard]] double worst_s() const noexcept { return worst_s_; }
  /// "12000 steps, 3 of them (0.025 %) began more than 10 ms late, the worst by 14.2 ms".
  [[nodiscard]] std::string text() const;

 private:
  double factor_;
  std::uint64_t steps_ = 0;
  std::uint64_t late_steps_ = 0;
  double worst_s_ = 0;
};

}  // namespace slackwater::live

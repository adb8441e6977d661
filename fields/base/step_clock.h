#pragma once
#include <cstddef>

#include "fields/base/time.h"

namespace slackwater {

/// Regular steps of time. Step i stands for [time_of(i), time_of(i + 1)).
struct StepClock {
  UtcTime first{};
  Duration step{};  ///< more than 0
  std::size_t steps = 0;

  [[nodiscard]] constexpr UtcTime time_of(std::size_t i) const noexcept {
    return first + step * static_cast<Duration::rep>(i);
  }
  /// The end of the last step.
  [[nodiscard]] constexpr UtcTime end() const noexcept { return time_of(steps); }
  [[nodiscard]] constexpr double step_h() const noexcept { return hours_of(step); }
  constexpr bool operator==(const StepClock&) const = default;
};

}  // namespace slackwater

#pragma once
#include <cstddef>

namespace slackwater::twin {

/// Starts on the grid of a forecast: every so many steps from the first one on.
struct StartSteps {
  std::size_t first = 0;
  std::size_t every = 1;
  std::size_t count = 0;
  [[nodiscard]] constexpr std::size_t step_of(std::size_t start) const noexcept {
    return first + start * every;
  }
};

}  // namespace slackwater::twin

#include "twin/render/light/fading.h"

namespace slackwater::twin {

// Without a branch, so that compilers lay them side by side.
void fade(std::span<double> x) noexcept {
  double* const values = x.data();
  const std::size_t count = x.size();
  for (std::size_t i = 0; i < count; ++i) values[i] = fading_within(values[i]);
}

}  // namespace slackwater::twin

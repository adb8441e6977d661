#pragma once
#include <algorithm>
#include <vector>

namespace slackwater {

/// Whether each value is above the one before it. NaN is above nothing.
template <typename T>
[[nodiscard]] bool ascends(const std::vector<T>& values) {
  return std::adjacent_find(values.begin(), values.end(),
                            [](const T& a, const T& b) { return !(a < b); }) == values.end();
}

}  // namespace slackwater

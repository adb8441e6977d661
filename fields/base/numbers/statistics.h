#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "fields/base/check.h"

namespace slackwater {

// The value that has as many below it as above. Of an even number of values two are in the middle;
// the name says which is meant. No value may be NaN, and there must be one at least.

/// The greater of the two in the middle. Always one of the values.
template <typename T>
[[nodiscard]] T upper_median(std::vector<T> values) {
  expects(!values.empty(), "a median is that of one value at least");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The smaller of the two in the middle. Always one of the values, whose order changes.
template <typename T>
[[nodiscard]] T lower_median_of(std::span<T> values) {
  expects(!values.empty(), "a median is that of one value at least");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}
/// The same of values that stay as they are.
template <typename T>
[[nodiscard]] T lower_median(std::vector<T> values) {
  return lower_median_of(std::span(values));
}

/// The mean of the two in the middle.
[[nodiscard]] inline double median(std::vector<double> values) {
  expects(!values.empty(), "a median is that of one value at least");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

}  // namespace slackwater

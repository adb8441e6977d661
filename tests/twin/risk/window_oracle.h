#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

// The definitions of twin/docs/operations.md, section 3, word by word: a step at a time, a list of
// all waits that is sorted. What the code under test counts by runs is held against it.

namespace slackwater::twin::oracle {

inline bool fits(const std::vector<std::uint8_t>& accessible, std::size_t t, std::size_t needed) {
  if (t + needed > accessible.size()) return false;
  for (std::size_t i = t; i < t + needed; ++i)
    if (accessible[i] == 0) return false;
  return true;
}

inline std::vector<std::uint8_t> starts(const std::vector<std::uint8_t>& accessible,
                                        std::size_t needed,
                                        const std::vector<std::uint8_t>& may_start) {
  std::vector<std::uint8_t> marks(accessible.size());
  for (std::size_t t = 0; t < marks.size(); ++t)
    marks[t] = fits(accessible, t, needed) && may_start[t] != 0 ? 1 : 0;
  return marks;
}

/// Steps to the first start at or after t; nothing where there is none.
inline std::optional<std::size_t> wait(const std::vector<std::uint8_t>& starts, std::size_t t) {
  for (std::size_t i = t; i < starts.size(); ++i)
    if (starts[i] != 0) return i - t;
  return std::nullopt;
}

/// Linear between order statistics.
inline double percentile(std::vector<std::size_t> values, std::size_t percent) {
  std::sort(values.begin(), values.end());
  const std::size_t at = (values.size() - 1) * percent;
  const auto low = static_cast<double>(values[at / 100]);
  if (at % 100 == 0) return low;
  const auto high = static_cast<double>(values[at / 100 + 1]);
  return low + (high - low) * static_cast<double>(at % 100) / 100;
}

}  // namespace slackwater::twin::oracle

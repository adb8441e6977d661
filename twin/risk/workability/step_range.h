#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace slackwater::twin {

/// Steps [begin, end) of a series.
struct StepRange {
  std::size_t begin = 0;
  std::size_t end = 0;
  [[nodiscard]] constexpr std::size_t steps() const noexcept { return end - begin; }
  constexpr bool operator==(const StepRange&) const = default;
};

/// Ranges in ascending order that do not overlap; none is empty.
using StepRanges = std::vector<StepRange>;

/// The maximal runs of steps whose mark is 1 (every other mark is 0). One pass.
[[nodiscard]] StepRanges runs_of(std::span<const std::uint8_t> marks);
/// The steps of [0, steps) that lie in none of the ranges.
[[nodiscard]] StepRanges outside(const StepRanges& ranges, std::size_t steps);
/// The steps that lie in both.
[[nodiscard]] StepRanges common_to(const StepRanges& a, const StepRanges& b);
[[nodiscard]] std::size_t steps_in(const StepRanges& ranges) noexcept;

}  // namespace slackwater::twin

#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace slackwater::twin {

enum class BoundSide { at_most, below, at_least, above };
/// "<=", "<", ">=", ">".
[[nodiscard]] std::string_view sign_of(BoundSide side) noexcept;

/// A bound on the values of a series. NaN is within none: what nobody knows is not workable.
struct Bound {
  BoundSide side = BoundSide::at_most;
  double value = 0;  ///< in the unit of the series
  [[nodiscard]] bool holds(double found) const noexcept {
    switch (side) {
      case BoundSide::at_most:
        return found <= value;
      case BoundSide::below:
        return found < value;
      case BoundSide::at_least:
        return found >= value;
      case BoundSide::above:
        return found > value;
    }
    return false;
  }
  bool operator==(const Bound&) const = default;
};

/// One mark a step, 1 where all holds so far.
using StepMarks = std::vector<std::uint8_t>;

/// Takes the mark off every step whose value is not within the bound.
/// @param values, marks  of the same length
void keep_within(const Bound& bound, std::span<const double> values, std::span<std::uint8_t> marks);
/// The same for steps whose value is NaN.
void keep_known(std::span<const double> values, std::span<std::uint8_t> marks);

}  // namespace slackwater::twin

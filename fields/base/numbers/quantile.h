#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace slackwater {

// The value below which a share of n values in order lies, by the rules of Hyndman and Fan (1996).
// Medians have a header of their own, fields/base/numbers/statistics.h.

/// Type 7, numpy's default: linear between the two neighbours of (n - 1) share. What is not finite
/// does not count. Nothing of none. @param share  0: the least, 1: the largest
[[nodiscard]] std::optional<double> quantile_of(std::vector<double> values, double share);

/// Where the p-th percentile of n values lies between its two neighbours in order: `below`, the
/// index of the lower one, and how far from it to the next, in hundredths.
///
///   (n - 1) p / 100 = below + hundredths / 100
///
/// Type 7 too, in whole numbers, so that no rounding moves it.
struct PercentilePlace {
  std::size_t below = 0;
  std::size_t hundredths = 0;

  [[nodiscard]] constexpr double between(double low, double high) const noexcept {
    return low + (high - low) * static_cast<double>(hundredths) / 100.0;
  }
};
/// @param count  1 at least  @param percent  0 to 100
[[nodiscard]] constexpr PercentilePlace percentile_place(std::size_t count,
                                                         std::size_t percent) noexcept {
  const std::size_t at = (count - 1) * percent;
  return {at / 100, at % 100};
}
/// @param ascending  one value at least  @param percent  0 to 100
[[nodiscard]] double percentile(std::span<const double> ascending, std::size_t percent);

/// The value nearest to (n - 1) share, halves up: always one of the values.
/// @param ascending  one value at least  @param share  0 to 1
[[nodiscard]] double nearest_quantile(std::span<const double> ascending, double share);

}  // namespace slackwater

#pragma once
#include <cstddef>
#include <span>

namespace slackwater::twin {

/// Where the p-th percentile of n values lies between its two neighbours in order: `below`, the
/// index of the lower one, and how far from it to the next, in hundredths.
///
///   (n - 1) p / 100 = below + hundredths / 100
///
/// Linear interpolation of order statistics (Hyndman and Fan 1996, type 7; numpy's default), in
/// whole numbers, so that no rounding moves it.
struct PercentilePlace {
  std::size_t below = 0;
  std::size_t hundredths = 0;
};
/// @param count  1 at least  @param percent  0 to 100
[[nodiscard]] constexpr PercentilePlace percentile_place(std::size_t count,
                                                         std::size_t percent) noexcept {
  const std::size_t at = (count - 1) * percent;
  return {at / 100, at % 100};
}
[[nodiscard]] constexpr double between(double low, double high, std::size_t hundredths) noexcept {
  return low + (high - low) * static_cast<double>(hundredths) / 100.0;
}

/// @param ascending  one value at least
[[nodiscard]] inline double percentile(std::span<const double> ascending, std::size_t percent) {
  const PercentilePlace place = percentile_place(ascending.size(), percent);
  const double low = ascending[place.below];
  if (place.hundredths == 0) return low;
  return between(low, ascending[place.below + 1], place.hundredths);
}

}  // namespace slackwater::twin

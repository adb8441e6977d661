#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace slackwater {

// What fields/base/numbers/lanes.h gives for eight numbers at once, for one: a formula written once
// over a type `Real` steps a single vehicle or eight, with the same IEEE operations in the same
// order, hence the same bits.

[[nodiscard]] inline double select(bool holds, double yes, double no) { return holds ? yes : no; }
[[nodiscard]] inline double larger_of(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double smaller_of(double a, double b) { return a < b ? a : b; }
[[nodiscard]] inline double absolute(double a) { return std::abs(a); }
[[nodiscard]] inline double square_root(double a) { return std::sqrt(a); }
/// table[index], for an index that is a whole number below 2^31.
[[nodiscard]] inline double entry_of(const double* table, double index) {
  return table[static_cast<std::int32_t>(index)];
}
/// The four numbers of a row of a table with rows of four.
[[nodiscard]] inline std::array<double, 4> four_entries_of(const double* table, double row) {
  const double* const first =
      table + static_cast<std::ptrdiff_t>(4 * static_cast<std::int32_t>(row));
  return {first[0], first[1], first[2], first[3]};
}
/// The whole number at or below x, |x| < 2^51. The sum with 1.5 2^52 has no room for a fraction.
[[nodiscard]] inline double whole_below(double x) {
  constexpr double rounder = 6755399441055744.0;
  const double near = (x + rounder) - rounder;
  return near > x ? near - 1.0 : near;
}

}  // namespace slackwater

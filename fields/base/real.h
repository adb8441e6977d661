#pragma once
#include <cmath>
#include <cstddef>

namespace slackwater {

// What fields/base/lanes.h gives for eight numbers at once, for one: a formula written once over a type `Real` steps a
// single vehicle or eight, with the same IEEE operations in the same order, hence the same bits.

[[nodiscard]] inline double select(bool holds, double yes, double no) { return holds ? yes : no; }
[[nodiscard]] inline double larger_of(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double smaller_of(double a, double b) { return a < b ? a : b; }
[[nodiscard]] inline double absolute(double a) { return std::abs(a); }
[[nodiscard]] inline double square_root(double a) { return std::sqrt(a); }
/// table[index], for an index that is a whole number.
[[nodiscard]] inline double entry_of(const double* table, double index) {
  return table[static_cast<std::size_t>(index)];
}
/// The whole number at or below x, |x| < 2^51.
[[nodiscard]] inline double whole_below(double x) { return std::floor(x); }

}  // namespace slackwater

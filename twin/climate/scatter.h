#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace slackwater::twin {

/// How many steps had two values in each pair of classes (`class_of`).
struct Scatter {
  std::vector<std::vector<std::size_t>> counts;  ///< by class of the first, by class of the second
  std::size_t known = 0;                         ///< steps that know both: shares are of these
  std::size_t missing = 0;                       ///< steps that lack one or both
};

/// @param first, second            of the same length; NaN where nobody knows
/// @param first_edges, second_edges  ascending
[[nodiscard]] Scatter scatter_of(std::span<const double> first, std::span<const double> first_edges,
                                 std::span<const double> second,
                                 std::span<const double> second_edges);

}  // namespace slackwater::twin

#pragma once
#include <cstddef>
#include <span>
#include <vector>

namespace slackwater::twin {

/// The greatest value of a storm, and the first step that has it.
struct StormPeak {
  std::size_t step = 0;
  double value = 0;
  bool operator==(const StormPeak&) const = default;
};

/// The storms of a series: values above a threshold belong to one storm as long as no
/// `separation_steps` lie between two of them. So peaks of neighbours are as good as independent
/// ("runs declustering": Coles 2001, section 5.3.2).
/// A missing value is not above; a gap of the separation parts a storm in two.
/// @param values  NaN where nobody knows
[[nodiscard]] std::vector<StormPeak> storm_peaks(std::span<const double> values, double threshold,
                                                 std::size_t separation_steps);

/// Thresholds between neighbouring values of a series, descending: those that from 0.03 % to 30 %
/// of its values exceed, in even steps of the logarithm. Half-way between two, since values written
/// with few digits stand for all that round to them.
/// @param values  NaN where nobody knows; empty: none
[[nodiscard]] std::vector<double> possible_thresholds(std::span<const double> values);

}  // namespace slackwater::twin

#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "fields/base/random.h"

namespace slackwater::calibration {

/// Both ends of an interval.
struct Interval95 {
  double low = 0;
  double high = 0;
};

/// One block of a block bootstrap: the sum over its values and their number (or weight). Values
/// within a block are not independent, so blocks are drawn whole; their sums are all that is
/// needed.
struct BlockSum {
  double sum = 0;
  double weight = 0;
};

/// 95 % percentile interval of the mean (total sum over total weight) by a block bootstrap: as many
/// blocks as there are, drawn with replacement.
///
/// @return empty for fewer than two blocks with weight
/// Throws ContractViolation for fewer than 40 draws. Cost: draws x blocks.
[[nodiscard]] std::optional<Interval95> bootstrap_mean(std::span<const BlockSum> blocks,
                                                       Rng& random, int draws = 1000);

/// The same for a root mean square: the sums are of squares.
[[nodiscard]] std::optional<Interval95> bootstrap_rms(std::span<const BlockSum> blocks, Rng& random,
                                                      int draws = 1000);

/// 95 % interval of the root mean square error by a block bootstrap: whole blocks (a day pair, say)
/// are drawn with replacement, since errors within one are not independent.
///
/// @param squared_error  per value
/// @param block          id of the block of each value; any numbers
/// @return empty for fewer than two blocks
[[nodiscard]] std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                                       std::span<const std::size_t> block,
                                                       Rng& random, int draws = 2000);

}  // namespace slackwater::calibration

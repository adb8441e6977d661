#pragma once
#include <cstddef>
#include <optional>
#include <span>

#include "fields/base/numbers/random.h"

// How far a mean of correlated numbers may lie from the truth. Errors of one day resemble those of
// the day before, errors of one hour those of the last: drawn one by one they claim far too much.

namespace slackwater::calibration {

/// Both ends of an interval.
struct Interval95 {
  double low = 0;
  double high = 0;
};

/// One member of a series: the sum over its values and their number (or weight). A pair of days, or
/// an hour of lead; what is within it is never torn apart.
struct BlockSum {
  double sum = 0;
  double weight = 0;
};

/// Fewer members are few: no interval is claimed of them, and tables say "few".
inline constexpr std::size_t fewest_for_interval = 5;

/// The lag-one autocorrelation of the departures from the weighted mean, in [0, 0.8]: the sample's
/// own, raised by its bias in a short series,
///
///   r + (1 + 4 r) / n
///
/// The upper end keeps series of ten from claiming that they know nothing. 0 for a constant series.
/// Source: Marriott and Pope (1954), Biometrika 41, 390, eq. for the serial correlation about an
/// estimated mean.
[[nodiscard]] double lag_one_autocorrelation(std::span<const BlockSum> series) noexcept;

/// How many neighbours are drawn together, for the mean of n members of a first-order
/// autoregression:
///
///   l = (sqrt(6) phi / (1 - phi^2))^(2/3) n^(1/3),  1 <= l <= n / 3
///
/// Source: the circular block bootstrap's best length of Politis and White (2004), Econometric
/// Reviews 23, 53, eq. 9 with Patton et al. (2009), ibid. 28, 372, for R(k) ~ phi^|k|.
[[nodiscard]] std::size_t block_length(std::size_t n, double autocorrelation) noexcept;

/// 95 % interval of the mean (total sum over total weight) of a series in the order of time, by a
/// circular block bootstrap: blocks of `block_length` neighbours drawn with replacement. Drawn
/// means are too close together in two known ways, and their departures are widened for both: the
/// variance that blocks of l lose in a first-order autoregression, and Student's t in place of the
/// normal law, of as many degrees of freedom as there are blocks, or independent members, less one.
///
/// How often it holds the true mean of a normal autoregression:
///
///   members      5     10     24     45    100    200
///   phi 0      .96    .96    .95    .95    .95    .95
///   phi 0.5    .84    .89    .92    .93    .94    .95     one by one: .73
///   phi 0.8    .75    .82    .90    .92    .93    .94     one by one: .47
///
/// A short series does not know its own memory. Squares of normal numbers are skewed: .03 to .10
/// less below 45 members, .01 to .05 less above. tests/calibration/skill/bootstrap_test.cc counts.
///
/// @return empty for fewer than `fewest_for_interval` members with weight
/// Throws ContractViolation for fewer than 40 draws. Cost: draws x members.
/// Source of the widening: Hesterberg (2015), The American Statistician 69, 371, sect. 4.2.
[[nodiscard]] std::optional<Interval95> bootstrap_mean(std::span<const BlockSum> series,
                                                       Rng& random, int draws = 1000);

/// The same for a root mean square: the sums are of squares.
[[nodiscard]] std::optional<Interval95> bootstrap_rms(std::span<const BlockSum> series, Rng& random,
                                                      int draws = 1000);

/// 95 % interval of the root mean square error of values that stand in members of a series.
///
/// @param squared_error  per value
/// @param member         of each value: numbers that ascend with time
/// @return empty for fewer than `fewest_for_interval` members
[[nodiscard]] std::optional<Interval95> bootstrap_rmse(std::span<const double> squared_error,
                                                       std::span<const std::size_t> member,
                                                       Rng& random, int draws = 2000);

}  // namespace slackwater::calibration

#pragma once
#include <cstddef>
#include <vector>

#include "fields/base/numbers/random.h"

namespace slackwater {

/// A variance density over angular frequency, linear between its points.
struct DensityTable {
  std::vector<double> frequency_rad_s;  ///< > 0, ascending, two or more
  std::vector<double> density_m2_s;     ///< >= 0
};

/// One of the sinusoids that stand for a spectrum.
struct VarianceShare {
  double frequency_rad_s = 0;
  double variance_m2 = 0;
};

/// Divides the area under a spectrum into `count` cells and draws one frequency from each.
///
/// The cells hold equal shares of
///
///   q(omega) = S/(2 m0) + omega^2 S/(2 m2)
///
/// so that half of them go where the height is and half where the velocity is: with cells of equal
/// variance alone, one would stand for the whole tail. Each share has the variance of its cell, so
/// their sum is m0 but for rounding. The frequency is drawn from the middle half of the cell's q:
/// differences between frequencies have no common measure, so that the sea does not repeat, and
/// neighbours stay half a cell apart, so that its variance settles within hours.
///
/// An empty spectrum (m0 = 0) gives nothing. count >= 1.
[[nodiscard]] std::vector<VarianceShare> divide_variance(const DensityTable& table,
                                                         std::size_t count, Rng& rng);

}  // namespace slackwater

#pragma once
#include <cstddef>

#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// An instrument's series without what its own neighbours give away as broken.
struct UnbrokenSeries {
  VectorColumn column;     ///< broken samples are `suspect`
  std::size_t spikes = 0;  ///< samples
  double stuck_h = 0;      ///< of the level that was stuck longest, in all
  UtcTime stuck_until{};   ///< the last stuck sample of any level
};

/// Marks broken samples, level by level.
///
/// - A spike departs from what its neighbours make of it (the median of straight lines through two
///   of the four nearest samples) by more than 0.3 m/s and more than eight times the usual
///   departure: beyond eight standard deviations of it one honest sample in 10^13 lies. One or two
///   samples long; a longer event is the water's.
/// - Stuck is what stays the same to the last digit: the vector for 3 h and five samples or more,
///   one component for 6 h and nine. Live water does so only within the instrument's resolution:
///   where a component's usual step is twice its smallest or less, it is not called stuck. (Else a
///   step is zero one time in six at most, and nine samples agree one time in 10^6.) A component
///   that never changes at all is stuck if the product's varied by 0.1 m/s meanwhile.
///
/// @param product  of the same time, any levels; only asked about a series that never changes
[[nodiscard]] UnbrokenSeries without_broken_samples(const VectorColumn& observed,
                                                    const VectorColumn& product);

}  // namespace slackwater::calibration

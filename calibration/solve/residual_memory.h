#pragma once
#include <span>

#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// How much of a day's misfit repeats itself.
struct ResidualMemory {
  double time_correlation = 0;   ///< |correlation| of consecutive times at one level, in [0, 1)
  double depth_correlation = 0;  ///< |correlation| of neighbouring levels at one time, in [0, 1)
  double effective_pairs =
      0;  ///< independent (time, level) pairs that n pairs are worth, in [1, n]
};

/// Counts the independent pairs behind a residual column (values where status is ok).
///
/// Along each axis m values with lag-one correlation c are worth m (1 - c)/(1 + c) independent ones
/// (first-order autoregressive noise; Bayley and Hammersley 1946), never fewer than one; the two
/// factors multiply. c is the modulus of the complex correlation about zero, not about the mean: a
/// bias and an inertial oscillation, which the steady model leaves behind, both count as memory. A
/// correlation within two standard errors of zero counts as none, so that white noise keeps its
/// full number.
[[nodiscard]] ResidualMemory residual_memory(const VectorColumn& residual);

}  // namespace slackwater::calibration

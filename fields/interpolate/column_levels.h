#pragma once
#include <vector>

#include "fields/interpolate/column.h"

namespace slackwater {

/// A column brought to other depths, linear between its levels; `missing` outside them (by more
/// than a millimetre) and where a neighbour has no value.
[[nodiscard]] VectorColumn at_depths(const VectorColumn& column,
                                     const std::vector<double>& depths_m);

/// A column brought to other times: at their centres, linear between cells at most `widest_gap`
/// apart, else the mean whose interval holds the time; `missing` elsewhere.
[[nodiscard]] VectorColumn at_times(const VectorColumn& column, const std::vector<TimeCell>& times,
                                    Duration widest_gap);

}  // namespace slackwater

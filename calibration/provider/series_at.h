#pragma once
#include <span>
#include <vector>

#include "calibration/skill/baseline.h"
#include "calibration/tide/fitted_tide.h"

namespace slackwater::calibration {

/// How the tide stands between a series and what is asked of it. `tide` has the levels that are
/// asked for; without levels, or null, there is none.
struct TideBetween {
  const FittedTide* tide = nullptr;
  bool is_in_series = true;  ///< the series contains it
};

/// A series of currents at other cells and depths.
///
/// The series without its tide is a line between the centres of its cells, the tide is added again:
/// six-hourly instants of a tidal sea are as good as hourly ones. A cell of the series itself is
/// given as it is. An asked mean is the mean of that line. Where neighbours lie further apart than
/// 12 h, or 1.25 of the usual step, or beyond the ends, there is nothing; a cell of up to three
/// hours speaks to its edges. In depth linear between levels; the shallowest speaks up to the
/// surface from 2 m, the deepest 2 m further down.
///
/// @return values over cells x depths, depth fastest
[[nodiscard]] BaselineForecast series_at(const VectorColumn& series, const TideBetween& between,
                                         std::span<const TimeCell> cells,
                                         std::span<const double> depth_m);

}  // namespace slackwater::calibration

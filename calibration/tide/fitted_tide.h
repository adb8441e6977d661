#pragma once
#include <string>
#include <vector>

#include "fields/current/tide.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The tide of every level, fitted on all of a record that holds it; empty where that is too short
/// for any.
struct FittedTide {
  std::vector<TideFit> levels;
  std::vector<std::string> notes;
  UtcTime since = UtcTime::min();  ///< before it the record has no tide (`tide_of_record`)

  /// Of a level, m/s; 0 where there is none.
  [[nodiscard]] Horizontal at(std::size_t level, const TimeCell& cell) const {
    return levels.empty() || cell.centre() < since ? Horizontal{}
                                                   : tidal_oscillation(levels[level], cell);
  }
};
/// @param known  a record that holds the tide throughout
[[nodiscard]] FittedTide fit_column_tide(const VectorColumn& known, Angle latitude);

}  // namespace slackwater::calibration

#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/insitu/station.h"

namespace slackwater::ingest {

/// The times of a point series and which of them can be used.
struct SeriesTimes {
  std::vector<TimeCell> cells;  ///< instants, or the stated averages
  std::vector<bool>
      usable;  ///< false where the file's own flag calls the time bad or it is missing
};

/// Reads the time axis (see `decode_point_series` on means). Irregular steps are normal here. Warns
/// where the stamps lie more than a day before the deployment that the file states: such an axis
/// keeps relative times at best. Throws Error(invalid_input) for stamps that repeat or run
/// backward.
[[nodiscard]] SeriesTimes series_times_of(const netcdf::File& file, const StationAxes& axes,
                                          std::vector<std::string>& warnings);

}  // namespace slackwater::ingest

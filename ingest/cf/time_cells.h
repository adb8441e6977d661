#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/copernicus/product.h"
#include "ingest/netcdf/file.h"

namespace slackwater::ingest {

/// When the values of `data` hold: instants, or means over their intervals.
///
/// In this order: `time: point` in cell_methods means instants; bounds of the time variable; a mean
/// rule of the product (title says "Hourly Mean"); `time: mean` in cell_methods with the step
/// between stamps, centred, with a warning; else instants. Throws Error(invalid_input) for stamps
/// that are missing, repeat or run backward.
[[nodiscard]] std::vector<TimeCell> time_cells(const netcdf::File& file,
                                               const netcdf::Variable& time,
                                               const netcdf::Variable& data, const Product& product,
                                               std::vector<std::string>& warnings);

}  // namespace slackwater::ingest

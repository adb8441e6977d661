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
/// rule of the product on what the file says (title says "Hourly Mean"); the name of the dataset in
/// the file or in its name (`…_PT1H-m`, `…_PT15M-i`); a mean rule on how far apart the stamps are,
/// with a warning; `time: mean` in cell_methods with the step between stamps, with a warning; else
/// instants, with a warning where the product has means too.
///
/// Where in its interval a mean is stamped: native files of Copernicus Marine have the middle, its
/// toolbox (`subset`) the start. On the clock both are told apart: 00:30 and 00:00 are [00:00,
/// 01:00]. Throws Error(invalid_input) for stamps that are missing, repeat or run backward, and
/// where one stamp leaves it open.
[[nodiscard]] std::vector<TimeCell> time_cells(const netcdf::File& file,
                                               const netcdf::Variable& time,
                                               const netcdf::Variable& data, const Product& product,
                                               std::vector<std::string>& warnings);

}  // namespace slackwater::ingest

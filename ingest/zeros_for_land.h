#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ingest/gridded_plan.h"

namespace slackwater::ingest {

/// Some files have no mask and write 0 on land and below the bed, which would read as still water.
///
/// A cell holds no values where both components of the current (or of the wind, or the significant
/// height of the waves) are exactly 0 at each of up to six times spread over the file, and no value
/// of theirs is missing anywhere. With fewer than three times that may be chance: then an area of
/// two cells by two is asked for. Marks such cells in the variables of the group and says so. A
/// field that is 0 everywhere is left as it is, with a warning.
///
/// Reads one time of each variable, the others only where there are zeros.
void mark_zeros_for_land(PlannedGroup& group, std::vector<std::string>& warnings);

/// Exact zeros of the marked cells become missing. `values` are (times, levels, rows, columns) of
/// the rows [first_row, first_row + rows).
void take_zeros_out(std::vector<float>& values, const std::vector<bool>& no_values,
                    const Grid& grid, std::size_t first_row, std::size_t rows,
                    DecodeCounts& counts);

}  // namespace slackwater::ingest

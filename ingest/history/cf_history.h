#pragma once
#include "ingest/history/read_history.h"

namespace slackwater::ingest {

/// Reads variables over time at one place from a CF NetCDF file: any variable with a standard name,
/// or with a short name that the vocabulary knows and no standard name, or that the user names.
///
/// Quality flags are heeded (`read_series`), packing and fill values too. Values are read in single
/// precision, in the unit of the file. A variable with levels is read at `depth_m`, between levels
/// linearly. Of means over an interval the interval's beginning stands for the time.
///
/// A file over several places is an error that says how to come to one.
[[nodiscard]] HistoryOfFile read_cf_history(const std::filesystem::path& file,
                                            const std::vector<std::string>& wanted,
                                            const HistoryOptions& options,
                                            const Vocabulary& vocabulary);

}  // namespace slackwater::ingest

#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "fields/record/history_series.h"
#include "ingest/copernicus/vocabulary.h"
#include "ingest/history/offer.h"

namespace slackwater::ingest {

/// What a user says of a file with the past of a place.
struct HistoryOptions {
  std::vector<NamedColumn> columns;
  std::string time_column;          ///< empty: `time`, `datetime`, ... or the file's time axis
  bool assume_utc = false;          ///< times of a table that state no zone are UTC
  std::optional<double> depth_m{};  ///< of a file with levels: at this depth or height
  std::vector<double> missing{};    ///< numbers that stand for "not measured"
};

/// A file's answer.
struct HistoryOfFile {
  /// One for each wanted quantity, in order; nothing where the file does not have it.
  std::vector<std::optional<HistorySeries>> series;
  std::vector<std::string> columns;   ///< of a table, or the variables
  std::vector<std::string> offered;   ///< standard names, and columns that the user named
  std::vector<std::string> warnings;  ///< to be read behind the file's name
};

/// Reads wanted quantities of the past of one place from a CSV table or a text file of NDBC
/// (csv_history.h), a table of observations (observation_table.h) or a NetCDF file (cf_history.h),
/// told apart by content. Memory grows with what is wanted alone.
///
/// Numbers that stand for "not measured" are missing, and told with their share: those of a known
/// producer (ndbc.h), of the user (`missing`), and what looks like one (sentinels.h). Then values
/// beyond belief (`Quantity::gross`) are missing, and told; where they are more than a tenth the
/// unit is wrong, which is an error.
///
/// @param wanted  standard names or names of columns (`making_of`)
/// @throws Error(not_found) for a file that is not there; Error(invalid_input) that names the file,
///         and the line of a table, for what cannot be read correctly
[[nodiscard]] HistoryOfFile read_history(const std::filesystem::path& file,
                                         const std::vector<std::string>& wanted,
                                         const HistoryOptions& options,
                                         const Vocabulary& vocabulary);

}  // namespace slackwater::ingest

#pragma once
#include <string>
#include <vector>

#include "ingest/history/read_history.h"

namespace slackwater::ingest {

/// Whether the names of columns are those of a table with an observation a row, as the Copernicus
/// Marine toolbox writes in-situ data:
///
///   variable,platform_id,platform_type,time,longitude,latitude,depth,pressure,...,value,value_qc
[[nodiscard]] bool is_observation_table(const std::vector<std::string>& columns);

/// Reads wanted quantities from such a table: what `variable` names by its short name (`VHM0`), in
/// the unit of the In Situ TAC's list of parameters (temperatures in degrees Celsius, else the
/// canonical one). What `value_qc` calls bad or missing (flags.h, Copernicus' table) is missing,
/// and told. Where a quantity has several depths it is read at `depth_m`, between depths linearly.
/// Rows of a quantity ascend in time.
///
/// @throws Error(invalid_input) for several platforms, or several depths without `depth_m`
[[nodiscard]] HistoryOfFile read_observation_table(const std::filesystem::path& file,
                                                   const std::vector<std::string>& wanted,
                                                   const HistoryOptions& options,
                                                   const Vocabulary& vocabulary);

}  // namespace slackwater::ingest

#pragma once
#include "ingest/history/read_history.h"

namespace slackwater::ingest {

/// Reads columns of a table of comma-separated values (RFC 4180) whose first line names them. Lines
/// that begin with # stand for comments, empty ones are passed over; where no line names the
/// columns the last comment with as many cells does. A line of units behind the names (ERDDAP) is
/// read as such; "UTC" there says the zone of the times. Blanks between the columns are read in
/// text files of NDBC alone (ndbc.h), whose times are UTC, the newest first or last.
///
/// A column is a quantity where the user says so (`--column`), or where its name is a CF standard
/// name that we know, perhaps with its unit behind it in brackets, `[m]`, `(m)` or THREDDS'
/// `[unit="m"]`; without one it is in the canonical unit. Other columns are left alone. A cell that
/// is empty, `NA`, `NaN`, `null`, `MM` or `-` is missing.
///
/// Times ascend, and each says where its zone is: Z or an offset. One that does not is an error
/// unless the user assumes UTC. Without `time_column` the column is `time`, `datetime`,
/// `date_time`, `timestamp`, `valid_time` or `date`.
[[nodiscard]] HistoryOfFile read_csv_history(const std::filesystem::path& file,
                                             const std::vector<std::string>& wanted,
                                             const HistoryOptions& options,
                                             const Vocabulary& vocabulary);

}  // namespace slackwater::ingest

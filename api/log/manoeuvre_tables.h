#pragma once
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

namespace slackwater::api {

/// * `manoeuvre`: a row for each manoeuvre of the vehicles' tasks;
/// * `order`: what they ordered, when. Their figures are counted from these times, and are made
///   from the rows of the log.
[[nodiscard]] std::vector<ingest::TrajectoryTable> manoeuvre_tables(
    const twin::RunAccount& account);
/// Reads them; without their figures. None in a log without them.
/// @throws Error(invalid_input) for what does not fit the vehicles, and for words of no version up
///         to this one
void read_manoeuvres(const ingest::TrajectoryFile& log, twin::RunAccount& account);

}  // namespace slackwater::api

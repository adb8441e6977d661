#pragma once
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

// What parts of an account are read from.

namespace slackwater::api {

/// The tables that logs of formats before 6 have as well: `mission`, `approach`, `clearance`.
void read_events(const ingest::TrajectoryFile& log, twin::RunAccount& account);
/// The bands of depth of those that cleaned, by the table `cleaning`.
void read_bands(const ingest::TrajectoryFile& log, twin::RunAccount& account);

/// What a log without the tables of an account tells: halts, batteries, tasks and energy off its
/// rows; what was cleaned and inspected by its tables. Before format 3 there is no table
/// `approach`: at the rows, structures along the straight ways between them, no tethers.
void read_off_rows(const ingest::TrajectoryFile& log, const twin::Scenario* scenario,
                   twin::RunAccount& account);

}  // namespace slackwater::api

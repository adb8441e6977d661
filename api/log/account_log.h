#pragma once
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

namespace slackwater::api {

/// The account of a run from its log: of one that this version wrote, the account that it was
/// written with, to the bit.
///
/// Logs before format 6, and those of other programs, tell less: it is read off their rows and
/// what tables they have (api/log/account_of_rows.h), at the times of the log.
/// @param scenario  of the log, where it holds one
/// @throws Error(invalid_input) for tables that do not fit the vehicles, or words that no version
///         up to this one writes
[[nodiscard]] twin::RunAccount account_in(const ingest::TrajectoryFile& log,
                                          const twin::Scenario* scenario);

/// The scenario that a log holds; nothing where it holds none or one of another version.
[[nodiscard]] std::optional<twin::Scenario> scenario_of(const ingest::TrajectoryFile& log);

/// The format of a log; 0: it does not say.
[[nodiscard]] int log_format_of(const ingest::TrajectoryFile& log);

/// The rows of one vehicle.
[[nodiscard]] twin::VehicleRows rows_of(const ingest::TrajectoryFile& log, std::size_t vehicle);

}  // namespace slackwater::api

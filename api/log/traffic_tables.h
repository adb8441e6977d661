#pragma once
#include <span>

#include "ingest/cf/trajectory_file.h"
#include "twin/run/traffic_watch.h"

namespace slackwater::api {

/// The traffic of a run as tables of its log: `vessel`, a row each (each piece of its track);
/// `report`, their positions, `vessel_reports` of them for each vessel, one vessel after the other
/// (a contiguous ragged array of CF); and `alarm`. Times are seconds since the start of the run, x
/// east and y north of the origin.
[[nodiscard]] std::vector<ingest::TrajectoryTable> traffic_tables(
    std::span<const twin::TrafficVessel> vessels, std::span<const twin::AlarmRecord> alarms);

/// SHA-256 of the vessels and all their reports; empty where there are none.
[[nodiscard]] std::string traffic_checksum(std::span<const twin::TrafficVessel> vessels);

/// The vessels of a log, to the last bit as they were written.
/// @throws Error(invalid_input) for tables that do not fit each other
[[nodiscard]] std::vector<twin::TrafficVessel> vessels_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

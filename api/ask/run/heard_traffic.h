#pragma once
#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

/// Reads the logs of AIS that a scenario names, those of its traffic and those that its vehicles
/// follow, into the vessels that surround the run: by MMSI over all logs, cut at jumps
/// (`twin/traffic/jumps.h`), near the origin and the run's time. What was left out is said in the
/// water's warnings; the files and their checksums in `traffic_files`.
///
/// @throws Error(not_found) for a file that is not there; Error(invalid_input) for one that is no
/// AIS, that holds nothing
///         of the run's time, or not a vessel that is asked for; Error(unavailable) where gpsdecode
///         is missing
void add_heard_traffic(const twin::Scenario& scenario, const std::filesystem::path& scenario_folder,
                       ScenarioWater& water);

/// The same from the log of a run, which holds all that was heard: no AIS and no gpsdecode are
/// needed to run it again.
void add_logged_traffic(const ingest::TrajectoryFile& log, const twin::Scenario& scenario,
                        ScenarioWater& water);

}  // namespace slackwater::api

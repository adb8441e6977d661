#pragma once
#include <span>

#include "api/ask/run/scenario_run.h"

namespace slackwater::api {

/// The log of a run as a file of tracks, with all that is needed to run it again: scenario, seed,
/// checksums of forecast and vehicles, version. Nothing in it tells when or where it was run. Its
/// tables come with `add_tables`.
[[nodiscard]] ingest::TrajectoryFile log_file_of(const twin::Scenario& scenario,
                                                 const ScenarioWater& water, const GeoPoint& origin,
                                                 const ScenarioResult& result,
                                                 std::span<const twin::Agent> agents);

/// Puts traffic, account, inspections and commands of a run into its file as tables.
void add_tables(const twin::Scenario& scenario, ScenarioResult& result);

/// "bluerov2_heavy 3f2a..., x500 ...": checksums of the vehicles' files, in the order of their
/// names.
/// @param commands  those that join the run by them are vehicles of it too
[[nodiscard]] std::string vehicle_checksums(const twin::Scenario& scenario,
                                            const std::filesystem::path& data_folder,
                                            std::span<const twin::Command> commands = {});

}  // namespace slackwater::api

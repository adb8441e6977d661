#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// The log of a run as tables for spreadsheets and pandas. `file` has a row per vehicle and logged
/// time: vehicle, time (ISO 8601, UTC), t_s (since the start), and each variable of the log with
/// its unit behind its name, `velocity_body_0_m_s`; parts of a vector count from 0. Lists beside
/// the tracks (other vessels, alarms) follow in files of their own, `run-alarm.csv` for `run.csv`.
/// A value that is not there is an empty cell; numbers read back as the same.
/// @return the files that were written
/// @throws Error(unavailable)
std::vector<std::filesystem::path> write_log_csv(const ingest::TrajectoryFile& log,
                                                 const std::filesystem::path& file);

/// "m s-1" as it stands behind a name: "m_s"; nothing for "1".
[[nodiscard]] std::string unit_suffix(std::string_view units);

}  // namespace slackwater::api

#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// The page of a run: tracks seen from above and, vehicle by vehicle, depth, attitude, thrust,
/// power and state of charge against the water and wind that were felt. Made of the log alone.
[[nodiscard]] std::string run_page_html(const ingest::TrajectoryFile& log,
                                        std::string_view plotting_library);
void write_run_page(const ingest::TrajectoryFile& log, const std::filesystem::path& file);

}  // namespace slackwater::api

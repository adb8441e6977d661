#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

struct RunPageChoice {
  /// What was planted and missed, and which reports are false. Else the page knows no more than
  /// whoever flies.
  bool shows_truth = false;
};

/// The page of a run: tracks seen from above, what was seen of the surfaces inspected and, vehicle
/// by vehicle, depth, attitude, thrust, power and state of charge against the water and wind that
/// were felt. Made of the log alone.
/// @throws Error(invalid_input) for a log without vehicles or times, or of a damaged inspection
[[nodiscard]] std::string run_page_html(const ingest::TrajectoryFile& log,
                                        std::string_view plotting_library,
                                        const RunPageChoice& choice = {});
void write_run_page(const ingest::TrajectoryFile& log, const std::filesystem::path& file,
                    const RunPageChoice& choice = {});

}  // namespace slackwater::api

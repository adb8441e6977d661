#pragma once
#include <filesystem>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::ingest {

/// `read_trajectories` in a confined process of its own (ingest/apart/read_apart.h): a log may be
/// somebody else's. Where other threads are alive, which no copy of a process has, it is read here.
[[nodiscard]] TrajectoryFile read_tracks_apart(const std::filesystem::path& file);

}  // namespace slackwater::ingest

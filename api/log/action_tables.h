#pragma once
#include <span>
#include <vector>

#include "data/store/session_action.h"
#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// What people did in a run, or were refused, as the table `action` of its log: a row each, in
/// order; none where nobody took part. Its columns are those of the record (api/docs/session.md).
[[nodiscard]] std::vector<ingest::TrajectoryTable> action_tables(
    std::span<const store::SessionAction> actions);

/// Those of a log. @throws Error(invalid_input) for a table that is none of ours
[[nodiscard]] std::vector<store::SessionAction> actions_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// The ways of the vessels around, for the map of a run's page: `[{name, x[], y[]}]`, their reports
/// of the run's time and the one on each side of it.
[[nodiscard]] nlohmann::json vessels_json(const ingest::TrajectoryFile& log);
/// What the vehicles followed and which alarms they had, as tables of HTML; nothing where there was
/// no traffic.
[[nodiscard]] std::string traffic_html(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

#pragma once
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "ingest/cf/trajectory_file.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::api {

/// The ways of the vessels around, for the map of a page: `[{name, x[], y[]}]`, their reports from
/// 0 to `until_s` and the one on each side of it.
[[nodiscard]] nlohmann::json vessels_json(std::span<const twin::TrafficVessel> vessels,
                                          double until_s);
/// Those of a log.
[[nodiscard]] nlohmann::json vessels_json(const ingest::TrajectoryFile& log);
/// What the vehicles followed and which alarms they had, as tables of HTML; nothing where there was
/// no traffic.
[[nodiscard]] std::string traffic_html(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

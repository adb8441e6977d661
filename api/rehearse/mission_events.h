#pragma once
#include <span>
#include <string>
#include <vector>

#include "api/rehearse/scenario_run.h"

namespace slackwater::api {

/// What vehicles that conduct themselves did and when, as the table `mission` of a log: a row an
/// event, by vehicle and time. `kind` and `cause` are words for programs, `text` is for people.
[[nodiscard]] ingest::TrajectoryTable mission_table(std::span<const twin::Agent> agents,
                                                    std::span<const VehicleSummary> vehicles);

/// A row of it.
struct MissionEvent {
  std::size_t vehicle = 0;
  double t_s = 0;  ///< since the start of the run
  std::string kind;
  std::string cause;
  std::string text;
};
/// Those of a log; none where it has no such table.
[[nodiscard]] std::vector<MissionEvent> mission_events_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

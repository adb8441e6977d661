#pragma once
#include "api/ask/rehearse/mission_file.h"
#include "api/ask/rehearse/rehearsal.h"
#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// All flights of a rehearsal, a trajectory for each vehicle of each: where it was, its charge,
/// what it needed for the way home, current and wind, phase; beside them a table of the flights.
[[nodiscard]] ingest::TrajectoryFile rehearsal_file(const LoadedMission& mission,
                                                    const RehearsalPlan& plan,
                                                    const Rehearsal& rehearsal);

/// The scenario of one flight: the mission's with its start, member and seed.
[[nodiscard]] twin::Scenario scenario_of_flight(const twin::Scenario& mission,
                                                const twin::FlightCase& flown);

}  // namespace slackwater::api

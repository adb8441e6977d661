#pragma once
#include <optional>
#include <span>
#include <vector>

#include "api/rehearse/vehicle_log.h"
#include "twin/simulate/agent.h"

namespace slackwater::api {

struct VehicleSummary;

/// How near a vehicle came to what was around it in a run, and to whom; nothing where there was
/// none of a kind. What is meant by each: twin/clearance/nearest_pass.h.
struct Closest {
  std::optional<Approach> vehicle;
  std::optional<Approach> structure;
  std::optional<Approach> vessel;  ///< of the traffic
  std::optional<Approach> tether;  ///< of another; `to` is that one
  friend bool operator==(const Closest&, const Closest&) = default;
};

/// Of a vehicle of a run, with the names that the scenario gives.
[[nodiscard]] Closest closest_of(const twin::NearestPasses& nearest,
                                 std::span<const twin::Agent> agents,
                                 const twin::Scenario& scenario,
                                 std::span<const twin::TrafficVessel> vessels);

/// The same of all vehicles as the table `approach` of a log, a row each.
[[nodiscard]] ingest::TrajectoryTable approach_table(std::span<const VehicleSummary> vehicles);
/// How often those that keep clear raised an alarm, by its cause, as the table `clearance`.
[[nodiscard]] ingest::TrajectoryTable clearance_table(std::span<const VehicleSummary> vehicles);

/// What a log says of its vehicle `i`: its table of the whole run. A log of a format without the
/// table has it read off its rows: at them, structures along the straight ways between them, no
/// tethers.
/// @param vehicles  those of the log; rows beyond theirs do not count
[[nodiscard]] Closest closest_in(const ingest::TrajectoryFile& log,
                                 const std::vector<VehicleLog>& vehicles, std::size_t i,
                                 const twin::Scenario* scenario);

/// "2 (structure 1, vessel without warning 1)", "none"; nothing for one that does not keep clear.
[[nodiscard]] std::optional<std::string> clearance_alarms_in(const ingest::TrajectoryFile& log,
                                                             std::size_t vehicle);
/// @param from  of each cause of `twin::AlarmCause`
[[nodiscard]] std::string clearance_alarms_text(std::span<const double> from);

}  // namespace slackwater::api

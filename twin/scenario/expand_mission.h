#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/config.h"
#include "fields/geo/geo_point.h"
#include "twin/mission/intensity.h"
#include "twin/mission/limit.h"
#include "twin/mission/work_site.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// What a mission needs from outside.
struct MissionParts {
  WorkSite site;
  std::optional<GeoPoint> origin;   ///< of the site; absent: as the mission says
  std::string site_id;              ///< whose forecast is the water where the mission names none
  std::vector<Assumption> assumed;  ///< beside those of the mission
  /// Whether the waves of a forecast err in its members, whatever the mission says.
  std::optional<bool> height_errors;
  /// Thins the work of every agent, beside what the mission says of its intensity.
  Intensity thinned_by;
  /// The description of a task by its id or path. @throws Error(not_found)
  std::function<Config(const std::string& id)> task;
};

/// What a task asks of the vehicle that an agent of it is.
struct Requirement {
  std::string agent;
  std::vector<std::string> kinds;  ///< rov, auv, uav, usv or vessel; none: any
  std::vector<std::string> needs;  ///< instruments
};

/// A mission made into a scenario.
struct ExpandedMission {
  Scenario scenario;               ///< all that it comes to: runs and replays by itself
  std::vector<std::string> tasks;  ///< names, for people
  std::vector<std::string> turbines;
  std::vector<std::string> workers;  ///< vehicles whose work counts for the success
  std::vector<Requirement> requirements;
  double water_depth_m = 0;  ///< at the deepest of the turbines
  bool is_thinned = false;   ///< some of its work looks less closely than its task does
};

/// Lays a mission's tasks out at its turbines.
///
///     name: Scour at A02
///     tasks: [scour_survey]          # ids of data/tasks, or paths
///     turbines: [A02]
///     site: example_farm             # read by the caller
///     start, duration, seed, step_s, log_every_s, water, waves, gusts, member, navigation,
///     traffic, log: as of a scenario
///     agents:                        # by role, what differs from the task's
///       inspector: {model: ..., autonomy: shared, faults: [...], state_of_charge: 0.9}
///       diver: {intensity: {density: 0.5, order: coarse_to_fine}}     # intensity.h
///       surveyor: {carrier: {name: tender, forward_m: -4, starboard_m: 6, up_m: 2}, swap: 20min}
///     vehicles: [...]                # more vehicles, as of a scenario; carriers: tenders.h
///     assume: {visibility_m: 5000}
///
/// Waves of a forecast have in each member the error of its height (`height_errors` of a scenario),
/// unless the mission says `waves: {height_errors: false}`.
///
/// Each agent of a task starts at its place by the first turbine, is launched, goes to each
/// turbine in turn and does its work there, and comes back; between sorties it stands aboard and
/// gets another battery. One with a carrier is taken from turbine to turbine on her deck, launched
/// at each and taken aboard again; without one a tether reaches one turbine. One on a tether is
/// stepped as twin/agent/coarse.h says, unless
/// `detail: full` stands at it.
/// @throws Error(invalid_input) with file and line
[[nodiscard]] ExpandedMission expand_mission(const Config& mission, const MissionParts& parts);

}  // namespace slackwater::twin

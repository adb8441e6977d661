#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "api/log/at_limits.h"
#include "api/log/attention.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"
#include "twin/scenario/scenario.h"

// How people did at the vehicles of a logged live run, so that two of them, or two ways of showing
// them the run, can be held against each other.

namespace slackwater::api {

/// One seat at one vehicle. Latencies are of the clock of the wall, as people have it, but for
/// `hold_in_force_s`; times at the helm are of the run, which stands still while it is paused.
struct HelmScore {
  std::string vehicle;  ///< empty: what was asked of none

  // How the helm was had.
  std::vector<double> asked_to_had_s;  ///< of each time that it asked and got it; free: 0
  std::size_t asked_in_vain = 0;       ///< refused, denied, withdrawn, lapsed, or the run was over
  std::size_t taken_over = 0;          ///< by take-back or HOLD of a supervisor
  std::size_t turns = 0;               ///< at the helm
  std::vector<double> had_to_command_s;  ///< its first one, of turns that were asked for
  std::size_t turns_without_command = 0;
  std::size_t links_lost = 0;  ///< while it had the helm
  /// Of a supervisor's holds and take-backs, of the run: from when they came in until the step
  /// before which they took effect. Nothing: the log's commands do not fit its record.
  std::optional<std::vector<double>> hold_in_force_s;

  // What was done with it.
  double at_helm_s = 0;        ///< without the time for which its station was cut off
  std::uint64_t commands = 0;  ///< taken: each stick, each order
  std::uint64_t refused = 0;   ///< likewise
  std::map<std::string, std::uint64_t> refused_for;  ///< by reason
  std::size_t off_mission = 0;                       ///< commands that took it off its own mission
  std::size_t off_helm = 0;  ///< times that it took another's helm, who had not given it

  std::optional<AtLimits> at_limits;  ///< at its helm; nothing: the log does not tell
};

struct PersonScore {
  unsigned seat = 0;
  std::string name;
  std::string role;                    ///< "operator"
  std::vector<HelmScore> helms;        ///< by the name of the vehicle
  std::optional<Attention> attention;  ///< nothing: it had none kept
};

/// How often somebody stepped in.
struct SteppedIn {
  std::size_t off_mission = 0;  ///< commands that took a vehicle off its own mission
  std::size_t off_helm = 0;     ///< or off the helm of another, who had not given it
};

struct PeopleScore {
  double ran_s = 0;
  std::optional<double> log_every_s;         ///< of the positions, at most; nothing: there is one
  std::vector<PersonScore> people;           ///< by seat; none: nobody took part
  std::map<std::string, SteppedIn> by_role;  ///< "operator", "supervisor"; "agent": a program
};

/// @param account   of the same log
/// @param scenario  of the log, where it holds one
/// @throws Error(invalid_input) for tables that are none of ours
[[nodiscard]] PeopleScore people_score_of(const ingest::TrajectoryFile& log,
                                          const twin::RunAccount& account,
                                          const twin::Scenario* scenario);

}  // namespace slackwater::api

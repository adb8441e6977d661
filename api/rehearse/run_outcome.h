#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/simulate/scenario.h"

// How a run came out, from its log alone: for the page, and for logs of other versions.

namespace slackwater::api {

/// Something that happened to a vehicle.
struct RunEvent {
  double t_s = 0;
  std::size_t vehicle = 0;
  std::string what;  ///< "task 2 begins", "struck", "alarm: tug"
};

/// One vehicle's outcome, in words and margins. What a log does not hold is not there.
struct VehicleOutcome {
  std::string name;
  std::string verdict;  ///< "Ran to the end; 1 of 2 tasks done."
  bool is_stopped = false;
  std::vector<std::pair<std::string, std::string>> margins;  ///< what, and how much of it
};

/// The scenario that a log holds; nothing where it holds none or one of another version.
[[nodiscard]] std::optional<twin::Scenario> scenario_of(const ingest::TrajectoryFile& log);

/// Tasks, or what a mission says of them, cut-offs, halts and alarms, by time.
[[nodiscard]] std::vector<RunEvent> events_of(const ingest::TrajectoryFile& log,
                                              const twin::Scenario* scenario);

/// Energy left, largest errors, attitudes and tensions: extremes of the logged rows up to the one
/// at which the vehicle stopped. Closest approaches as `closest_in` has them, clearance alarms.
[[nodiscard]] std::vector<VehicleOutcome> outcomes_of(const ingest::TrajectoryFile& log,
                                                      const twin::Scenario* scenario);

/// Why a vehicle stopped, in words, for the number that a log holds (0: it did not); the names are
/// those that the log itself gives to the numbers.
[[nodiscard]] std::string halt_in_words(const ingest::TrajectoryFile::Variable& halt, int number);

}  // namespace slackwater::api

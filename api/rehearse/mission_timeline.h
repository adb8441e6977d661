#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/rehearse/mission_events.h"
#include "ingest/cf/trajectory_file.h"

// What vehicles that conduct themselves did, hour by hour, from the mission events of a log.

namespace slackwater::api {

/// A time through which a vehicle did one thing.
struct MissionStretch {
  double from_s = 0;  ///< since the start of the run
  double to_s = 0;
  std::string phase;  ///< "work"
  std::string doing;  ///< "holds", "goes back", "comes home"; empty: its task
};

/// How one vehicle's mission ended.
struct MissionEnd {
  double t_s = 0;
  bool is_done = false;
  std::string why;  ///< of one that is not done: "comes home: limit: ..."
};

/// One after the other, up to its end; empty for a vehicle without events.
[[nodiscard]] std::vector<MissionStretch> stretches_of(const std::vector<MissionEvent>& events,
                                                       std::size_t vehicle, double log_ends_s);
/// Nothing for a vehicle without events.
[[nodiscard]] std::optional<MissionEnd> mission_end_of(const std::vector<MissionEvent>& events,
                                                       std::size_t vehicle, double log_ends_s);

/// "Done: eye by 06:12 UTC." or "Not done: eye: comes home: limit: ... (ended 06:05 UTC)."; empty
/// for a run without missions. @param is_done  whether all of them are
[[nodiscard]] std::string mission_headline(const ingest::TrajectoryFile& log,
                                           const std::vector<MissionEvent>& events, bool& is_done);

}  // namespace slackwater::api

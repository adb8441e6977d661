#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/simulate/run_log.h"

namespace slackwater::api {

/// Something that befell a vehicle, in words.
struct FateEvent {
  std::string what;  ///< "battery empty", "struck the sea"
  double at_s = 0;   ///< since the start of the run; no number: it follows from the one before it
};

/// What befell a vehicle, causes first; nothing where its run was a normal one.
[[nodiscard]] std::vector<FateEvent> fate_of(const twin::Agent& agent,
                                             const twin::AgentState& state);

/// "battery empty at 18:42:10Z → fell → struck the sea at 18:42:14Z"; empty for no events.
[[nodiscard]] std::string fate_text(const std::vector<FateEvent>& events, UtcTime start);

/// How far a vehicle was from where it should have been, until it halted.
struct TrackQuality {
  double sailed_m = 0;  ///< over ground
  double rms_across_m = 0;
  double rms_depth_error_m = 0;
  double largest_depth_error_m = 0;  ///< of its size
};
[[nodiscard]] TrackQuality track_quality(const twin::RunLog& log, std::size_t vehicle);

struct VehicleSummary;

/// How the vehicles fared as a table of the log, `fate`, a row each.
[[nodiscard]] ingest::TrajectoryTable fate_table(const std::vector<VehicleSummary>& vehicles);
/// "battery empty at ...": of one vehicle of a log; empty where its run was a normal one, or where
/// the log tells no fates.
[[nodiscard]] std::string fate_in(const ingest::TrajectoryFile& log, std::size_t vehicle);
/// "uav: battery empty at ...; auv: ...": of the vehicles of a log whose run was not a normal one.
[[nodiscard]] std::string fates_in(const ingest::TrajectoryFile& log);
/// The table for people; empty where the log has none.
[[nodiscard]] std::string fate_html(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api

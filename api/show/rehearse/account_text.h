#pragma once
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

// The account of a run in words: for pages and terminals.

namespace slackwater::api {

/// "Battery empty at 18:42:10Z; 1 of 2 tasks done.", "Ran to the end."
[[nodiscard]] std::string verdict_text(const twin::VehicleAccount& vehicle, UtcTime start);

/// What, and how much of it: energy, what was cleaned and inspected, figures of manoeuvres, closest
/// approaches, largest errors and attitudes with their times. What an account does not hold is not
/// there.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> margins_of(
    const twin::VehicleAccount& vehicle, UtcTime start);

/// "uav: battery empty at ...; auv: ...": of the vehicles whose run was not a normal one.
[[nodiscard]] std::string fates_text(const twin::RunAccount& account);

/// "Done: eye by 06:12 UTC." or "Not done: eye: comes home: limit: ... (ended 06:05 UTC)."; empty
/// for a run without missions. Those of whom `fates_text` tells are left out. What was seen, where
/// something is asked, stands beside it: "Not seen: eye: less than 90 % covered by the ...".
[[nodiscard]] std::string mission_headline(const twin::RunAccount& account);
/// Whether all that have missions have done them.
[[nodiscard]] bool all_missions_done(const twin::RunAccount& account);
/// Whether all inspections covered what is asked of them.
[[nodiscard]] bool all_seen(const twin::RunAccount& account);

/// Something that happened to a vehicle, for a list by time.
struct EventLine {
  double t_s = 0;
  std::size_t vehicle = 0;
  std::string what;  ///< "task 2 begins", "struck a structure", "alarm: tug"
};
/// What befell vehicles and what their missions say; where they have none, their tasks by the rows
/// of the log; joins, cut-offs of batteries and alarms by the log.
[[nodiscard]] std::vector<EventLine> event_lines(const ingest::TrajectoryFile& log,
                                                 const twin::RunAccount& account);

/// "2 (structure 1, vessel without warning 1)", "none".
[[nodiscard]] std::string alarms_text(const twin::ClearanceAccount& clearance);
/// "guard", or the MMSI of a vessel that nobody named.
[[nodiscard]] std::string name_of(const twin::Approach& approach);

}  // namespace slackwater::api

#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/log/detection_log.h"
#include "api/log/people_score.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"

// How well the vehicles of logged runs did, whatever steered them.

namespace slackwater::api {

/// The scorecard of a run.
struct Scorecard {
  std::string run;  ///< its title
  std::string seed;
  twin::RunAccount account;
  PeopleScore people;                     ///< of a live run in which people took part
  std::vector<DetectorRecord> detectors;  ///< that looked at pictures of it
};
/// @throws Error(invalid_input) for a log without positions
[[nodiscard]] Scorecard scorecard_of(const ingest::TrajectoryFile& log);

/// From when it was there until its mission ended: what it does then, hovering where others still
/// work, is not scored. Of one without a mission, or without an end, that it is in the log.
[[nodiscard]] double scored_time_s(const twin::VehicleAccount& vehicle);
/// Its mission finished without turning for home or halting.
[[nodiscard]] bool is_scored_done(const twin::VehicleAccount& vehicle, double ran_s);
/// Electrical; nothing where it draws or goes nothing.
[[nodiscard]] std::optional<double> energy_per_metre_j(const twin::VehicleAccount& vehicle);

/// Mean and standard deviation over runs.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< of a sample; 0 for one
  std::size_t runs = 0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

}  // namespace slackwater::api

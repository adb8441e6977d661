#pragma once
#include <optional>
#include <string>
#include <vector>

#include "api/rehearse/inspection_log.h"
#include "ingest/cf/trajectory_file.h"

namespace slackwater::api {

/// How well one vehicle of one logged run did, whatever steered it.
struct VehicleScore {
  std::string name;
  double time_s = 0;     ///< until its last task ended; without an end, that it is in the log
  bool is_done = false;  ///< its log says that it finished without turning for home or halting
  double sailed_m = 0;   ///< over ground
  double rms_across_track_m = 0;
  double largest_across_track_m = 0;
  double rms_depth_error_m = 0;
  std::optional<double> energy_per_metre_j;  ///< electrical; none: it draws or goes nothing
  /// Over the whole run, as its log says it (`closest_in`).
  std::optional<double> closest_structure_m;
  std::optional<double> closest_vehicle_m;
  std::optional<double> closest_vessel_m;
  std::optional<double> closest_tether_m;
  std::size_t interventions = 0;  ///< times it left its task: holds and ways home
  double takeover_s = 0;          ///< spent away from it, until it was resumed
  double longest_takeover_s = 0;
  std::size_t limit_violations = 0;            ///< interventions that a limit called for
  std::optional<LoggedInspection> inspection;  ///< of one that inspects
};

/// The scorecard of a run.
struct Scorecard {
  std::string run;  ///< its title
  std::string seed;
  std::vector<VehicleScore> vehicles;
};

/// @throws Error(invalid_input) for a log without positions
[[nodiscard]] Scorecard scorecard_of(const ingest::TrajectoryFile& log);

/// Mean and standard deviation over runs.
struct Spread {
  double mean = 0;
  double deviation = 0;  ///< of a sample; 0 for one
  std::size_t runs = 0;
};
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

}  // namespace slackwater::api

#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "twin/helm/command_arbiter.h"
#include "twin/run/run.h"
#include "twin/run/run_log.h"
#include "twin/run/sensor_log.h"
#include "twin/run/traffic_watch.h"

namespace slackwater::api {

// A run that stands still in a file, to be gone on with. Text but for the rows logged so far:
//
//   slackwater checkpoint 1
//   <SHA-256 of all that follows this line>
//   <length of the JSON in bytes>
//   <JSON: what it belongs to, and each vehicle's state; doubles in hexadecimal, exact to the
//    last bit>
//   <times and rows of the log, doubles as they lie in memory>

/// What a checkpoint belongs to; it is taken up by nothing else.
struct CheckpointOrigin {
  std::string program;          ///< version and commit
  std::string scenario_sha256;  ///< of its text
  std::string forecast_sha256;  ///< empty: made up
  std::string vehicles;         ///< checksums of their files
  std::string traffic_sha256;   ///< of the other vessels' tracks; empty: none
};

/// Everything a run goes on with: its states and what it has logged.
struct StandingRun {
  twin::Run::Checkpoint checkpoint;
  twin::RunLog log;
  std::vector<std::vector<double>> sensor_rows;
  double last_sensor_row_s = -1;
  twin::TrafficWatch::State watch;
  std::vector<twin::RefusalCount> refusals;  ///< of commands from outside
  std::string newcomers;  ///< checksums of the files of vehicles that joined; empty: none
};

/// Whole or not at all: written beside the file, synced and moved into its place.
/// @throws Error(unavailable) where it cannot be written
void write_checkpoint(const StandingRun& run, const CheckpointOrigin& origin,
                      const std::filesystem::path& file);

/// @throws Error(not_found), and Error(invalid_input) for a file that is damaged, cut short, no
/// checkpoint, or one of another
///         program, scenario, forecast or vehicle
[[nodiscard]] StandingRun read_checkpoint(const std::filesystem::path& file,
                                          const CheckpointOrigin& origin);

}  // namespace slackwater::api

#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ingest/cf/trajectory_file.h"
#include "twin/body/attitude.h"

// What detectors found in the pictures of a run, as its log keeps it. The run itself is the same
// with or without: the pictures are made from its log.

namespace slackwater::api {

/// How much of what was there was found, of one kind.
struct KindFound {
  std::string of;
  std::size_t in_view = 0;  ///< planted, and shown well enough by some picture
  std::size_t found = 0;    ///< of these
  std::size_t false_alarms = 0;
};

/// A find in one picture.
struct LoggedFind {
  std::string of;
  std::string surface;  ///< "A01/monopile"
  double t_s = 0;       ///< since the start of the run
  double confidence = 0;
  double left_px = 0, top_px = 0, wide_px = 0, high_px = 0;
  twin::Triple<double> place_m;  ///< NED of the run
  double range_m = 0;
  double size_m = 0;
  std::size_t finding = 0;              ///< finds of one place have the same number, from 0
  std::optional<std::uint32_t> defect;  ///< of the run's planted ones
};

/// What one detector found in the pictures of one camera.
struct DetectorRecord {
  std::size_t vehicle = 0;  ///< of the log, from 0
  std::string sensor;
  std::string detector;
  std::size_t pictures = 0;
  std::vector<KindFound> kinds;  ///< one for each that the detector knows
  std::vector<LoggedFind> finds;
};

/// Adds a record, in place of an earlier one of the same vehicle, sensor and detector: a row for
/// each of its kinds in the table `detector_kind`, for each of its finds in `detection`.
/// @throws Error(invalid_input) where the log's records are damaged
void add_detections(const DetectorRecord& record, ingest::TrajectoryFile& log);

/// Empty where no detector looked. @throws Error(invalid_input) where the tables are damaged
[[nodiscard]] std::vector<DetectorRecord> detections_in(const ingest::TrajectoryFile& log);

/// The run alone. @return whether there was something to take off
bool take_off_detections(ingest::TrajectoryFile& log);

}  // namespace slackwater::api

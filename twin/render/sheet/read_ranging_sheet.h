#pragma once
#include "fields/base/config.h"
#include "twin/render/ranging/echo_sounder.h"
#include "twin/render/ranging/imaging_sonar.h"
#include "twin/render/ranging/lidar.h"
#include "twin/render/ranging/multibeam.h"
#include "twin/render/ranging/side_scan.h"
#include "twin/sensor/adcp.h"

namespace slackwater::twin {

// The parts of a file of data/sensors that tell of what measures ranges: the names of the keys are
// those of the values, angles in degrees. @throws Error(invalid_input) for what cannot be

[[nodiscard]] LidarSheet read_lidar_sheet(const Config& lidar);
[[nodiscard]] ImagingSonarSheet read_imaging_sonar_sheet(const Config& sonar);
[[nodiscard]] SideScanSheet read_side_scan_sheet(const Config& side_scan);
[[nodiscard]] MultibeamSheet read_multibeam_sheet(const Config& multibeam);
[[nodiscard]] EchoSounderSheet read_echo_sounder_sheet(const Config& echo_sounder);
/// @param sensor  the whole file: its range has to hold all bins
[[nodiscard]] Adcp read_profiler_sheet(const Config& sensor);

}  // namespace slackwater::twin

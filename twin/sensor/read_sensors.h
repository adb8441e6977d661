#pragma once
#include <optional>

#include "fields/base/config.h"
#include "twin/sensor/adcp.h"
#include "twin/sensor/camera.h"
#include "twin/sensor/compass.h"
#include "twin/sensor/depth_sensor.h"
#include "twin/sensor/dvl.h"
#include "twin/sensor/gnss.h"
#include "twin/sensor/imu.h"
#include "twin/sensor/range_sonar.h"

namespace slackwater::twin {

/// What a vehicle carries.
struct Sensors {
  std::optional<Gnss> gnss;
  std::optional<Imu> imu;
  std::optional<DepthSensor> depth;
  std::optional<Compass> compass;
  std::optional<Dvl> dvl;
  std::optional<Adcp> adcp;
  std::optional<RangeSonar> sonar;
  std::optional<Camera> camera;
};

/// `sensors` of a vehicle's YAML: a mapping of `gnss`, `imu`, `depth`, `compass`, `dvl`, `adcp`,
/// `sonar`, `camera`, each with what differs from its defaults (`gnss: {}` is one with none).
/// Angles in degrees.
/// @throws Error(invalid_input) for what no such sensor can be
[[nodiscard]] Sensors read_sensors(const Config& vehicle);

}  // namespace slackwater::twin

#pragma once
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "fields/geo/geo_point.h"
#include "twin/agent/agent.h"

namespace slackwater::dds {

// What a vehicle tells, as messages. World frame `map`: ENU at the run's origin; body frame
// NAME/base_link: forward, left, up. All stamps are times of the run.

/// nav_msgs/msg/Odometry: where the vehicle takes itself to be, by its own instruments where it
/// goes by them, else the truth; its velocity over ground in its own axes.
[[nodiscard]] Bytes odometry(const twin::Agent& agent, const twin::AgentState& state,
                             const std::string& name, const Stamp& stamp);
/// geometry_msgs/msg/PoseStamped: where it truly is.
[[nodiscard]] Bytes pose(const twin::AgentState& state, const Stamp& stamp);
/// sensor_msgs/msg/BatteryState; of one with fuel alone `present` is false.
[[nodiscard]] Bytes battery_state(const twin::Agent& agent, const twin::AgentState& state,
                                  const std::string& name, const Stamp& stamp);
/// 1 charging (never), 2 discharging, 3 neither, 4 full; what `battery_state` says.
[[nodiscard]] std::uint8_t battery_status(const twin::AgentState& state) noexcept;

// --- its instruments, as they showed last ---
/// sensor_msgs/msg/Imu; orientation: what the vehicle makes of it.
[[nodiscard]] Bytes imu(const twin::Agent& agent, const twin::AgentState& state,
                        const std::string& name, const Stamp& stamp);
/// sensor_msgs/msg/NavSatFix; without a fix status -1 and no numbers.
/// @param geoid_m  height of mean sea level above the ellipsoid at the origin
[[nodiscard]] Bytes nav_sat_fix(const twin::AgentState& state, const GeoPoint& origin,
                                double geoid_m, const std::string& name, const Stamp& stamp);
/// sensor_msgs/msg/FluidPressure: absolute, of sea water of `density_kg_m3` above the sensor.
[[nodiscard]] Bytes fluid_pressure(const twin::AgentState& state, double density_kg_m3,
                                   const std::string& name, const Stamp& stamp);
/// geometry_msgs/msg/TwistWithCovarianceStamped; no numbers where the bed was not heard.
[[nodiscard]] Bytes dvl(const twin::Agent& agent, const twin::AgentState& state,
                        const std::string& name, const Stamp& stamp);
/// The same against the water: ahead alone is known where the bed is heard too.
[[nodiscard]] Bytes dvl_water(const twin::Agent& agent, const twin::AgentState& state,
                              const std::string& name, const Stamp& stamp);

/// slackwater_msgs/msg/Reserve.
struct Reserve {
  double energy_left_j = 0;
  double energy_home_j = 0;
  double margin_s = 0;  ///< until it must turn for home, at the power of now
  std::string advice;
};
[[nodiscard]] Bytes reserve(const Reserve& reserve, const std::string& name, const Stamp& stamp);

/// nav_msgs/msg/Path in `map`: the waypoints that are left of what it goes by.
[[nodiscard]] Bytes active_waypoints(const std::vector<twin::Waypoint>& waypoints,
                                     const Stamp& stamp);
/// std_msgs/msg/String.
[[nodiscard]] Bytes text(const std::string& text);

}  // namespace slackwater::dds

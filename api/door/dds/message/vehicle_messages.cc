#include "api/door/dds/message/vehicle_messages.h"

#include <cmath>
#include <limits>

#include "api/door/dds/message/cdr.h"
#include "api/door/dds/message/map_frame.h"
#include "api/door/dds/message/parts.h"
#include "fields/base/constants.h"
#include "nav_msgs.h"
#include "sensor_msgs.h"
#include "slackwater_msgs.h"
#include "twin/environment/environment.h"

namespace slackwater::dds {
namespace {

using constants::nan;
constexpr double gravity_m_s2 = 9.80665;
constexpr double standard_atmosphere_pa = 101325;

std::string base_link(const std::string& name) { return name + "/base_link"; }

/// The diagonal of a covariance of three.
std::array<double, 9> diagonal(double x, double y, double z) {
  std::array<double, 9> covariance{};
  covariance[0] = x;
  covariance[4] = y;
  covariance[8] = z;
  return covariance;
}

Bytes velocity_over(const twin::Triple<double>& velocity_m_s, double sd_m_s,
                    const std::string& name, const Stamp& stamp) {
  geometry_msgs::msg::TwistWithCovarianceStamped message;
  message.header(header_message(stamp, base_link(name)));
  twin::Spatial<double> nu;
  nu.linear = velocity_m_s;
  message.twist().twist(twist_message(nu));
  std::array<double, 36> covariance{};
  // What is not measured has no number, and no variance either; of turning it knows nothing.
  const auto variance = [&](double value) { return std::isnan(value) ? nan : sd_m_s * sd_m_s; };
  covariance[0] = variance(velocity_m_s.x);
  covariance[7] = variance(velocity_m_s.y);
  covariance[14] = variance(velocity_m_s.z);
  for (const std::size_t i : {21, 28, 35}) covariance[i] = -1;
  message.twist().covariance(covariance);
  return encoded(message);
}

/// What a DVL makes of its beams; one beam's noise, of which four share in each axis.
double dvl_sd_m_s(const twin::Agent& agent) {
  const auto& dvl = agent.vehicle->sensors.dvl;
  return dvl ? dvl->noise_sd_m_s : 0;
}

}  // namespace

Bytes odometry(const twin::Agent& agent, const twin::AgentState& state, const std::string& name,
               const Stamp& stamp) {
  const twin::Measured known = twin::known_of(agent, state);
  nav_msgs::msg::Odometry message;
  message.header(header_message(stamp, map_frame));
  message.child_frame_id(base_link(name));
  message.pose().pose(pose_message(known.position_m, known.attitude));
  message.twist().twist(twist_message(known.nu));
  return encoded(message);
}

Bytes pose(const twin::AgentState& state, const Stamp& stamp) {
  const twin::BodyState<double>& body = state.vehicle.body;
  geometry_msgs::msg::PoseStamped message;
  message.header(header_message(stamp, map_frame));
  message.pose(pose_message(body.position_m, body.attitude));
  return encoded(message);
}

std::uint8_t battery_status(const twin::AgentState& state) noexcept {
  constexpr std::uint8_t discharging = 2, neither = 3, full = 4;
  const twin::VehicleState<double>& vehicle = state.vehicle;
  if (vehicle.battery.off > 0.5) return neither;
  if (vehicle.current_a > 0) return discharging;
  return vehicle.battery.charge >= 1 ? full : neither;
}

Bytes battery_state(const twin::Agent& agent, const twin::AgentState& state,
                    const std::string& name, const Stamp& stamp) {
  constexpr std::uint8_t good = 1, dead = 3, li_ion = 2;
  constexpr auto unknown = std::numeric_limits<float>::quiet_NaN();
  sensor_msgs::msg::BatteryState message;
  message.header(header_message(stamp, base_link(name)));
  message.temperature(unknown);
  const auto& battery = agent.vehicle->battery;
  message.present(battery.has_value());
  message.location(battery ? "hull" : "");
  if (!battery) {
    message.voltage(unknown);
    message.current(unknown);
    message.charge(unknown);
    message.capacity(unknown);
    message.design_capacity(unknown);
    message.percentage(unknown);
    return encoded(message);
  }
  const twin::VehicleState<double>& vehicle = state.vehicle;
  const double capacity_ah = battery->capacity_c / 3600;
  message.voltage(static_cast<float>(vehicle.bus_voltage_v));
  message.current(static_cast<float>(-vehicle.current_a));  // negative: it gives
  message.charge(static_cast<float>(capacity_ah * vehicle.battery.charge));
  message.capacity(static_cast<float>(capacity_ah));
  message.design_capacity(static_cast<float>(capacity_ah));
  message.percentage(static_cast<float>(vehicle.battery.charge));
  message.power_supply_status(battery_status(state));
  message.power_supply_health(vehicle.battery.off > 0.5 ? dead : good);
  message.power_supply_technology(li_ion);
  return encoded(message);
}

Bytes imu(const twin::Agent& agent, const twin::AgentState& state, const std::string& name,
          const Stamp& stamp) {
  const twin::Shown& shown = state.navigation.instruments.shown;
  const twin::SensorSuite& instruments = agent.navigation->instruments;
  const twin::Imu& kind = *instruments.sensors.imu;
  sensor_msgs::msg::Imu message;
  message.header(header_message(stamp, base_link(name)));
  message.orientation(quaternion_message(state.navigation.navigator.attitude));
  message.angular_velocity(
      xyz_message<geometry_msgs::msg::Vector3>(flu_frd(shown.turn_rate_rad_s)));
  message.linear_acceleration(
      xyz_message<geometry_msgs::msg::Vector3>(flu_frd(shown.specific_force_m_s2)));
  // White noise meant over a step, beside the bias that nobody knows.
  const auto variance = [&](const twin::InertialNoise& noise) {
    return noise.white_density * noise.white_density / instruments.dt_s +
           noise.start_bias_sd * noise.start_bias_sd;
  };
  const double turn = variance(kind.gyro), force = variance(kind.accelerometer);
  message.angular_velocity_covariance(diagonal(turn, turn, turn));
  message.linear_acceleration_covariance(diagonal(force, force, force));
  return encoded(message);
}

Bytes nav_sat_fix(const twin::AgentState& state, const GeoPoint& origin, double geoid_m,
                  const std::string& name, const Stamp& stamp) {
  constexpr std::int8_t no_fix = -1, fix = 0;
  constexpr std::uint16_t gps = 1;
  constexpr std::uint8_t unknown = 0, approximated = 1;
  const twin::Triple<double>& at_m = state.navigation.instruments.shown.gnss_position_m;
  const bool has_fix = !std::isnan(at_m.x);
  sensor_msgs::msg::NavSatFix message;
  message.header(header_message(stamp, base_link(name)));
  message.status().status(has_fix ? fix : no_fix);
  message.status().service(gps);
  if (has_fix) {
    const twin::DegreesPerMetre per_m = twin::degrees_per_metre(origin);
    message.latitude(origin.latitude_deg() + at_m.x * per_m.north);
    message.longitude(normalised_longitude_deg(origin.longitude_deg() + at_m.y * per_m.east));
    message.altitude(geoid_m - at_m.z);
    const twin::Gnss kind;
    const auto square = [](double sd) { return sd * sd; };
    const double level = square(kind.white_horizontal_sd_m) + square(kind.slow_horizontal_m.sd);
    message.position_covariance(
        diagonal(level, level, square(kind.white_vertical_sd_m) + square(kind.slow_vertical_m.sd)));
  } else {
    message.latitude(nan);
    message.longitude(nan);
    message.altitude(nan);
  }
  message.position_covariance_type(has_fix ? approximated : unknown);
  return encoded(message);
}

Bytes fluid_pressure(const twin::AgentState& state, double density_kg_m3, const std::string& name,
                     const Stamp& stamp) {
  const double depth_m = state.navigation.instruments.shown.depth_m;
  sensor_msgs::msg::FluidPressure message;
  message.header(header_message(stamp, base_link(name)));
  message.fluid_pressure(standard_atmosphere_pa + density_kg_m3 * gravity_m_s2 * depth_m);
  return encoded(message);
}

Bytes dvl(const twin::Agent& agent, const twin::AgentState& state, const std::string& name,
          const Stamp& stamp) {
  const twin::Shown& shown = state.navigation.instruments.shown;
  const twin::Triple<double> nothing{nan, nan, nan};
  return velocity_over(shown.dvl_is_bottom > 0.5 ? shown.dvl_velocity_m_s : nothing,
                       dvl_sd_m_s(agent), name, stamp);
}

Bytes dvl_water(const twin::Agent& agent, const twin::AgentState& state, const std::string& name,
                const Stamp& stamp) {
  const twin::Shown& shown = state.navigation.instruments.shown;
  twin::Triple<double> through{shown.dvl_ahead_m_s, nan, nan};
  if (shown.dvl_is_bottom < 0.5) through = shown.dvl_velocity_m_s;
  return velocity_over(through, dvl_sd_m_s(agent), name, stamp);
}

Bytes reserve(const Reserve& reserve, const std::string& name, const Stamp& stamp) {
  slackwater_msgs::msg::Reserve message;
  message.header(header_message(stamp, base_link(name)));
  message.energy_left_j(reserve.energy_left_j);
  message.energy_home_j(reserve.energy_home_j);
  message.margin_s(reserve.margin_s);
  message.advice(reserve.advice);
  return encoded(message);
}

Bytes active_waypoints(const std::vector<twin::Waypoint>& waypoints, const Stamp& stamp) {
  nav_msgs::msg::Path message;
  message.header(header_message(stamp, map_frame));
  for (const twin::Waypoint& waypoint : waypoints) {
    geometry_msgs::msg::PoseStamped place;
    place.header(message.header());
    place.pose().position(xyz_message<geometry_msgs::msg::Point>(enu_ned(waypoint.position_m)));
    place.pose().orientation().w(1);
    message.poses().push_back(std::move(place));
  }
  return encoded(message);
}

Bytes text(const std::string& text) {
  std_msgs::msg::String message;
  message.data(text);
  return encoded(message);
}

}  // namespace slackwater::dds

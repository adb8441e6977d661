#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "action_msgs.h"
#include "nav_msgs.h"
#include "rmw_dds_common.h"
#include "rosgraph_msgs.h"
#include "sensor_msgs.h"
#include "slackwater_msgs.h"
#include "std_srvs.h"

namespace slackwater::tests {

/// Fills messages with values that follow from a count, each field in turn taking the next number n
/// of it; cyclone_types.c does the same for Cyclone's structures.
///
///   float: n + 0.25, negative where n is odd     int: n * 0x01020304     short: n * 257
///   bool: n odd     byte: n     string: the first n mod 9 letters     sequence: n mod 3 elements
class CountedValues {
 public:
  explicit CountedValues(unsigned first) : n_(first) {}

  void put(double& v) {
    const unsigned n = n_++;
    v = (n % 2 == 1 ? -1 : 1) * (n + 0.25);
  }
  void put(float& v) {
    double wide = 0;
    put(wide);
    v = static_cast<float>(wide);
  }
  void put(std::uint32_t& v) { v = n_++ * 0x01020304U; }
  void put(std::int32_t& v) { v = static_cast<std::int32_t>(n_++ * 0x01020304U); }
  void put(std::uint16_t& v) { v = static_cast<std::uint16_t>(n_++ * 257); }
  void put(std::int8_t& v) { v = static_cast<std::int8_t>(n_++); }
  void put(std::uint8_t& v) { v = static_cast<std::uint8_t>(n_++); }
  void put(char& v) { v = static_cast<char>(n_++); }
  void put(bool& v) { v = n_++ % 2 == 1; }
  void put(std::string& v) { v = std::string("abcdefgh").substr(0, n_++ % 9); }
  void put(eprosima::fastrtps::fixed_string<256>& v) {
    std::string text;
    put(text);
    v = text;
  }
  template <typename T, std::size_t size>
  void put(std::array<T, size>& v) {
    for (T& element : v) put(element);
  }
  template <typename T>
  void put(std::vector<T>& v) {
    v.resize(n_++ % 3);
    for (T& element : v) put(element);
  }

  void put(builtin_interfaces::msg::Time& m) { all(m.sec(), m.nanosec()); }
  void put(builtin_interfaces::msg::Duration& m) { all(m.sec(), m.nanosec()); }
  void put(std_msgs::msg::Header& m) { all(m.stamp(), m.frame_id()); }
  void put(std_msgs::msg::String& m) { all(m.data()); }
  void put(std_msgs::msg::Float64& m) { all(m.data()); }
  void put(std_msgs::msg::MultiArrayDimension& m) { all(m.label(), m.size(), m.stride()); }
  void put(std_msgs::msg::MultiArrayLayout& m) { all(m.dim(), m.data_offset()); }
  void put(std_msgs::msg::Float64MultiArray& m) { all(m.layout(), m.data()); }
  void put(geometry_msgs::msg::Vector3& m) { all(m.x(), m.y(), m.z()); }
  void put(geometry_msgs::msg::Vector3Stamped& m) { all(m.header(), m.vector()); }
  void put(geometry_msgs::msg::Point& m) { all(m.x(), m.y(), m.z()); }
  void put(geometry_msgs::msg::Quaternion& m) { all(m.x(), m.y(), m.z(), m.w()); }
  void put(geometry_msgs::msg::Pose& m) { all(m.position(), m.orientation()); }
  void put(geometry_msgs::msg::PoseStamped& m) { all(m.header(), m.pose()); }
  void put(geometry_msgs::msg::PoseWithCovariance& m) { all(m.pose(), m.covariance()); }
  void put(geometry_msgs::msg::Twist& m) { all(m.linear(), m.angular()); }
  void put(geometry_msgs::msg::TwistWithCovariance& m) { all(m.twist(), m.covariance()); }
  void put(geometry_msgs::msg::TwistWithCovarianceStamped& m) { all(m.header(), m.twist()); }
  void put(nav_msgs::msg::Odometry& m) { all(m.header(), m.child_frame_id(), m.pose(), m.twist()); }
  void put(nav_msgs::msg::Path& m) { all(m.header(), m.poses()); }
  void put(sensor_msgs::msg::BatteryState& m) { all(m.header(), m.voltage(), m.temperature(), m.current(), m.charge(), m.capacity(), m.design_capacity(), m.percentage(), m.power_supply_status(), m.power_supply_health(), m.power_supply_technology(), m.present(), m.cell_voltage(), m.cell_temperature(), m.location(), m.serial_number()); }
  void put(sensor_msgs::msg::Imu& m) { all(m.header(), m.orientation(), m.orientation_covariance(), m.angular_velocity(), m.angular_velocity_covariance(), m.linear_acceleration(), m.linear_acceleration_covariance()); }
  void put(sensor_msgs::msg::NavSatStatus& m) { all(m.status(), m.service()); }
  void put(sensor_msgs::msg::NavSatFix& m) { all(m.header(), m.status(), m.latitude(), m.longitude(), m.altitude(), m.position_covariance(), m.position_covariance_type()); }
  void put(sensor_msgs::msg::FluidPressure& m) { all(m.header(), m.fluid_pressure(), m.variance()); }
  void put(rosgraph_msgs::msg::Clock& m) { all(m.clock()); }
  void put(std_srvs::srv::Trigger_Request& m) { all(m.structure_needs_at_least_one_member()); }
  void put(std_srvs::srv::Trigger_Response& m) { all(m.success(), m.message()); }
  void put(std_srvs::srv::SetBool_Request& m) { all(m.data()); }
  void put(std_srvs::srv::SetBool_Response& m) { all(m.success(), m.message()); }
  void put(rmw_dds_common::msg::Gid& m) { all(m.data()); }
  void put(rmw_dds_common::msg::NodeEntitiesInfo& m) { all(m.node_namespace(), m.node_name(), m.reader_gid_seq(), m.writer_gid_seq()); }
  void put(rmw_dds_common::msg::ParticipantEntitiesInfo& m) { all(m.gid(), m.node_entities_info_seq()); }
  void put(unique_identifier_msgs::msg::UUID& m) { all(m.uuid()); }
  void put(action_msgs::msg::GoalInfo& m) { all(m.goal_id(), m.stamp()); }
  void put(action_msgs::msg::GoalStatus& m) { all(m.goal_info(), m.status()); }
  void put(action_msgs::msg::GoalStatusArray& m) { all(m.status_list()); }
  void put(action_msgs::srv::CancelGoal_Request& m) { all(m.goal_info()); }
  void put(action_msgs::srv::CancelGoal_Response& m) { all(m.return_code(), m.goals_canceling()); }
  void put(slackwater_msgs::msg::Reserve& m) { all(m.header(), m.energy_left_j(), m.energy_home_j(), m.margin_s(), m.advice()); }
  void put(slackwater_msgs::msg::CurrentProfile& m) { all(m.header(), m.instance(), m.latitude(), m.longitude(), m.depth_m(), m.east_m_s(), m.north_m_s(), m.east_p10(), m.east_p90(), m.north_p10(), m.north_p90()); }
  void put(slackwater_msgs::msg::SeaState& m) { all(m.header(), m.hs_m(), m.tp_s(), m.from_deg()); }
  void put(slackwater_msgs::msg::AisTarget& m) { all(m.header(), m.mmsi(), m.name(), m.latitude(), m.longitude(), m.sog_m_s(), m.cog_deg(), m.cpa_m(), m.tcpa_s()); }
  void put(slackwater_msgs::srv::Step_Request& m) { all(m.steps()); }
  void put(slackwater_msgs::srv::Step_Response& m) { all(m.success()); }
  void put(slackwater_msgs::srv::Spawn_Request& m) { all(m.model(), m.name(), m.pose()); }
  void put(slackwater_msgs::srv::Spawn_Response& m) { all(m.success(), m.message()); }
  void put(slackwater_msgs::srv::SetWaypoints_Request& m) { all(m.path(), m.loop()); }
  void put(slackwater_msgs::srv::SetWaypoints_Response& m) { all(m.success(), m.message()); }
  void put(slackwater_msgs::srv::QueryProfile_Request& m) { all(m.latitude(), m.longitude(), m.time()); }
  void put(slackwater_msgs::srv::QueryProfile_Response& m) { all(m.success(), m.message(), m.profile()); }
  void put(slackwater_msgs::action::Navigate_Goal& m) { all(m.path()); }
  void put(slackwater_msgs::action::Navigate_Result& m) { all(m.success(), m.message()); }
  void put(slackwater_msgs::action::Navigate_Feedback& m) { all(m.waypoint(), m.distance_m()); }
  void put(slackwater_msgs::action::Navigate_SendGoal_Request& m) { all(m.goal_id(), m.goal()); }
  void put(slackwater_msgs::action::Navigate_SendGoal_Response& m) { all(m.accepted(), m.stamp()); }
  void put(slackwater_msgs::action::Navigate_GetResult_Request& m) { all(m.goal_id()); }
  void put(slackwater_msgs::action::Navigate_GetResult_Response& m) { all(m.status(), m.result()); }
  void put(slackwater_msgs::action::Navigate_FeedbackMessage& m) { all(m.goal_id(), m.feedback()); }

 private:
  template <typename... Field>
  void all(Field&... fields) {
    (put(fields), ...);
  }

  unsigned n_;
};

}  // namespace slackwater::tests

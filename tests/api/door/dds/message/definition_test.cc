#include "api/door/dds/message/definition.h"

#include <gtest/gtest.h>

#include "fields/base/check.h"

// The fields as ROS's own .msg files have them (ros2/common_interfaces, ros2/rcl_interfaces),
// without comments and constants.

namespace slackwater::dds::definition_test {
namespace {

const std::string line(80, '=');
std::string held(const std::string& name) { return line + "\nMSG: " + name + "\n"; }

const std::string time_fields = "int32 sec\nuint32 nanosec\n";
const std::string header_fields = "builtin_interfaces/Time stamp\nstring frame_id\n";
const std::string xyz_fields = "float64 x\nfloat64 y\nfloat64 z\n";
const std::string header_held =
    held("std_msgs/Header") + header_fields + held("builtin_interfaces/Time") + time_fields;
const std::string pose_held = held("geometry_msgs/Pose") +
                              "geometry_msgs/Point position\n"
                              "geometry_msgs/Quaternion orientation\n" +
                              held("geometry_msgs/Point") + xyz_fields +
                              held("geometry_msgs/Quaternion") + xyz_fields + "float64 w\n";
const std::string twist_held = held("geometry_msgs/Twist") +
                               "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n" +
                               held("geometry_msgs/Vector3") + xyz_fields;

TEST(DefinitionOf, OdometryWithAllThatItHolds) {
  EXPECT_EQ(definition_of("nav_msgs/msg/Odometry"),
            "std_msgs/Header header\n"
            "string child_frame_id\n"
            "geometry_msgs/PoseWithCovariance pose\n"
            "geometry_msgs/TwistWithCovariance twist\n" +
                header_held + held("geometry_msgs/PoseWithCovariance") +
                "geometry_msgs/Pose pose\nfloat64[36] covariance\n" + pose_held +
                held("geometry_msgs/TwistWithCovariance") +
                "geometry_msgs/Twist twist\nfloat64[36] covariance\n" + twist_held);
}

TEST(DefinitionOf, BatteryStateInTheOrderOfRos) {
  EXPECT_EQ(definition_of("sensor_msgs/msg/BatteryState"),
            "std_msgs/Header header\n"
            "float32 voltage\nfloat32 temperature\nfloat32 current\nfloat32 charge\n"
            "float32 capacity\nfloat32 design_capacity\nfloat32 percentage\n"
            "uint8 power_supply_status\nuint8 power_supply_health\n"
            "uint8 power_supply_technology\nbool present\n"
            "float32[] cell_voltage\nfloat32[] cell_temperature\n"
            "string location\nstring serial_number\n" +
                header_held);
}

TEST(DefinitionOf, ImuAndFixWithTheirArrays) {
  EXPECT_EQ(definition_of("sensor_msgs/msg/Imu"),
            "std_msgs/Header header\n"
            "geometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
            "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
            "geometry_msgs/Vector3 linear_acceleration\n"
            "float64[9] linear_acceleration_covariance\n" +
                header_held + held("geometry_msgs/Quaternion") + xyz_fields + "float64 w\n" +
                held("geometry_msgs/Vector3") + xyz_fields);
  EXPECT_EQ(definition_of("sensor_msgs/msg/NavSatFix"),
            "std_msgs/Header header\nsensor_msgs/NavSatStatus status\n"
            "float64 latitude\nfloat64 longitude\nfloat64 altitude\n"
            "float64[9] position_covariance\nuint8 position_covariance_type\n" +
                header_held + held("sensor_msgs/NavSatStatus") + "int8 status\nuint16 service\n");
}

TEST(DefinitionOf, SequencesOfWhatIsHeld) {
  EXPECT_EQ(definition_of("nav_msgs/msg/Path"),
            "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n" + header_held +
                held("geometry_msgs/PoseStamped") +
                "std_msgs/Header header\ngeometry_msgs/Pose pose\n" + pose_held);
  EXPECT_EQ(
      definition_of("std_msgs/msg/Float64MultiArray"),
      "std_msgs/MultiArrayLayout layout\nfloat64[] data\n" + held("std_msgs/MultiArrayLayout") +
          "std_msgs/MultiArrayDimension[] dim\nuint32 data_offset\n" +
          held("std_msgs/MultiArrayDimension") + "string label\nuint32 size\nuint32 stride\n");
}

TEST(DefinitionOf, BoundedStringsAndBytes) {
  EXPECT_EQ(definition_of("rmw_dds_common/msg/ParticipantEntitiesInfo"),
            "rmw_dds_common/Gid gid\nrmw_dds_common/NodeEntitiesInfo[] node_entities_info_seq\n" +
                held("rmw_dds_common/Gid") + "char[16] data\n" +
                held("rmw_dds_common/NodeEntitiesInfo") +
                "string<=256 node_namespace\nstring<=256 node_name\n"
                "rmw_dds_common/Gid[] reader_gid_seq\nrmw_dds_common/Gid[] writer_gid_seq\n");
  EXPECT_EQ(definition_of("action_msgs/msg/GoalStatusArray"),
            "action_msgs/GoalStatus[] status_list\n" + held("action_msgs/GoalStatus") +
                "action_msgs/GoalInfo goal_info\nint8 status\n" + held("action_msgs/GoalInfo") +
                "unique_identifier_msgs/UUID goal_id\nbuiltin_interfaces/Time stamp\n" +
                held("unique_identifier_msgs/UUID") + "uint8[16] uuid\n" +
                held("builtin_interfaces/Time") + time_fields);
}

TEST(DefinitionOf, OurOwnAndTheEmptyOne) {
  EXPECT_EQ(definition_of("slackwater_msgs/msg/CurrentProfile"),
            "std_msgs/Header header\nstring instance\nfloat64 latitude\nfloat64 longitude\n"
            "float64[] depth_m\nfloat64[] east_m_s\nfloat64[] north_m_s\nfloat64[] east_p10\n"
            "float64[] east_p90\nfloat64[] north_p10\nfloat64[] north_p90\n" +
                header_held);
  EXPECT_EQ(definition_of("std_srvs/srv/Trigger_Request"), "");
  EXPECT_EQ(definition_of("rosgraph_msgs/msg/Clock"),
            "builtin_interfaces/Time clock\n" + held("builtin_interfaces/Time") + time_fields);
}

/// Every type of api/docs/dds.md's table, with its fields: nothing but these.
TEST(DefinitionOf, EachTypeOfTheTable) {
  const std::pair<const char*, const char*> table[] = {
      {"builtin_interfaces/msg/Duration", "int32 sec\nuint32 nanosec\n"},
      {"geometry_msgs/msg/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/msg/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/msg/TwistWithCovarianceStamped",
       "std_msgs/Header header\ngeometry_msgs/TwistWithCovariance twist\n"},
      {"geometry_msgs/msg/Vector3Stamped",
       "std_msgs/Header header\ngeometry_msgs/Vector3 vector\n"},
      {"sensor_msgs/msg/FluidPressure",
       "std_msgs/Header header\nfloat64 fluid_pressure\nfloat64 variance\n"},
      {"sensor_msgs/msg/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
      {"sensor_msgs/msg/Image",
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\n"
       "uint8 is_bigendian\nuint32 step\nuint8[] data\n"},
      {"sensor_msgs/msg/CameraInfo",
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\n"
       "float64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\n"
       "uint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"},
      {"sensor_msgs/msg/PointCloud2",
       "std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
       "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n"},
      {"marine_acoustic_msgs/msg/ProjectedSonarImage",
       "std_msgs/Header header\nmarine_acoustic_msgs/PingInfo ping_info\n"
       "geometry_msgs/Vector3[] beam_directions\nfloat32[] ranges\n"
       "marine_acoustic_msgs/SonarImageData image\n"},
      {"marine_acoustic_msgs/msg/SonarRanges",
       "std_msgs/Header header\nmarine_acoustic_msgs/PingInfo ping_info\n"
       "marine_acoustic_msgs/DetectionFlag[] flags\nfloat32[] transmit_delays\n"
       "float32[] intensities\ngeometry_msgs/Vector3[] beam_unit_vec\nfloat32[] ranges\n"},
      {"vision_msgs/msg/Detection2DArray",
       "std_msgs/Header header\nvision_msgs/Detection2D[] detections\n"},
      {"vision_msgs/msg/Detection2D",
       "std_msgs/Header header\nvision_msgs/ObjectHypothesisWithPose[] results\n"
       "vision_msgs/BoundingBox2D bbox\nstring id\n"},
      {"sensor_msgs/msg/Range",
       "std_msgs/Header header\nuint8 radiation_type\nfloat32 field_of_view\n"
       "float32 min_range\nfloat32 max_range\nfloat32 range\nfloat32 variance\n"},
      {"std_msgs/msg/String", "string data\n"},
      {"std_msgs/msg/Float64", "float64 data\n"},
      {"std_srvs/srv/SetBool_Request", "bool data\n"},
      {"std_srvs/srv/SetBool_Response", "bool success\nstring message\n"},
      {"std_srvs/srv/Trigger_Response", "bool success\nstring message\n"},
      {"slackwater_msgs/msg/Reserve",
       "std_msgs/Header header\nfloat64 energy_left_j\nfloat64 energy_home_j\n"
       "float64 margin_s\nstring advice\n"},
      {"slackwater_msgs/msg/SeaState",
       "std_msgs/Header header\nfloat64 hs_m\nfloat64 tp_s\nfloat64 from_deg\n"},
      {"slackwater_msgs/msg/AisTarget",
       "std_msgs/Header header\nuint32 mmsi\nstring name\nfloat64 latitude\nfloat64 longitude\n"
       "float64 sog_m_s\nfloat64 cog_deg\nfloat64 cpa_m\nfloat64 tcpa_s\n"},
      {"slackwater_msgs/srv/Step_Request", "uint32 steps\n"},
      {"slackwater_msgs/srv/Step_Response", "bool success\n"},
      {"slackwater_msgs/srv/Spawn_Request",
       "string model\nstring name\ngeometry_msgs/PoseStamped pose\n"},
      {"slackwater_msgs/srv/SetWaypoints_Request", "nav_msgs/Path path\nbool loop\n"},
      {"slackwater_msgs/srv/QueryProfile_Request",
       "float64 latitude\nfloat64 longitude\nbuiltin_interfaces/Time time\n"},
      {"slackwater_msgs/srv/QueryProfile_Response",
       "bool success\nstring message\nslackwater_msgs/CurrentProfile profile\n"},
      {"slackwater_msgs/action/Navigate_FeedbackMessage",
       "unique_identifier_msgs/UUID goal_id\nslackwater_msgs/Navigate_Feedback feedback\n"},
      {"slackwater_msgs/action/Navigate_SendGoal_Request",
       "unique_identifier_msgs/UUID goal_id\nslackwater_msgs/Navigate_Goal goal\n"},
      {"slackwater_msgs/action/Navigate_GetResult_Response",
       "int8 status\nslackwater_msgs/Navigate_Result result\n"},
      {"action_msgs/srv/CancelGoal_Response",
       "int8 return_code\naction_msgs/GoalInfo[] goals_canceling\n"},
  };
  for (const auto& [type, fields] : table) {
    const std::string text = definition_of(type);
    EXPECT_EQ(text.substr(0, text.find(line)), fields) << type;
  }
  EXPECT_THROW((void)definition_of("sensor_msgs/msg/LaserScan"), ContractViolation);
}

TEST(DefinitionOf, PartsOfWhatSensorsTell) {
  const std::string camera = definition_of("sensor_msgs/msg/CameraInfo");
  EXPECT_TRUE(camera.ends_with(held("sensor_msgs/RegionOfInterest") +
                               "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\n"
                               "bool do_rectify\n"));
  const std::string cloud = definition_of("sensor_msgs/msg/PointCloud2");
  EXPECT_TRUE(cloud.ends_with(held("sensor_msgs/PointField") +
                              "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"));
  const std::string ping = definition_of("marine_acoustic_msgs/msg/ProjectedSonarImage");
  EXPECT_NE(ping.find(held("marine_acoustic_msgs/PingInfo") +
                      "float32 frequency\nfloat32 sound_speed\nfloat32[] tx_beamwidths\n"
                      "float32[] rx_beamwidths\n"),
            std::string::npos);
  EXPECT_TRUE(ping.ends_with(held("marine_acoustic_msgs/SonarImageData") +
                             "bool is_bigendian\nuint32 dtype\nuint32 beam_count\n"
                             "uint8[] data\n"));
}

TEST(DefinitionOf, LogAsOnRosout) {
  EXPECT_EQ(definition_of("rcl_interfaces/msg/Log"),
            "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\n"
            "string function\nuint32 line\n" +
                held("builtin_interfaces/Time") + time_fields);
}

/// Those of ROS 2 Jazzy by rosbags 0.11, an implementation of its own.
TEST(TypeHashOf, MessagesIsThatOfRosbags) {
  EXPECT_EQ(type_hash_of("geometry_msgs/msg/Twist"),
            "RIHS01_9c45bf16fe0983d80e3cfe750d6835843d265a9a6c46bd2e609fcddde6fb8d2a");
  EXPECT_EQ(type_hash_of("geometry_msgs/msg/TwistStamped"),
            "RIHS01_5f0fcd4f81d5d06ad9b4c4c63e3ea51b82d6ae4d0558f1d475229b1121db6f64");
  EXPECT_EQ(type_hash_of("rcl_interfaces/msg/Log"),
            "RIHS01_e28ce254ca8abc06abf92773b74602cdbf116ed34fbaf294fb9f81da9f318eac");
}

TEST(TypeHashOf, WhatSensorsTellIsThatOfRosbags) {
  EXPECT_EQ(type_hash_of("sensor_msgs/msg/CompressedImage"),
            "RIHS01_15640771531571185e2efc8a100baf923961a4d15d5569652e6cb6691e8e371a");
  EXPECT_EQ(type_hash_of("sensor_msgs/msg/Image"),
            "RIHS01_d31d41a9a4c4bc8eae9be757b0beed306564f7526c88ea6a4588fb9582527d47");
  EXPECT_EQ(type_hash_of("sensor_msgs/msg/CameraInfo"),
            "RIHS01_b3dfd68ff46c9d56c80fd3bd4ed22c7a4ddce8c8348f2f59c299e73118e7e275");
  EXPECT_EQ(type_hash_of("sensor_msgs/msg/PointCloud2"),
            "RIHS01_9198cabf7da3796ae6fe19c4cb3bdd3525492988c70522628af5daa124bae2b5");
  EXPECT_EQ(type_hash_of("sensor_msgs/msg/Range"),
            "RIHS01_b42b62562e93cbfe9d42b82fe5994dfa3d63d7d5c90a317981703f7388adff3a");
  // From their .msg files, for rosbags knows neither marine_acoustic_msgs nor vision_msgs.
  EXPECT_EQ(type_hash_of("marine_acoustic_msgs/msg/SonarRanges"),
            "RIHS01_f440f02f1adc9535848643a389997562f2672f1a74214c17970e1cf2a832343c");
  EXPECT_EQ(type_hash_of("vision_msgs/msg/Detection2DArray"),
            "RIHS01_214274120007f4a683866481336b70310268cfa107aebe9d594a6acf75bda968");
  EXPECT_EQ(type_hash_of("marine_acoustic_msgs/msg/ProjectedSonarImage"),
            "RIHS01_e9d0b934ee8332c9f79e04c361de0793c165b2dee14f2c0d25c3227cd50d46f1");
}

/// Reckoned apart, in Python from the fields of Navigate.action, by a sum that gives rosidl's own
/// hashes for its Fibonacci (tests/data/bag/type_hash_test.cc).
TEST(TypeHashOf, PartsOfTheActionIsThatOfTheirFields) {
  EXPECT_EQ(type_hash_of("slackwater_msgs/action/Navigate_SendGoal"),
            "RIHS01_56a286c6e084c1d39d86ad64243a986f4150b27c0bfc03d58781bda38429ed02");
  EXPECT_EQ(type_hash_of("slackwater_msgs/action/Navigate_GetResult"),
            "RIHS01_0d34b6d38a68cf0584c56b3541f5cc22337386bf2c7c6e68d66d7d0876933696");
  EXPECT_EQ(type_hash_of("slackwater_msgs/action/Navigate_FeedbackMessage"),
            "RIHS01_6a6fc21b9169b476e4235f9f317064efdd4992ac1573ec2df302967b4a42e600");
}

}  // namespace
}  // namespace slackwater::dds::definition_test

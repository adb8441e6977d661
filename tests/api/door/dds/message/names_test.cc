#include "api/door/dds/message/names.h"

#include <gtest/gtest.h>

#include <cctype>

#include "fields/base/check.h"
#include "fields/base/numbers/random.h"

namespace slackwater::dds::names_test {
namespace {

// reference: ros2/design articles/140, "Topic and Service name mapping to DDS".
TEST(NamesOnDds, AreThoseOfRos) {
  EXPECT_EQ(dds_topic("/wamv/battery"), "rt/wamv/battery");
  EXPECT_EQ(dds_type("sensor_msgs/msg/BatteryState"), "sensor_msgs::msg::dds_::BatteryState_");
  EXPECT_EQ(request_topic("/sim/reset"), "rq/sim/resetRequest");
  EXPECT_EQ(request_type("std_srvs/srv/Trigger"), "std_srvs::srv::dds_::Trigger_Request_");
  EXPECT_EQ(reply_topic("/sim/reset"), "rr/sim/resetReply");
  EXPECT_EQ(reply_type("std_srvs/srv/Trigger"), "std_srvs::srv::dds_::Trigger_Response_");
  EXPECT_EQ(dds_topic("/clock"), "rt/clock");
  EXPECT_EQ(dds_type("rosgraph_msgs/msg/Clock"), "rosgraph_msgs::msg::dds_::Clock_");
}

TEST(NamesOnDds, OfAnActionAreThreeServicesAndTwoTopics) {
  const std::string action = "/rov/navigate/_action/";
  EXPECT_EQ(request_topic(action + "send_goal"), "rq/rov/navigate/_action/send_goalRequest");
  EXPECT_EQ(reply_topic(action + "get_result"), "rr/rov/navigate/_action/get_resultReply");
  EXPECT_EQ(dds_topic(action + "feedback"), "rt/rov/navigate/_action/feedback");
  EXPECT_EQ(request_type("slackwater_msgs/action/Navigate_SendGoal"),
            "slackwater_msgs::action::dds_::Navigate_SendGoal_Request_");
  EXPECT_EQ(dds_type("slackwater_msgs/action/Navigate_FeedbackMessage"),
            "slackwater_msgs::action::dds_::Navigate_FeedbackMessage_");
}

TEST(NamesOnDds, AreTurnedBackForPeople) {
  EXPECT_EQ(ros_topic_of(dds_topic("/rov/cmd_vel")), "/rov/cmd_vel");
  EXPECT_EQ(ros_topic_of(request_topic("/sim/reset")), "/sim/reset (requests)");
  EXPECT_EQ(ros_topic_of(reply_topic("/sim/reset")), "/sim/reset (replies)");
  EXPECT_EQ(ros_type_of(dds_type("nav_msgs/msg/Odometry")), "nav_msgs/msg/Odometry");
  EXPECT_EQ(ros_type_of(request_type("std_srvs/srv/Trigger")), "std_srvs/srv/Trigger_Request");
  for (const char* other : {"ros_discovery_info", "Square", "rt", "rqRequest", "dds_", "a::dds_::"})
    EXPECT_EQ(ros_topic_of(other), other);
  for (const char* other : {"Shape", "HelloWorld::Msg", "::dds_::_", "a::dds_::b", ""})
    EXPECT_EQ(ros_type_of(other), other);
}

TEST(NamesOnDds, OfNoRosNameThereAreNone) {
  EXPECT_THROW((void)dds_topic("rov/odometry"), ContractViolation);
  EXPECT_THROW((void)dds_topic(""), ContractViolation);
  EXPECT_THROW((void)dds_type("Odometry"), ContractViolation);
  EXPECT_THROW((void)dds_type("nav_msgs/Odometry"), ContractViolation);
}

TEST(RosToken, IsWhatTheTableSays) {
  const std::pair<const char*, const char*> table[] = {
      {"rov", "rov"},
      {"BlueROV2", "BlueROV2"},
      {"saint-brieuc", "saint_brieuc"},
      {"7 north", "n7_north"},
      {"", "n"},
      {"___", "n"},
      {"a__b", "a_b"},
      {"a - b", "a_b"},
      {"_a", "a"},
      {"a_", "a"},
      {"9", "n9"},
      {"Saint-Brieuc (Côtes)", "Saint_Brieuc_C_tes"},
      {"rov/../x", "rov_x"},
      {"\xff\xfe", "n"},
  };
  for (const auto& [name, token] : table) EXPECT_EQ(ros_token(name), token) << name;
}

bool is_ros_token(const std::string& token) {
  if (token.empty() || std::isdigit(static_cast<unsigned char>(token.front()))) return false;
  for (const char c : token)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') return false;
  return token.find("__") == std::string::npos && !token.ends_with('_');
}

TEST(RosToken, IsATokenOfRosWhateverTheName) {
  Rng random(4, "tests/dds/tokens");
  for (int i = 0; i < 20'000; ++i) {
    std::string name;
    for (std::uint64_t n = random.bits() % 12; n > 0; --n)
      name += random.uniform() < 0.3 ? '_' : static_cast<char>(random.bits());
    const std::string token = ros_token(name);
    EXPECT_TRUE(is_ros_token(token)) << name << " -> " << token;
    EXPECT_EQ(ros_token(token), token) << "a token stays what it is";
  }
}

}  // namespace
}  // namespace slackwater::dds::names_test

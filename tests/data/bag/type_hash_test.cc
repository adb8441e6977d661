#include "data/bag/type_hash.h"

#include <gtest/gtest.h>

#include "tests/data/bag/samples.h"

namespace slackwater::bag::tests::type_hash_test {
namespace {

const std::string bar = std::string(80, '=') + "\n";

/// As ROS 2 Iron has them; found alike by rosbags 0.11, an implementation of its own.
TEST(TypeHash, IsThatOfRos) {
  EXPECT_EQ(type_hash("std_msgs/msg/Float64", "float64 data"),
            "RIHS01_705ba9c3d1a09df43737eb67095534de36fd426c0587779bda2bc51fe790182a");
  EXPECT_EQ(type_hash("std_msgs/msg/String", "string data\n"),
            "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18");
  EXPECT_EQ(type_hash("std_msgs/msg/Empty", ""),
            "RIHS01_20b625256f32d5dbc0d04fee44f43c41e51c70d3502f84b4a08e7a9c26a96312");
  EXPECT_EQ(type_hash(wind_channel().type, wind_channel().definition),
            "RIHS01_d4829622288cbb443886e7ea94ea5671a3b1be6bab4ad04224432a65f7d7887a");
}

TEST(TypeHash, OfArraysSequencesAndBoundsIsThatOfRosbags) {
  EXPECT_EQ(type_hash("a_msgs/msg/All",
                      "int8[3] a\nuint16[] b\nfloat32[<=5] c\nstring<=7 d\nstring<=7[<=2] e\n"
                      "byte f\nbool g\nPart[] h\na_msgs/msg/Part[2] i\n" +
                          bar + "MSG: a_msgs/Part\nuint64 k\nint64 l\n"),
            "RIHS01_13799a08fb4be80b9eae8c71f692d73fac8f202f5eb18e15cd84da89720c6ca0");
}

/// As rosidl of ROS 2 Kilted generated them (micro-ROS in hpm_sdk, std_srvs/srv/detail).
TEST(TypeHash, OfAServiceIsThatOfRos) {
  const std::string reply = "bool success\nstring message\n";
  EXPECT_EQ(service_type_hash("std_srvs/srv/Trigger", "", reply),
            "RIHS01_eeff2cd6fa5ad9d27cdf4dec64818317839b62f212a91e6b5304b634b2062c5f");
  EXPECT_EQ(service_type_hash("std_srvs/srv/SetBool", "bool data\n", reply),
            "RIHS01_abe9e4bb6b41b40e6789712c00ec8871923e089af3f667a79992a428cff2da0a");
  // Whose client_gid is of char.
  EXPECT_EQ(type_hash("service_msgs/msg/ServiceEventInfo",
                      "uint8 event_type\nbuiltin_interfaces/Time stamp\nchar[16] client_gid\n"
                      "int64 sequence_number\n" +
                          bar + "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"),
            "RIHS01_41bcbbe07a75c9b52bc96bfd5c24d7f0fc0a08c0cb7921b3373c5732345a6f45");
  EXPECT_EQ(service_type_hash("std_msgs/msg/String", "", ""), std::nullopt);
  EXPECT_EQ(service_type_hash("a/srv/B", "wstring c", ""), std::nullopt);
  EXPECT_EQ(service_type_hash("a/srv/B", "", "c/D d"), std::nullopt);
}

/// As rosidl of ROS 2 Jazzy generated them (pfeiffmi/ROB599_activities, rob599_msgs/action/detail).
TEST(TypeHash, OfThePartsOfAnActionIsThatOfRos) {
  const std::string action = "rob599_msgs/action/Fibonacci";
  const std::string id = bar + "MSG: unique_identifier_msgs/msg/UUID\nuint8[16] uuid\n";
  const std::string time = bar + "MSG: builtin_interfaces/msg/Time\nint32 sec\nuint32 nanosec\n";
  EXPECT_EQ(type_hash(action + "_Goal", "int64 number\n"),
            "RIHS01_834005bd2bbbb0ec2dbe2754ce54e9d8c4788812c743ba04dd1eadb29694b74d");
  EXPECT_EQ(
      type_hash(action + "_FeedbackMessage", "unique_identifier_msgs/msg/UUID goal_id\n" + action +
                                                 "_Feedback feedback\n" + id + bar +
                                                 "MSG: " + action + "_Feedback\nint64 progress\n"),
      "RIHS01_a941cc541674f910f08c54c0d6a8a5a63be0ee7697a74928f342b2583dcfa88a");
  EXPECT_EQ(
      service_type_hash(action + "_SendGoal",
                        "unique_identifier_msgs/msg/UUID goal_id\n" + action + "_Goal goal\n" + id +
                            bar + "MSG: " + action + "_Goal\nint64 number\n",
                        "bool accepted\nbuiltin_interfaces/msg/Time stamp\n" + time),
      "RIHS01_3d7412ff91ff9c5abfbf9f7f5dc2171a3f32cf6da2414b2c2c82f034d176fa01");
  EXPECT_EQ(
      service_type_hash(action + "_GetResult", "unique_identifier_msgs/msg/UUID goal_id\n" + id,
                        "int8 status\n" + action + "_Result result\n" + bar + "MSG: " + action +
                            "_Result\nint64[] sequence\n"),
      "RIHS01_8ebe968757e1b88d729ad53e9aca6d14e4b2f113272786f55541cfb26acc91fc");
}

TEST(TypeHash, CommentsConstantsAndDefaultsDoNotCount) {
  EXPECT_EQ(type_hash("std_msgs/msg/String",
                      "# a text\n\nuint8 KIND=1\nstring NAME = \"#\"\n"
                      "  string data \"some # text\"  # what it says\r\n"),
            type_hash("std_msgs/msg/String", "string data"));
}

TEST(TypeHash, IsNotGivenOfWhatCannotBeFollowed) {
  EXPECT_EQ(type_hash("a/msg/B", "c/D d"), std::nullopt) << "a type that is not defined";
  EXPECT_EQ(type_hash("a/srv/B_Request", "float64 c"), std::nullopt);
  EXPECT_EQ(type_hash("a/action/B_FeedbackMessage",
                      "a/B_Feedback c\n" + bar + "MSG: a/B_Feedback\nfloat64 d\n"),
            std::nullopt)
      << "a part that is not named in full";
  EXPECT_EQ(type_hash("a/msg/B", "wstring c"), std::nullopt);
  EXPECT_EQ(type_hash("a/msg/B", "alone"), std::nullopt);
  EXPECT_EQ(type_hash("a/msg/B", "int8[x] c"), std::nullopt);
  EXPECT_EQ(type_hash("a/msg/B", "int8] c"), std::nullopt);
  EXPECT_EQ(type_hash("a/msg/B", "string<= c"), std::nullopt);
  EXPECT_EQ(type_hash("a/msg/B", bar + "no heading\n"), std::nullopt);
}

TEST(TypeHash, OfATypeThatHoldsItselfEnds) {
  EXPECT_NE(type_hash("a/msg/B", "B[] b"), std::nullopt);
}

}  // namespace
}  // namespace slackwater::bag::tests::type_hash_test

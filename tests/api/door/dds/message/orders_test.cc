#include "api/door/dds/message/orders.h"

#include <cmath>
#include <numbers>

#include "api/door/dds/message/navigate.h"
#include "api/door/dds/message/services.h"
#include "api/door/dds/message/vehicle_messages.h"
#include "fields/base/error.h"
#include "tests/api/door/dds/cdr_by_hand.h"

// What clients ask, written by hand in both orders of bytes.

namespace slackwater::dds::orders_test {
namespace {

using tests::HandReader;
using tests::HandWriter;
using tests::hex;
using tests::Order;

/// What was asked in another way is read as it was, and has the bytes that a client would send.
TEST(OrdersAsMessages, AreReadAsTheyWereAsked) {
  twin::Spatial<double> nu;
  nu.linear = {1.5, -0.25, 0.5};
  nu.angular = {0.125, -0.5, -0.75};
  EXPECT_EQ(velocity_order(nu),
            HandWriter(Order::little).doubles({1.5, 0.25, -0.5, 0.125, 0.5, 0.75}).bytes());
  EXPECT_EQ(thrusters_order({-1, 0.5, 1}),
            HandWriter(Order::little).put(0U).put(0U).put(3U).doubles({-1, 0.5, 1}).bytes());
  EXPECT_EQ(thrusters_asked(thrusters_order({-1, 0.5, 1})), (std::vector<double>{-1, 0.5, 1}));
  const auto places = path_asked(active_waypoints({{{2, 1, 3}}, {{20, 10, 30}}}, {}));
  ASSERT_EQ(places.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    const double scale = i == 0 ? 1 : 10;
    EXPECT_EQ(places[i].x, 2 * scale);
    EXPECT_EQ(places[i].y, scale);
    EXPECT_EQ(places[i].z, 3 * scale);
  }
  EXPECT_TRUE(path_asked(active_waypoints({}, {})).empty());
}

class OrdersOfClients : public testing::TestWithParam<Order> {};

TEST_P(OrdersOfClients, VelocityIsTurnedForwardRightDown) {
  const auto nu =
      velocity_asked(HandWriter(GetParam()).doubles({1.5, 0.25, -0.5, 0.125, 0.5, 0.75}).bytes());
  EXPECT_EQ(nu.linear.x, 1.5);
  EXPECT_EQ(nu.linear.y, -0.25);
  EXPECT_EQ(nu.linear.z, 0.5);
  EXPECT_EQ(nu.angular.x, 0.125);
  EXPECT_EQ(nu.angular.y, -0.5);
  EXPECT_EQ(nu.angular.z, -0.75) << "a yaw to the left";
}

TEST_P(OrdersOfClients, StampedVelocityIsTheSameWheneverItWasStampedInTheVehiclesFrame) {
  for (const char* frame : {"", "base_link", "rov/base_link"}) {
    const auto nu = stamped_velocity_asked(HandWriter(GetParam())
                                               .header(1'741'392'000, 5, frame)
                                               .doubles({1.5, 0.25, -0.5, 0, 0, 0.75})
                                               .bytes());
    EXPECT_EQ(nu.linear.x, 1.5);
    EXPECT_EQ(nu.linear.y, -0.25);
    EXPECT_EQ(nu.linear.z, 0.5);
    EXPECT_EQ(nu.angular.z, -0.75);
  }
}

TEST_P(OrdersOfClients, StampedVelocityInAFrameOfTheWorldIsRefused) {
  for (const std::string frame : {"earth", "map", "odom"}) {
    try {
      (void)stamped_velocity_asked(
          HandWriter(GetParam()).header(0, 0, frame).doubles({1, 0, 0, 0, 0, 0}).bytes());
      FAIL() << frame;
    } catch (const Error& e) {
      EXPECT_EQ(e.message(), "the velocity is in the frame " + frame +
                                 ", expected the vehicle's own (base_link); turn it into that");
    }
  }
}

TEST_P(OrdersOfClients, ThrustersWithAndWithoutALayout) {
  EXPECT_EQ(
      thrusters_asked(HandWriter(GetParam()).put(0U).put(0U).put(3U).doubles({-1, 0.5, 1}).bytes()),
      (std::vector<double>{-1, 0.5, 1}));
  EXPECT_EQ(thrusters_asked(HandWriter(GetParam())
                                .put(1U)
                                .string("thruster")
                                .put(2U)
                                .put(2U)
                                .put(0U)
                                .put(2U)
                                .doubles({0.25, -0.25})
                                .bytes()),
            (std::vector<double>{0.25, -0.25}));
  EXPECT_TRUE(thrusters_asked(HandWriter(GetParam()).put(0U).put(0U).put(0U).bytes()).empty());
}

ActuatorsAsked two_actuators() { return {{"left", "rudder"}, {0.5, -0.25}, true}; }
Bytes two_by_hand(Order order) {
  HandWriter writer(order);
  writer.put(2U).string("left").string("rudder").put(2U).doubles({0.5, -0.25});
  return writer.put(std::uint8_t{1}).bytes();
}

TEST_P(OrdersOfClients, ActuatorsByTheirNames) {
  const ActuatorsAsked asked = actuators_asked(two_by_hand(GetParam()));
  EXPECT_EQ(asked.name, two_actuators().name);
  EXPECT_EQ(asked.value, two_actuators().value);
  EXPECT_TRUE(asked.is_physical);
  const ActuatorsAsked none =
      actuators_asked(HandWriter(GetParam()).put(0U).put(0U).put(std::uint8_t{0}).bytes());
  EXPECT_TRUE(none.name.empty() && none.value.empty());
  EXPECT_FALSE(none.is_physical);
}

TEST(OrdersAsMessages, OfActuatorsHaveTheBytesOfAClient) {
  EXPECT_EQ(actuators_order(two_actuators()), two_by_hand(Order::little));
}

HandWriter& put_path(HandWriter& writer, const std::string& frame, const std::string& pose_frame) {
  writer.header(10, 20, frame).put(2U);
  for (const double scale : {1, 10})
    writer.header(10, 20, pose_frame).doubles({scale, 2 * scale, -3 * scale}).doubles({0, 0, 0, 1});
  return writer;
}
void expect_places(const std::vector<twin::Triple<double>>& places) {
  ASSERT_EQ(places.size(), 2U);
  for (const std::size_t i : {0U, 1U}) {
    const double scale = i == 0 ? 1 : 10;
    EXPECT_EQ(places[i].x, 2 * scale);  // north
    EXPECT_EQ(places[i].y, scale);      // east
    EXPECT_EQ(places[i].z, 3 * scale);  // down
  }
}

TEST_P(OrdersOfClients, PathIsTurnedToNorthEastDown) {
  HandWriter writer(GetParam()), silent(GetParam());
  expect_places(path_asked(put_path(writer, "map", "map").bytes()));
  expect_places(path_asked(put_path(silent, "", "").bytes()));
}

TEST_P(OrdersOfClients, PathInAnotherFrameIsRefused) {
  for (const auto& [path, pose] :
       {std::pair<const char*, const char*>{"odom", "map"}, {"map", "rov/base_link"}}) {
    HandWriter writer(GetParam());
    const Bytes bytes = put_path(writer, path, pose).bytes();
    try {
      (void)path_asked(bytes);
      ADD_FAILURE() << path << " " << pose;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), ErrorKind::invalid_input);
      EXPECT_NE(e.message().find("`map`"), std::string::npos) << e.message();
    }
  }
}

TEST_P(OrdersOfClients, RequestsOfServices) {
  read_trigger(HandWriter(GetParam()).put(std::uint8_t{0}).bytes());
  EXPECT_TRUE(read_set_bool(HandWriter(GetParam()).put(std::uint8_t{1}).bytes()));
  EXPECT_FALSE(read_set_bool(HandWriter(GetParam()).put(std::uint8_t{0}).bytes()));
  EXPECT_EQ(read_step(HandWriter(GetParam()).put(0x01020304U).bytes()), 0x01020304U);
  const ProfileAsked asked = read_query_profile(
      HandWriter(GetParam()).doubles({48.5, -2.5}).put(std::int32_t{7}).put(8U).bytes());
  EXPECT_EQ(asked.latitude_deg, 48.5);
  EXPECT_EQ(asked.longitude_deg, -2.5);
  EXPECT_EQ(asked.time, (Stamp{7, 8}));
  HandWriter waypoints(GetParam());
  const WaypointsAsked way =
      read_set_waypoints(put_path(waypoints, "map", "map").put(std::uint8_t{1}).bytes());
  expect_places(way.places_m);
  EXPECT_TRUE(way.loop);
}

TEST_P(OrdersOfClients, SpawnIsAPlaceAndAHeading) {
  const auto in_frame = [&](const char* frame, std::initializer_list<double> orientation) {
    return read_spawn(HandWriter(GetParam())
                          .string("bluerov2_heavy")
                          .string("second")
                          .header(10, 20, frame)
                          .doubles({1, 2, -3})
                          .doubles(orientation)
                          .bytes());
  };
  const auto asked = [&](double yaw) {
    return in_frame("map", {0, 0, std::sin(yaw / 2), std::cos(yaw / 2)});
  };
  const twin::Newcomer spawn = asked(0);  // looks east
  EXPECT_EQ(spawn.model, "bluerov2_heavy");
  EXPECT_EQ(spawn.name, "second");
  EXPECT_EQ(spawn.position_m.x, 2);
  EXPECT_EQ(spawn.position_m.y, 1);
  EXPECT_EQ(spawn.position_m.z, 3);
  EXPECT_NEAR(spawn.heading_rad, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(asked(std::numbers::pi / 2).heading_rad, 0, 1e-15);  // north
  EXPECT_NEAR(asked(1).heading_rad, std::numbers::pi / 2 - 1, 1e-15);
  // As people type it, tilted, and without a frame.
  EXPECT_NEAR(in_frame("", {0, 0, 0.707, 0.707}).heading_rad, 0, 1e-15);
  EXPECT_NEAR(in_frame("map", {std::sin(0.1), 0, 0, std::cos(0.1)}).heading_rad,
              std::numbers::pi / 2, 1e-15);
  EXPECT_THROW((void)in_frame("odom", {0, 0, 0, 1}), Error);
  EXPECT_THROW((void)in_frame("map", {0, 0, 0, 0}), Error);
  EXPECT_THROW((void)in_frame("map", {0, 0, 0, 2}), Error);
  EXPECT_THROW((void)in_frame("map", {0, 0, std::nan(""), 1}), Error);
}

GoalId id_of(std::uint8_t first) {
  GoalId id;
  for (std::size_t i = 0; i < id.size(); ++i) id[i] = static_cast<std::uint8_t>(first + i);
  return id;
}
HandWriter& put_id(HandWriter& writer, const GoalId& id) {
  for (const std::uint8_t byte : id) writer.put(byte);
  return writer;
}

TEST_P(OrdersOfClients, RequestsOfTheNavigationAction) {
  const GoalId id = id_of(1);
  HandWriter send(GetParam()), cancel(GetParam()), result(GetParam());
  const GoalAsked goal = read_send_goal(put_path(put_id(send, id), "map", "map").bytes());
  EXPECT_EQ(goal.id, id);
  expect_places(goal.places_m);
  const GoalInfo canceled =
      read_cancel_goal(put_id(cancel, id).put(std::int32_t{7}).put(8U).bytes());
  EXPECT_EQ(canceled.id, id);
  EXPECT_EQ(canceled.accepted_at, (Stamp{7, 8}));
  EXPECT_EQ(read_get_result(put_id(result, id).bytes()), id);
}

INSTANTIATE_TEST_SUITE_P(InBothOrders, OrdersOfClients, testing::Values(Order::little, Order::big),
                         [](const auto& order) {
                           return order.param == Order::little ? "Little" : "Big";
                         });

TEST(AnswersToClients, EmptyRequestsAreOneByte) {
  EXPECT_EQ(HandWriter().put(std::uint8_t{0}).bytes().size(), 5U);
  EXPECT_NO_THROW(read_trigger(hex("00 01 00 00  00")));
  EXPECT_THROW(read_trigger(hex("00 01 00 00")), Error) << "none at all is no request";
}

TEST(AnswersToClients, AreAByteAndWords) {
  EXPECT_EQ(done_reply(true, "ok"), hex("00 01 00 00  01 00 00 00  03 00 00 00  6F 6B 00"));
  EXPECT_EQ(done_reply(false, ""), hex("00 01 00 00  00 00 00 00  01 00 00 00  00"));
  EXPECT_EQ(step_reply(true), hex("00 01 00 00  01"));
}

TEST(AnswersToClients, OfTheNavigationAction) {
  EXPECT_EQ(send_goal_reply(true, {1, 500'000'000}),
            hex("00 01 00 00  01 00 00 00  01 00 00 00  00 65 CD 1D"));
  EXPECT_EQ(result_reply(GoalStatus::succeeded, true, "ok"),
            hex("00 01 00 00  04 01 00 00  03 00 00 00  6F 6B 00"));
  EXPECT_EQ(unknown_result_reply(), hex("00 01 00 00  00 00 00 00  01 00 00 00  00"));
  EXPECT_EQ(feedback(id_of(1), 2, 1.25),
            hex("00 01 00 00  01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 10"
                "02 00 00 00 00 00 00 00  00 00 00 00 00 00 F4 3F"));
}

TEST(AnswersToClients, ListsOfGoals) {
  const GoalInfo goals[] = {{id_of(1), {7, 8}}, {id_of(101), {9, 10}}};
  const auto expect_goal = [](HandReader& read, const GoalInfo& goal) {
    for (const std::uint8_t byte : goal.id) EXPECT_EQ(read.octet(), byte);
    EXPECT_EQ(read.get<std::int32_t>(), goal.accepted_at.seconds);
    EXPECT_EQ(read.count(), goal.accepted_at.nanoseconds);
  };
  HandReader reply(cancel_goal_reply(CancelAnswer::none, goals));
  EXPECT_EQ(reply.get<std::int8_t>(), 0);
  EXPECT_EQ(reply.count(), 2U);
  for (const GoalInfo& goal : goals) expect_goal(reply, goal);
  reply.expect_end();

  const GoalState states[] = {{goals[0], GoalStatus::executing}, {goals[1], GoalStatus::aborted}};
  HandReader status(goal_status(states));
  EXPECT_EQ(status.count(), 2U);
  for (const GoalState& state : states) {
    expect_goal(status, state.goal);
    EXPECT_EQ(status.get<std::int8_t>(), static_cast<std::int8_t>(state.status));
  }
  status.expect_end();
}

}  // namespace
}  // namespace slackwater::dds::orders_test

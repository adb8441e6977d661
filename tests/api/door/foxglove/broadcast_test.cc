#include "api/door/foxglove/broadcast.h"

#include <gtest/gtest.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "fields/base/check.h"
#include "tests/api/door/http/served.h"
#include "tests/support/websocket_client.h"

// What a viewer sees, over the real server; the bytes as docs/spec.md of foxglove/ws-protocol has
// them. Strangers.WatchOverFoxglove does the same with their own client.

namespace slackwater::tests::broadcast_test {
namespace {

using namespace std::chrono_literals;
using api::foxglove::Broadcast;
using api::foxglove::ChannelId;
using nlohmann::json;

bag::Channel channel(const std::string& topic, bool is_reliable = true, bool is_latched = false) {
  return {topic, "std_msgs/msg/Float64", "float64 data\n", {is_reliable, is_latched, 10}};
}

std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

/// A broadcast at /live.
struct LiveServed {
  explicit LiveServed(api::http::ServerOptions options = {}) {
    api::http::Router router = example_router();
    router.add("GET", "/live", live->route());
    served.emplace(router, std::move(options));
  }
  [[nodiscard]] WebSocketClient client(const std::string& protocol = "foxglove.websocket.v1",
                                       int receive_buffer_bytes = 0) {
    return {served->server().port(), "/live", protocol, {}, receive_buffer_bytes};
  }
  template <typename Condition>
  bool comes_true(const Condition& condition) {
    for (int i = 0; i < 2000 && !condition(live->figures()); ++i) std::this_thread::sleep_for(5ms);
    return condition(live->figures());
  }

  std::optional<Broadcast> live = std::make_optional<Broadcast>("harbour");
  std::optional<Served> served;
};

json next_text(WebSocketClient& client) {
  const auto frame = client.receive();
  if (!frame || frame->opcode != 1) return "no text";
  return json::parse(frame->payload);
}

std::string next_bytes(WebSocketClient& client, std::chrono::milliseconds within = 20s) {
  const auto frame = client.receive(within);
  return frame && frame->opcode == 2 ? frame->payload : "no bytes";
}

/// The channels that a newcomer is told of, what stands before them having been read.
json channels_of(WebSocketClient& client) {
  EXPECT_EQ(next_text(client).at("op"), "serverInfo");
  const json advertise = next_text(client);
  EXPECT_EQ(advertise.at("op"), "advertise");
  return advertise.at("channels");
}

void subscribe(WebSocketClient& client, std::uint32_t id, ChannelId channel) {
  client.send_text(
      json{{"op", "subscribe"},
           {"subscriptions", {{{"id", id}, {"channelId", static_cast<std::uint32_t>(channel)}}}}}
          .dump());
}

TEST(FoxgloveBroadcast, TellsNewcomersWhatThereIsUnderBothNames) {
  LiveServed served;
  const ChannelId first = served.live->advertise(channel("/a"));
  const ChannelId second = served.live->advertise(channel("/b"));
  EXPECT_NE(first, second);
  std::string session;
  for (const std::string name : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    WebSocketClient client = served.client(name);
    ASSERT_EQ(client.handshake().field("sec-websocket-protocol"), name);
    const json info = next_text(client);
    EXPECT_EQ(info.at("op"), "serverInfo");
    EXPECT_EQ(info.at("name"), "harbour");
    EXPECT_EQ(info.at("capabilities"), json::array({"time"}));
    EXPECT_EQ(info.at("supportedEncodings"), json::array());
    if (session.empty()) session = info.at("sessionId");
    EXPECT_EQ(info.at("sessionId"), session) << "the same broadcast";
    const json advertise = next_text(client);
    ASSERT_EQ(advertise.at("channels").size(), 2U);
    const json& shown = advertise.at("channels").at(1);
    EXPECT_EQ(shown, (json{{"id", static_cast<std::uint32_t>(second)},
                           {"topic", "/b"},
                           {"encoding", "cdr"},
                           {"schemaName", "std_msgs/msg/Float64"},
                           {"schema", "float64 data\n"},
                           {"schemaEncoding", "ros2msg"}}));
  }
  EXPECT_EQ(served.client("foxglove.websocket.v2").handshake().status, 400);
  EXPECT_EQ(served.served->get("/live")->status, 426);
}

TEST(FoxgloveBroadcast, AnEmptyOneAdvertisesNothingAndThenWhatComes) {
  LiveServed served;
  WebSocketClient client = served.client();
  EXPECT_EQ(channels_of(client), json::array()) << "at least one advertise message, always";
  const ChannelId id = served.live->advertise(channel("/late"));
  EXPECT_EQ(next_text(client).at("channels").at(0).at("topic"), "/late");
  served.live->unadvertise(id);
  const json gone = next_text(client);
  EXPECT_EQ(gone.at("op"), "unadvertise");
  EXPECT_EQ(gone.at("channelIds"), json::array({static_cast<std::uint32_t>(id)}));
}

TEST(FoxgloveBroadcast, SendsTheMessagesOfSubscribedChannelsAsTheProtocolHasThem) {
  LiveServed served;
  const ChannelId wanted = served.live->advertise(channel("/wanted"));
  const ChannelId other = served.live->advertise(channel("/other"));
  WebSocketClient client = served.client();
  channels_of(client);
  subscribe(client, 0x01020304, wanted);
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.subscriptions == 1; }));
  EXPECT_TRUE(served.live->is_watched(wanted));
  EXPECT_FALSE(served.live->is_watched(other));
  served.live->publish(other, 1, bytes_of("not for you"));
  served.live->publish(wanted, 0x1112131415161718, bytes_of("payload"));
  EXPECT_EQ(next_bytes(client),
            std::string("\x01\x04\x03\x02\x01\x18\x17\x16\x15\x14\x13\x12\x11") + "payload");
  client.send_text(R"({"op":"unsubscribe","subscriptionIds":[16909060]})");
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.subscriptions == 0; }));
  served.live->publish(wanted, 2, bytes_of("not any more"));
  served.live->set_time(0x2122232425262728);
  EXPECT_EQ(next_bytes(client), std::string("\x02\x28\x27\x26\x25\x24\x23\x22\x21"));
  EXPECT_EQ(served.live->figures().sent, 1U);
}

TEST(FoxgloveBroadcast, LateComersGetTheTimeAndWhatWasLastSaidOnLatchedChannels) {
  LiveServed served;
  const ChannelId latched = served.live->advertise(channel("/forecast", true, true));
  const ChannelId plain = served.live->advertise(channel("/odometry"));
  served.live->publish(latched, 1, bytes_of("old"));
  served.live->publish(latched, 2, bytes_of("new"));
  served.live->publish(plain, 3, bytes_of("gone"));
  served.live->set_time(7);
  WebSocketClient client = served.client();
  channels_of(client);
  EXPECT_EQ(next_bytes(client), std::string("\x02\x07\0\0\0\0\0\0\0", 9));
  subscribe(client, 5, plain);
  subscribe(client, 6, latched);
  EXPECT_EQ(next_bytes(client), std::string("\x01\x06\0\0\0\x02\0\0\0\0\0\0\0", 13) + "new");
}

TEST(FoxgloveBroadcast, WhatItDoesNotDoIsAnsweredAndEndsNothing) {
  LiveServed served;
  const ChannelId id = served.live->advertise(channel("/a"));
  WebSocketClient client = served.client();
  channels_of(client);
  subscribe(client, 1, id);
  const auto expect_status = [&](const std::string& text, int level, const std::string& part) {
    ASSERT_TRUE(client.send_text(text));
    const json status = next_text(client);
    EXPECT_EQ(status.at("op"), "status") << text;
    EXPECT_EQ(status.at("level"), level) << text;
    EXPECT_NE(status.at("message").get<std::string>().find(part), std::string::npos) << status;
  };
  expect_status("{", 2, "no JSON");
  expect_status(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":0}]})", 2, "in use");
  expect_status(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":0}]})", 2,
                "subscribed to already");
  expect_status(R"({"op":"subscribe","subscriptions":[{"id":2,"channelId":99}]})", 2,
                "no channel 99");
  expect_status(R"({"op":"subscribe","subscriptions":[{"id":4294967296,"channelId":0}]})", 2,
                "4294967296");
  expect_status(R"({"op":"unsubscribe","subscriptionIds":[9]})", 1, "no subscription 9");
  expect_status(R"({"op":"advertise","channels":[{"id":1,"topic":"/cmd"}]})", 1, "read-only");
  expect_status(R"({"op":"setParameters","parameters":[]})", 1, "read-only");
  ASSERT_TRUE(client.send_bytes(std::string("\x01\0\0\0\0command", 12)));
  EXPECT_EQ(next_text(client).at("level"), 1);
  ASSERT_TRUE(client.send_bytes(""));
  EXPECT_EQ(next_text(client).at("level"), 2);
  served.live->publish(id, 0, bytes_of("still here"));
  EXPECT_EQ(next_bytes(client).substr(13), "still here");
}

TEST(FoxgloveBroadcast, AWithdrawnChannelTakesItsSubscriptionsWithIt) {
  LiveServed served;
  const ChannelId id = served.live->advertise(channel("/a"));
  WebSocketClient client = served.client();
  channels_of(client);
  subscribe(client, 1, id);
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.subscriptions == 1; }));
  served.live->unadvertise(id);
  served.live->unadvertise(id);
  served.live->publish(id, 0, bytes_of("to nobody"));
  EXPECT_EQ(served.live->figures().subscriptions, 0U);
  EXPECT_EQ(next_text(client).at("op"), "unadvertise");
  // Viewers unsubscribe from it nevertheless: no complaint, and the id is free again.
  client.send_text(R"({"op":"unsubscribe","subscriptionIds":[1]})");
  const ChannelId next = served.live->advertise(channel("/a"));
  EXPECT_NE(next, id) << "ids are not used again";
  EXPECT_EQ(next_text(client).at("op"), "advertise");
  subscribe(client, 1, next);
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.subscriptions == 1; }));
  EXPECT_THROW(served.live->publish(ChannelId{99}, 0, {}), ContractViolation);
  EXPECT_THROW(served.live->unadvertise(ChannelId{99}), ContractViolation);
}

TEST(FoxgloveBroadcast, OneThatStopsReadingStopsNeitherThePublisherNorTheOthers) {
  api::http::ServerOptions options;
  options.limits.websocket_queue_bytes = 1 << 20;
  LiveServed served(options);
  const ChannelId sonar = served.live->advertise(channel("/sonar", false));
  const ChannelId odometry = served.live->advertise(channel("/odometry", true));
  WebSocketClient deaf = served.client("foxglove.websocket.v1", 4096);
  subscribe(deaf, 1, sonar);
  WebSocketClient reader = served.client("foxglove.sdk.v1");
  channels_of(reader);
  subscribe(reader, 2, odometry);
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.subscriptions == 2; }));
  const std::vector<std::uint8_t> picture(100'000);
  const auto from = std::chrono::steady_clock::now();
  for (int i = 0; i < 500; ++i) {  // 50 MB
    served.live->publish(sonar, 0, picture);
    served.live->publish(odometry, 0, bytes_of(std::to_string(i)));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - from, 5s);
  for (int i = 0; i < 500; ++i) EXPECT_EQ(next_bytes(reader).substr(13), std::to_string(i));
  const auto figures = served.live->figures();
  EXPECT_EQ(figures.sent, 1000U);
  EXPECT_GT(figures.dropped, 400U);
}

TEST(FoxgloveBroadcast, TwoHundredThatComeAndGoLeaveNothingBehind) {
  LiveServed served;
  const ChannelId id = served.live->advertise(channel("/a", true, true));
  served.live->publish(id, 0, bytes_of("latched"));
  for (int i = 0; i < 200; ++i) {
    WebSocketClient client = served.client();
    ASSERT_EQ(client.handshake().status, 101) << i;
    subscribe(client, 1, id);
    if (i % 3 == 0) {
      channels_of(client);
      EXPECT_EQ(next_bytes(client).substr(13), "latched");
      client.send(0x88, "");
    }
    if (i % 3 == 1) client.connection().reset();
    served.live->publish(id, 0, bytes_of("latched"));
  }
  EXPECT_TRUE(served.comes_true([](const auto& f) { return f.clients == 0; }));
  EXPECT_EQ(served.live->figures().subscriptions, 0U);
}

TEST(FoxgloveBroadcast, ManyThreadsPublishWhileViewersComeAndGo) {
  LiveServed served;
  std::atomic<bool> is_over{false};
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&, t] {
      const ChannelId own =
          served.live->advertise(channel("/" + std::to_string(t), t != 0, t == 1));
      for (std::uint64_t i = 0; !is_over; ++i) {
        served.live->publish(own, i, bytes_of("x"));
        served.live->set_time(i);
        if (i % 100 == 0) {
          served.live->unadvertise(served.live->advertise(channel("/short-lived")));
        }
        std::this_thread::sleep_for(100us);
      }
    });
  }
  for (int i = 0; i < 40; ++i) {
    WebSocketClient client = served.client();
    for (std::uint32_t id = 0; id < 3; ++id) subscribe(client, id, ChannelId{id});
    for (int k = 0; k < 20; ++k) EXPECT_TRUE(client.receive());
  }
  is_over = true;
  for (std::thread& thread : threads) thread.join();
  EXPECT_TRUE(served.comes_true([](const auto& f) { return f.clients == 0; }));
}

TEST(FoxgloveBroadcast, ItsEndAndTheServersAreToldInEitherOrder) {
  LiveServed served;
  WebSocketClient client = served.client();
  ASSERT_TRUE(served.comes_true([](const auto& f) { return f.clients == 1; }));
  served.live.reset();
  EXPECT_EQ(client.receive_close(), 1001);
  WebSocketClient late = served.client();
  EXPECT_EQ(late.receive_close(), 1001) << "the door outlives it and says so";

  LiveServed other;
  WebSocketClient watching = other.client();
  ASSERT_TRUE(other.comes_true([](const auto& f) { return f.clients == 1; }));
  const ChannelId id = other.live->advertise(channel("/a", true, true));
  std::thread stopper([&] { other.served.reset(); });
  EXPECT_EQ(watching.receive_close(), 1001);
  watching.send(0x88, "\x03\xe9");
  stopper.join();
  EXPECT_EQ(other.live->figures().clients, 0U);
  other.live->publish(id, 0, bytes_of("to nobody"));
}

}  // namespace
}  // namespace slackwater::tests::broadcast_test

#include "api/door/foxglove/client_request.h"

#include <gtest/gtest.h>

#include <random>

namespace slackwater::tests::client_request_test {
namespace {

using api::foxglove::binary_refusal;
using api::foxglove::client_request;
using api::foxglove::ClientRequest;
using api::foxglove::Level;
using api::foxglove::Subscription;

/// The one status that a text is answered with.
std::string status_of(const std::string& text, Level level) {
  const ClientRequest request = client_request(text);
  EXPECT_TRUE(request.subscribe.empty() && request.unsubscribe.empty()) << text;
  if (request.statuses.size() != 1) return std::to_string(request.statuses.size()) + " statuses";
  EXPECT_EQ(request.statuses[0].level, level) << text;
  return request.statuses[0].message;
}

TEST(FoxgloveClientRequest, SubscribesAndUnsubscribes) {
  const ClientRequest request =
      client_request(R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},)"
                     R"({"id":4294967295,"channelId":5}]})");
  EXPECT_EQ(request.subscribe, (std::vector<Subscription>{{0, 3}, {4294967295, 5}}));
  EXPECT_TRUE(request.statuses.empty());
  EXPECT_EQ(client_request(R"({"op":"unsubscribe","subscriptionIds":[0,1]})").unsubscribe,
            (std::vector<std::uint32_t>{0, 1}));
}

TEST(FoxgloveClientRequest, AWrongEntryDoesNotSpoilItsNeighbours) {
  const ClientRequest request = client_request(
      R"({"op":"subscribe","subscriptions":[{"id":-1,"channelId":3},{"id":1,"channelId":3},7]})");
  EXPECT_EQ(request.subscribe, (std::vector<Subscription>{{1, 3}}));
  ASSERT_EQ(request.statuses.size(), 2U);
  EXPECT_NE(request.statuses[0].message.find("id -1, channelId 3"), std::string::npos)
      << request.statuses[0].message;
}

TEST(FoxgloveClientRequest, IdsThatNoMessageHasRoomForAreNamed) {
  for (const std::string id :
       {"4294967296", "18446744073709551616", "1e400", "-1", "1.5", "1.0", "\"1\"", "null", "true",
        "[1]", "{}", "99999999999999999999999999999999"}) {
    const std::string text = R"({"op":"unsubscribe","subscriptionIds":[)" + id + "]}";
    const ClientRequest request = client_request(text);
    EXPECT_TRUE(request.unsubscribe.empty()) << id;
    EXPECT_EQ(request.statuses.size(), 1U) << id;
  }
}

TEST(FoxgloveClientRequest, WhatIsNoRequestIsToldWhatOneIs) {
  for (const std::string text :
       {"", "wind", "{", "[]", "3", "null", "\"subscribe\"", "{}", R"({"op":3})", R"({"op":null})",
        R"({"op":"subscribe")", "\xff\xfe"}) {
    EXPECT_NE(status_of(text, Level::error).find("'op'"), std::string::npos) << text;
  }
  EXPECT_NE(status_of(R"({"op":"dance"})", Level::error).find("\"dance\""), std::string::npos);
  EXPECT_NE(status_of(R"({"op":"subscribe"})", Level::error).find("subscriptions"),
            std::string::npos);
  EXPECT_NE(status_of(R"({"op":"subscribe","subscriptions":{}})", Level::error).find("an object"),
            std::string::npos);
}

TEST(FoxgloveClientRequest, WhatWouldWriteIsToldThatTheDoorOnlyShows) {
  for (const std::string op :
       {"advertise", "unadvertise", "getParameters", "setParameters", "subscribeParameterUpdates",
        "unsubscribeParameterUpdates", "subscribeConnectionGraph", "unsubscribeConnectionGraph",
        "fetchAsset"}) {
    const std::string text = R"({"op":")" + op + R"(","channels":[{"id":1}]})";
    EXPECT_NE(status_of(text, Level::warning).find("read-only"), std::string::npos) << op;
  }
  EXPECT_EQ(binary_refusal(false, 1).level, Level::warning);
  EXPECT_EQ(binary_refusal(false, 2).level, Level::warning);
  EXPECT_EQ(binary_refusal(false, 77).level, Level::error);
  EXPECT_EQ(binary_refusal(true, 0).level, Level::error);
}

TEST(FoxgloveClientRequest, AFloodOfWrongEntriesIsAnsweredBriefly) {
  std::string text = R"({"op":"unsubscribe","subscriptionIds":[-1)";
  for (int i = 0; i < 9999; ++i) text += ",-1";
  const ClientRequest request = client_request(text + "]}");
  ASSERT_EQ(request.statuses.size(), 5U);
  EXPECT_NE(request.statuses.back().message.find("9995 more"), std::string::npos);
}

TEST(FoxgloveClientRequest, NestingBeyondMeasureEndsNothing) {
  const std::string deep = std::string(30'000, '[') + std::string(30'000, ']');
  EXPECT_FALSE(client_request(deep).statuses.empty());
  EXPECT_FALSE(client_request(R"({"op":)" + deep + "}").statuses.empty());
  EXPECT_FALSE(
      client_request(R"({"op":"unsubscribe","subscriptionIds":[)" + deep + "]}").statuses.empty());
  EXPECT_FALSE(client_request(std::string(65'000, '[')).statuses.empty());
}

TEST(FoxgloveClientRequest, NoMutatedTextEndsIt) {
  const std::string valid =
      R"({"op":"subscribe","subscriptions":[{"id":0,"channelId":3},{"id":1,"channelId":5}]})";
  std::mt19937 random(20261105);
  std::size_t told = 0;
  for (int i = 0; i < 20'000; ++i) {
    std::string text = valid;
    for (std::size_t k = 0; k <= random() % 3; ++k) {
      text[random() % text.size()] = static_cast<char>(random() % 256);
    }
    const ClientRequest request = client_request(text);
    EXPECT_LE(request.subscribe.size(), 2U);
    told += request.statuses.empty() ? 0 : 1;
  }
  EXPECT_GT(told, 10'000U);
}

}  // namespace
}  // namespace slackwater::tests::client_request_test

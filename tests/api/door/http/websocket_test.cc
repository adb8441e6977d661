// What is said over WebSockets, and how they end.
#include "tests/api/door/http/echo_served.h"

namespace slackwater::tests::websocket_test {
namespace {

// --- messages ---

TEST(WebSocketServer, CarriesTextAndBytesOfAnyLength) {
  EchoServed served;
  WebSocketClient client = served.client();
  for (const std::size_t length : {0U, 1U, 125U, 126U, 65535U, 65536U}) {
    const std::string payload(length, 'x');
    EXPECT_EQ(said_back(client, payload), payload) << length;
    ASSERT_TRUE(client.send_bytes(payload));
    const auto frame = client.receive();
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->opcode, 2);
    EXPECT_EQ(frame->payload, "got " + payload) << length;
  }
  ASSERT_TRUE(client.send(0x01, "in "));
  ASSERT_TRUE(client.send(0x89, "ping"));
  ASSERT_TRUE(client.send(0x80, "pieces"));
  const auto pong = client.receive();
  ASSERT_TRUE(pong);
  EXPECT_EQ(pong->opcode, 10);
  EXPECT_EQ(pong->payload, "ping");
  EXPECT_EQ(next_payload(client), "in pieces");
}

TEST(WebSocketServer, WhatHasBeenSentIsLetGoOf) {
  EchoServed served;
  WebSocketClient client = served.client();
  ASSERT_EQ(said_back(client, "here"), "here");
  const auto body = std::make_shared<const std::vector<std::uint8_t>>(100'000);
  served.echo->sockets[0]->send({false, {}, body, Worth::reliable});
  EXPECT_EQ(next_payload(client).size(), body->size());
  EXPECT_TRUE(comes_true([&] { return body.use_count() == 1; }, 2s));
}

TEST(WebSocketServer, ManyThreadsMaySpeakToManyClients) {
  EchoServed served;
  std::vector<WebSocketClient> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(served.client());
    ASSERT_EQ(said_back(clients.back(), "here"), "here");
  }
  constexpr int messages = 500;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < messages; ++i) {
        for (const auto& socket : served.echo->sockets) {
          socket->send(
              {false, std::to_string(t) + " " + std::to_string(i), nullptr, Worth::best_effort});
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (WebSocketClient& client : clients) {
    std::array<int, 4> next{};
    for (int i = 0; i < 4 * messages; ++i) {
      const auto frame = client.receive();
      ASSERT_TRUE(frame);
      auto& expected = next.at(static_cast<std::size_t>(frame->payload.at(0) - '0'));
      EXPECT_EQ(frame->payload.substr(2), std::to_string(expected++));
    }
  }
  EXPECT_TRUE(comes_true([&] {
    return served.metrics_have("slackwater_http_websocket_frames_total " +
                               std::to_string(4 * (4 * messages + 1)));
  })) << served.metrics->exposition();
}

// --- farewells ---

TEST(WebSocketServer, AnswersAFarewellAndCloses) {
  EchoServed served;
  for (const std::string& payload : {std::string(), std::string("\x03\xe8", 2) + "done"}) {
    WebSocketClient client = served.client();
    ASSERT_TRUE(client.send(0x88, payload));
    const auto answer = client.receive();
    ASSERT_TRUE(answer);
    EXPECT_EQ(answer->opcode, 8);
    EXPECT_EQ(answer->code(), payload.empty() ? 1005 : 1000);
    EXPECT_TRUE(client.connection().is_closed_within(5s));
  }
  EXPECT_TRUE(comes_true([&] { return served.echo->closed_count == 2; }));
}

TEST(WebSocketServer, AHandlerMaySayFarewellAfterWhatItSaid) {
  EchoServed served;
  WebSocketClient client = served.client();
  ASSERT_TRUE(client.send_text("a word"));
  ASSERT_TRUE(client.send_text("close"));
  ASSERT_TRUE(client.send_text("too late"));
  EXPECT_EQ(next_payload(client), "a word");
  const auto farewell = client.receive();
  ASSERT_TRUE(farewell);
  EXPECT_EQ(farewell->code(), 4001);
  EXPECT_EQ(farewell->payload.substr(2), "as you asked");
  ASSERT_TRUE(client.send(0x88, farewell->payload));
  EXPECT_TRUE(client.connection().is_closed_within(5s));
}

TEST(WebSocketServer, WhoNeverAnswersTheFarewellIsClosedAllTheSame) {
  EchoServed served;
  WebSocketClient client = served.client();
  ASSERT_TRUE(client.send_text("close"));
  EXPECT_EQ(client.receive_close(), 4001);
  EXPECT_TRUE(client.connection().is_closed_within(5s));
  EXPECT_TRUE(comes_true([&] { return served.echo->closed_count == 1; }));
}

TEST(WebSocketServer, WrongFramesEndWithTheirCodeAndNobodyElseNotices) {
  EchoServed served;
  WebSocketClient other = served.client();
  const std::vector<std::pair<std::string, int>> wrong{
      {client_frame(0x81, "not masked", false), 1002},
      {client_frame(0xc1, "reserved bit"), 1002},
      {client_frame(0x83, "no such opcode"), 1002},
      {client_frame(0x89, std::string(126, 'p')), 1002},
      {client_frame(0x82, std::string(65537, 'x')), 1009},
      {client_frame(0x81, "\xff"), 1007},
      {"GET /short HTTP/1.1\r\nHost: localhost\r\n\r\n", 1002},
  };
  for (const auto& [bytes, code] : wrong) {
    WebSocketClient client = served.client();
    ASSERT_EQ(said_back(client, "before"), "before");
    client.connection().send(bytes + client_frame(0x81, "after"));
    const auto farewell = client.receive();
    ASSERT_TRUE(farewell);
    EXPECT_EQ(farewell->opcode, 8) << "nothing after it is heard";
    EXPECT_EQ(farewell->code(), code);
    EXPECT_GT(farewell->payload.size(), 10U) << "and a reason";
    EXPECT_TRUE(client.connection().is_closed_within(5s));
  }
  EXPECT_EQ(said_back(other, "still here"), "still here");
}

TEST(WebSocketServer, AHandlerThatFailsEndsItsClientAlone) {
  ServerOptions options;
  std::mutex mutex;
  std::string logged;
  options.on_failure = [&](const Request& request, const std::string& what) {
    const std::lock_guard lock(mutex);
    logged = request.path + ": " + what;
  };
  EchoServed served(options);
  WebSocketClient other = served.client();
  WebSocketClient client = served.client();
  ASSERT_TRUE(client.send_text("throw"));
  const auto farewell = client.receive();
  ASSERT_TRUE(farewell);
  EXPECT_EQ(farewell->code(), 1011);
  EXPECT_EQ(farewell->payload.find("as it was told"), std::string::npos) << "the log's, not theirs";
  EXPECT_EQ(said_back(other, "still here"), "still here");
  const std::lock_guard lock(mutex);
  EXPECT_EQ(logged, "/ws: as it was told");
}

}  // namespace
}  // namespace slackwater::tests::websocket_test

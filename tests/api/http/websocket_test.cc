#include "api/http/websocket.h"

#include <dirent.h>
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "tests/api/http/served.h"
#include "tests/support/websocket_client.h"

// WebSockets of the real server, spoken to over real sockets by a client made by hand.

namespace slackwater::tests {
namespace {

using namespace std::chrono_literals;
using api::http::Frame;
using api::http::Metrics;
using api::http::Request;
using api::http::ServerOptions;
using api::http::WebSocket;
using api::http::Worth;

/// Says back what it hears; some words it obeys.
class Echo final : public api::http::WebSocketHandler {
 public:
  [[nodiscard]] std::vector<std::string> protocols() const override { return known; }
  void opened(const std::shared_ptr<WebSocket>& socket, const Request& request,
              const std::string& protocol) override {
    const std::lock_guard lock(mutex);
    ++opened_count;
    sockets.push_back(socket);
    last_protocol = protocol;
    last_is_trusted = request.is_trusted;
  }
  void received_text(WebSocket& socket, std::string_view text) override {
    if (text == "throw") throw std::runtime_error("as it was told");
    if (text == "close") return socket.close(4001, "as you asked");
    socket.send({true, std::string(text), nullptr, Worth::reliable});
  }
  void received_bytes(WebSocket& socket, std::span<const std::uint8_t> bytes) override {
    const auto body = std::make_shared<const std::vector<std::uint8_t>>(bytes.begin(), bytes.end());
    socket.send({false, "got ", body, Worth::reliable});
  }
  void closed(WebSocket&) override { ++closed_count; }

  std::vector<std::string> known{"echo.v1", "echo.v2"};
  std::atomic<int> opened_count{0};
  std::atomic<int> closed_count{0};
  std::mutex mutex;
  std::vector<std::shared_ptr<WebSocket>> sockets;
  std::string last_protocol;
  bool last_is_trusted = false;
};

/// A server with the echo at /echo beside the usual routes.
struct EchoServed {
  explicit EchoServed(ServerOptions options = {})
      : metrics(std::make_shared<Metrics>(std::vector<std::string>{"/ws"})) {
    api::http::Router router = example_router();
    router.add("GET", "/ws", api::http::websocket_route(echo));
    options.metrics = metrics;
    served.emplace(router, std::move(options));
  }
  [[nodiscard]] WebSocketClient client(const std::string& protocols = "echo.v1",
                                       const std::string& field_lines = {},
                                       int receive_buffer_bytes = 0) {
    return {served->server().port(), "/ws", protocols, field_lines, receive_buffer_bytes};
  }
  [[nodiscard]] bool metrics_have(const std::string& line) const {
    return metrics->exposition().find(line + "\n") != std::string::npos;
  }

  std::shared_ptr<Echo> echo = std::make_shared<Echo>();
  std::shared_ptr<Metrics> metrics;
  std::optional<Served> served;
};

template <typename Condition>
bool comes_true(const Condition& condition, std::chrono::milliseconds within = 10s) {
  const auto until = std::chrono::steady_clock::now() + within;
  while (!condition()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(5ms);
  }
  return true;
}

std::string next_payload(WebSocketClient& client) {
  const auto frame = client.receive(5s);
  return frame ? frame->payload : "nothing came";
}

std::string said_back(WebSocketClient& client, const std::string& text) {
  client.send_text(text);
  return next_payload(client);
}

// --- the handshake ---

TEST(WebSocketServer, ShakesHandsAsTheStandardHasIt) {
  EchoServed served;
  WebSocketClient client = served.client("echo.v1");
  EXPECT_EQ(client.handshake().status, 101);
  EXPECT_EQ(client.handshake().field("sec-websocket-accept"), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=")
      << "RFC 6455 §1.3";
  EXPECT_EQ(client.handshake().field("upgrade"), "websocket");
  EXPECT_EQ(client.handshake().field("connection"), "Upgrade");
  EXPECT_EQ(client.handshake().field("sec-websocket-protocol"), "echo.v1");
  EXPECT_EQ(client.handshake().fields.count("sec-websocket-extensions"), 0U);
  EXPECT_EQ(said_back(client, "wind"), "wind");
}

TEST(WebSocketServer, SpeaksTheFirstProtocolOfTheClientThatItKnows) {
  EchoServed served;
  for (const auto& [offered, agreed] :
       std::vector<std::pair<std::string, std::string>>{{"echo.v2", "echo.v2"},
                                                        {"echo.v2, echo.v1", "echo.v2"},
                                                        {"echo.v9,echo.v1,echo.v2", "echo.v1"}}) {
    WebSocketClient client = served.client(offered);
    EXPECT_EQ(client.handshake().field("sec-websocket-protocol"), agreed) << offered;
    EXPECT_EQ(said_back(client, "x"), "x");
    EXPECT_EQ(served.echo->last_protocol, agreed);
  }
  WebSocketClient in_two_lines =
      served.client("echo.v9", "Sec-WebSocket-Protocol: echo.v2, echo.v1\r\n");
  EXPECT_EQ(in_two_lines.handshake().field("sec-websocket-protocol"), "echo.v2");
}

TEST(WebSocketServer, AHandlerWithoutProtocolsAgreesOnNone) {
  EchoServed served;
  served.echo->known.clear();
  for (const std::string offered : {"", "anything"}) {
    WebSocketClient client = served.client(offered);
    EXPECT_EQ(client.handshake().status, 101);
    EXPECT_EQ(client.handshake().fields.count("sec-websocket-protocol"), 0U);
  }
}

void expect_problem(const HttpReply& reply, int status, const std::string& part) {
  EXPECT_EQ(reply.status, status);
  EXPECT_EQ(reply.field("content-type"), "application/problem+json");
  const auto problem = nlohmann::json::parse(reply.body);
  EXPECT_NE(problem.at("detail").get<std::string>().find(part), std::string::npos) << problem;
}

TEST(WebSocketServer, AHandshakeThatIsRefusedIsToldWhyAndTheConnectionGoesOn) {
  EchoServed served;
  for (const std::string unknown : {"", "echo.v3", "echo.v", "ECHO.V1"}) {
    WebSocketClient client = served.client(unknown);
    expect_problem(client.handshake(), 400, "'" + unknown + "'");
    expect_problem(client.handshake(), 400, "echo.v1, echo.v2");
    ASSERT_TRUE(client.connection().get("/short"));
  }
  const std::string upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\n";
  const std::string version = "Sec-WebSocket-Version: 13\r\n";
  const std::string protocol = "Sec-WebSocket-Protocol: echo.v1\r\n";
  const auto asked = [&](const std::string& fields) {
    return served.served->get("/ws", fields).value();
  };
  for (const std::string key : {"short", "dGhlIHNhbXBsZSBub25jZQ=", "dGhlIHNhbXBsZSBub25jZQ!!",
                                "dGhlIHNhbXBsZSBub25jZSEh"}) {
    expect_problem(asked(upgrade + version + protocol + "Sec-WebSocket-Key: " + key + "\r\n"), 400,
                   "Sec-WebSocket-Key");
  }
  expect_problem(asked(upgrade + version + protocol), 400, "Sec-WebSocket-Key");
  const std::string key = "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n";
  const HttpReply old = asked(upgrade + key + protocol + "Sec-WebSocket-Version: 8\r\n");
  expect_problem(old, 426, "'8'");
  EXPECT_EQ(old.field("sec-websocket-version"), "13");
  HttpClient with_body = served.served->client();
  with_body.send("GET /ws HTTP/1.1\r\nHost: localhost\r\n" + upgrade + version + key + protocol +
                 "Content-Length: 4\r\n\r\nbody");
  expect_problem(with_body.receive().value(), 400, "no body");
  EXPECT_EQ(served.echo->opened_count, 0);
}

TEST(WebSocketServer, ARequestForNoUpgradeIsToldWhatThePathIsFor) {
  EchoServed served;
  const auto reply = served.served->get("/ws");
  ASSERT_TRUE(reply);
  expect_problem(*reply, 426, "echo.v1 or echo.v2");
  EXPECT_EQ(reply->field("upgrade"), "websocket");
  EXPECT_EQ(served.served->get("/ws", "Connection: Upgrade\r\nUpgrade: h2c\r\n")->status, 426);
  EXPECT_EQ(served.served->get("/ws", "Upgrade: websocket\r\n")->status, 426);
  HttpClient old = served.served->client();
  old.send(
      "GET /ws HTTP/1.0\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
      "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
      "Sec-WebSocket-Protocol: echo.v1\r\n\r\n");
  EXPECT_EQ(old.receive()->status, 426) << "HTTP/1.0 knows no upgrade";
}

TEST(WebSocketServer, AClientThatDoesNotWaitForTheAnswerIsRefused) {
  EchoServed served;
  WebSocketClient client = served.client("echo.v1", "\r\n" + client_frame(0x81, "early"));
  expect_problem(client.handshake(), 400, "waits for the answer");
  EXPECT_EQ(served.echo->opened_count, 0);
}

TEST(WebSocketServer, AnyOriginMayListenAndTheHandlerKnowsWhomToTrust) {
  EchoServed served;
  WebSocketClient own = served.client("echo.v1");
  EXPECT_EQ(said_back(own, "x"), "x");
  EXPECT_TRUE(served.echo->last_is_trusted);
  WebSocketClient page = served.client("echo.v1", "Origin: https://elsewhere.example\r\n");
  EXPECT_EQ(page.handshake().status, 101);
  EXPECT_EQ(said_back(page, "x"), "x");
  EXPECT_FALSE(served.echo->last_is_trusted);
}

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

// --- limits ---

TEST(WebSocketServer, SilentClientsArePingedAndThoseThatAreGoneAreClosed) {
  ServerOptions options;
  options.limits.ping_time = 400ms;
  EchoServed served(options);
  WebSocketClient alive = served.client();
  WebSocketClient gone = served.client();
  for (int i = 0; i < 5; ++i) {
    const auto ping = alive.receive(5s);
    ASSERT_TRUE(ping) << i;
    EXPECT_EQ(ping->opcode, 9);
    ASSERT_TRUE(alive.send(0x8a, ping->payload));
  }
  EXPECT_TRUE(gone.connection().is_closed_within(2s));
  EXPECT_TRUE(comes_true([&] { return served.echo->closed_count == 1; }));
  EXPECT_TRUE(alive.send(0x8a, ""));
  EXPECT_TRUE(alive.send_text("still here"));
}

TEST(WebSocketServer, WhoTakesNothingInIsDroppedForAndThenClosed) {
  ServerOptions options;
  options.limits.websocket_queue_bytes = 1 << 20;
  options.limits.write_time = 2s;
  EchoServed served(options);
  WebSocketClient reader = served.client();
  WebSocketClient deaf = served.client("echo.v1", {}, 4096);
  ASSERT_TRUE(comes_true([&] { return served.echo->opened_count == 2; }));
  const auto body = std::make_shared<const std::vector<std::uint8_t>>(10'000);
  const auto from = std::chrono::steady_clock::now();
  std::size_t dropped = 0;
  for (int i = 0; i < 2000; ++i) {  // 20 MB
    dropped += served.echo->sockets[1]->send({false, "x", body, Worth::best_effort});
  }
  EXPECT_LT(std::chrono::steady_clock::now() - from, 1500ms) << "the sender does not wait";
  EXPECT_GT(dropped, 1000U);
  EXPECT_LT(dropped, 2000U);
  EXPECT_TRUE(served.metrics_have("slackwater_http_websocket_dropped_frames_total " +
                                  std::to_string(dropped)));
  EXPECT_LT(body.use_count(), 250) << "about a megabyte of them, what is being written included";
  EXPECT_EQ(said_back(reader, "still here"), "still here");
  EXPECT_TRUE(comes_true([&] { return served.echo->closed_count == 1; }, 20s));
  EXPECT_EQ(body.use_count(), 1) << "nothing is kept for who has gone";
  EXPECT_EQ(served.echo->sockets[1]->send({false, "x", body, Worth::reliable}), 0U);
  EXPECT_EQ(body.use_count(), 1);
}

TEST(WebSocketServer, WhoDoesNotTakeInEvenWhatIsEssentialIsToldSoAndClosed) {
  ServerOptions options;
  options.limits.websocket_queue_bytes = 100'000;
  EchoServed served(options);
  WebSocketClient slow = served.client();
  ASSERT_TRUE(comes_true([&] { return served.echo->opened_count == 1; }));
  for (int i = 0; i < 2000; ++i) {
    served.echo->sockets[0]->send({true, std::string(10'000, 'x'), nullptr, Worth::essential});
  }
  EXPECT_EQ(slow.receive_close(), 1008);
}

TEST(WebSocketServer, HasRoomForSoManyAtOnce) {
  ServerOptions options;
  options.limits.websockets = 3;
  EchoServed served(options);
  std::vector<WebSocketClient> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(served.client());
    EXPECT_EQ(clients.back().handshake().status, 101);
  }
  EXPECT_TRUE(served.metrics_have("slackwater_http_websockets 3"));
  expect_problem(served.client().handshake(), 503, "All 3 WebSockets");
  EXPECT_EQ(served.served->get("/short")->status, 200) << "requests pass";
  clients.pop_back();
  EXPECT_TRUE(comes_true([&] { return served.client().handshake().status == 101; }));
}

TEST(WebSocketServer, ACrowdOfRequestsDisplacesNoSocket) {
  ServerOptions options;
  options.limits.connections = 8;
  options.limits.patience = 50ms;
  EchoServed served(options);
  std::vector<WebSocketClient> sockets;
  for (int i = 0; i < 4; ++i) sockets.push_back(served.client());
  std::this_thread::sleep_for(100ms);
  std::vector<HttpClient> crowd;
  for (int i = 0; i < 20; ++i) {
    crowd.push_back(served.served->client());
    std::this_thread::sleep_for(20ms);
  }
  for (WebSocketClient& socket : sockets) EXPECT_EQ(said_back(socket, "here"), "here");
}

std::size_t open_descriptors() {
  std::size_t count = 0;
  DIR* folder = ::opendir("/proc/self/fd");
  while (::readdir(folder) != nullptr) ++count;
  ::closedir(folder);
  return count;
}

TEST(WebSocketServer, TwoHundredThatComeAndGoLeaveNothingBehind) {
  EchoServed served;
  const std::size_t before = open_descriptors();
  for (int i = 0; i < 200; ++i) {
    WebSocketClient client = served.client();
    ASSERT_EQ(client.handshake().status, 101) << i;
    if (i % 4 == 0) {
      EXPECT_EQ(said_back(client, "x"), "x");
    }
    if (i % 4 == 1) client.send(0x88, "");
    if (i % 4 == 2) client.connection().send("half a fra");
    if (i % 4 == 3) client.connection().reset();
  }
  EXPECT_TRUE(comes_true([&] { return served.echo->closed_count == 200; }));
  EXPECT_EQ(served.echo->opened_count, 200);
  EXPECT_TRUE(served.metrics_have("slackwater_http_websockets 0"));
  EXPECT_TRUE(served.metrics_have("slackwater_http_websockets_total 200"));
  EXPECT_TRUE(comes_true([&] { return open_descriptors() == before; }));
}

TEST(WebSocketServer, StoppingSaysFarewellToAllAndEndsSoon) {
  EchoServed served;
  std::vector<WebSocketClient> clients;
  for (int i = 0; i < 5; ++i) clients.push_back(served.client());
  ASSERT_TRUE(comes_true([&] { return served.echo->opened_count == 5; }));
  const auto from = std::chrono::steady_clock::now();
  std::atomic<bool> is_over{false};
  std::thread speaker([&] {
    while (!is_over) {
      for (const auto& socket : served.echo->sockets) {
        socket->send({true, "news", nullptr, Worth::best_effort});
      }
    }
  });
  std::thread stopper([&] { served.served->server().stop(); });
  for (std::size_t i = 0; i < 4; ++i) {  // the last one never answers
    EXPECT_EQ(clients[i].receive_close(), 1001);
    clients[i].send(0x88, "\x03\xe9");
    EXPECT_TRUE(clients[i].connection().is_closed_within(5s));
  }
  stopper.join();
  EXPECT_LT(std::chrono::steady_clock::now() - from, 4s);
  EXPECT_EQ(served.echo->closed_count, 5);
  is_over = true;
  speaker.join();
  served.served.reset();
  EXPECT_EQ(served.echo->sockets[0]->send({true, "to nobody", nullptr, Worth::essential}), 0U);
}

}  // namespace
}  // namespace slackwater::tests

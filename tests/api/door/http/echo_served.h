#pragma once
#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "api/door/http/websocket.h"
#include "tests/api/door/http/served.h"
#include "tests/support/websocket_client.h"

// WebSockets of the real server, spoken to over real sockets by a client made by hand.

namespace slackwater::tests {

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

inline std::string next_payload(WebSocketClient& client) {
  const auto frame = client.receive(5s);
  return frame ? frame->payload : "nothing came";
}

inline std::string said_back(WebSocketClient& client, const std::string& text) {
  client.send_text(text);
  return next_payload(client);
}

inline void expect_problem(const HttpReply& reply, int status, const std::string& part) {
  EXPECT_EQ(reply.status, status);
  EXPECT_EQ(reply.field("content-type"), "application/problem+json");
  const auto problem = nlohmann::json::parse(reply.body);
  EXPECT_NE(problem.at("detail").get<std::string>().find(part), std::string::npos) << problem;
}

}  // namespace slackwater::tests

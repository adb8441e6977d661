// Silent, slow, many and hasty clients of WebSockets.
#include <dirent.h>

#include "tests/api/door/http/echo_served.h"

namespace slackwater::tests::websocket_limits_test {
namespace {

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
}  // namespace slackwater::tests::websocket_limits_test

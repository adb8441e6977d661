// How a connection becomes a WebSocket, or is told why not.
#include "tests/api/door/http/echo_served.h"

namespace slackwater::tests::websocket_handshake_test {
namespace {

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

}  // namespace
}  // namespace slackwater::tests::websocket_handshake_test

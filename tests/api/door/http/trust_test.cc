#include "api/door/http/trust.h"

#include <gtest/gtest.h>

#include "fields/base/error.h"
#include "tests/api/door/http/served.h"

namespace slackwater::tests::trust_test {
namespace {

using namespace slackwater::api::http;

Arrival local_arrival() {
  Arrival arrival;
  arrival.peer_is_loopback = true;
  arrival.request.host = "127.0.0.1:8080";
  return arrival;
}

TEST(Trust, ThisMachineMayWriteUnlessAnotherSpeaksThroughIt) {
  EXPECT_TRUE(is_trusted(std::nullopt, local_arrival()));
  Arrival page = local_arrival();
  page.request.origin = "http://127.0.0.1:8080";
  EXPECT_TRUE(is_trusted(std::nullopt, page)) << "our own page";
  page.request.origin = "https://evil.example";
  EXPECT_FALSE(is_trusted(std::nullopt, page)) << "another site's page in a browser here";
  page.request.origin = "null";
  EXPECT_FALSE(is_trusted(std::nullopt, page)) << "a sandboxed page";
  Arrival rebound = local_arrival();
  rebound.request.host = "evil.example:8080";
  rebound.request.origin = "http://evil.example:8080";
  EXPECT_FALSE(is_trusted(std::nullopt, rebound)) << "a name that DNS points here";
  Arrival proxied = local_arrival();
  proxied.is_forwarded = true;
  EXPECT_FALSE(is_trusted(std::nullopt, proxied));
}

TEST(Trust, AfarTheTokenDecides) {
  Arrival far;
  far.request.host = "ocean.example";
  EXPECT_FALSE(is_trusted("secret", far));
  far.request.authorization = "Bearer secret";
  EXPECT_TRUE(is_trusted("secret", far));
  far.request.authorization = "bearer   secret";
  EXPECT_TRUE(is_trusted("secret", far));
  for (const std::string wrong :
       {"Bearer secre", "Bearer secrets", "Bearer ", "secret", "Basic secret", "Bearer SECRET"}) {
    far.request.authorization = wrong;
    EXPECT_FALSE(is_trusted("secret", far)) << wrong;
    EXPECT_FALSE(is_trusted("", far)) << "an empty token opens nothing";
    EXPECT_FALSE(is_trusted(std::nullopt, far)) << wrong;
  }
}

TEST(Trust, KnowsLoopbackByName) {
  for (const char* host : {"localhost", "localhost:8080", "127.0.0.1", "127.1.2.3:1", "[::1]:80"}) {
    EXPECT_TRUE(is_loopback_host(host)) << host;
  }
  for (const char* host : {"", "localhost.evil.example", "evil.example", "[::2]:80", "10.0.0.1",
                           "127.evil.example", "127.0.0.1.evil.example:80", "[::1]evil.example",
                           "127.0.0.1:80@evil.example", "localhost:evil", "[::1"}) {
    EXPECT_FALSE(is_loopback_host(host)) << host;
  }
}

TEST(Trust, KnowsAddressesInNumbers) {
  for (const char* host : {"10.0.0.1", "192.168.1.7:8080", "[::1]:80", "[2001:db8::7]"}) {
    EXPECT_TRUE(is_numeric_host(host)) << host;
  }
  for (const char* host :
       {"", "localhost", "evil.example", "10.0.0.1.evil.example", "[]", "[x]:80", "[::1",
        "10.0.0.1e:80", "[::1]evil.example", "10.0.0.1:80@evil.example"}) {
    EXPECT_FALSE(is_numeric_host(host)) << host;
  }
}

TEST(Trust, WritingWithoutItIsRefusedReadingIsNot) {
  ServerOptions options;
  options.token = "secret";
  const Served served(example_router(), options);
  HttpClient client = served.client();
  const std::string post = "POST /write HTTP/1.1\r\nHost: localhost\r\nContent-Length: 2\r\n";
  const std::string foreign = "Origin: https://evil.example\r\n";
  ASSERT_TRUE(client.send(post + foreign + "\r\nhi"));
  const auto refused = client.receive();
  ASSERT_TRUE(client.send(post + foreign + "Authorization: Bearer secret\r\n\r\nhi"));
  const auto granted = client.receive();
  ASSERT_TRUE(client.send(post + "\r\nhi"));
  const auto local = client.receive();
  const auto read = client.get("/short", foreign);
  ASSERT_TRUE(refused && granted && local && read);
  EXPECT_EQ(refused->status, 401);
  EXPECT_EQ(refused->field("www-authenticate"), "Bearer");
  EXPECT_EQ(granted->status, 200);
  EXPECT_EQ(granted->body, "2");
  EXPECT_EQ(local->status, 200);
  EXPECT_EQ(read->status, 200);
}

TEST(Trust, AServerThatOthersReachWantsATokenOrWritesNothing) {
  ServerOptions options;
  options.address = "0.0.0.0";
  try {
    const Server open(options, example_router());
    FAIL() << "it would let anyone write";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::usage);
    EXPECT_NE(error.message().find("token"), std::string::npos);
  }
  options.token = "";
  EXPECT_THROW(Server(options, example_router()), Error);
  options.token = "secret";
  EXPECT_NO_THROW(Server(options, example_router()));
  options.token.reset();
  options.read_only = true;
  Served served(example_router(), options);
  HttpClient client = served.client();
  ASSERT_TRUE(client.send("POST /write HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n"));
  const auto reply = client.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 405);
  EXPECT_EQ(reply->field("allow"), "GET, HEAD, OPTIONS");
}

// Of a server that writes nothing else, and whatever the machine that asks.
TEST(Trust, WhatGuardsItselfIsWrittenToWithoutTheServersToken) {
  const auto served_by = [](const Router& router) {
    ServerOptions options;
    options.read_only = true;
    options.guards_itself = [](const Request& request) { return request.path == "/write"; };
    options.methods_at = [router](const std::string& path) { return router.methods_at(path); };
    return options;
  };
  Router router = example_router();
  router.add("POST", "/other", [](const Request&) { return text_response("written"); });
  const Served served(router, served_by(router));
  HttpClient client = served.client();
  const auto sent = [&](const std::string& line) {
    EXPECT_TRUE(client.send(line + " HTTP/1.1\r\nHost: far.example\r\nForwarded: for=1.2.3.4\r\n"
                                   "Content-Length: 0\r\n\r\n"));
    return client.receive();
  };
  EXPECT_EQ(sent("POST /write")->status, 200);
  for (const char* const other : {"POST /other", "POST /%77rite", "POST /write/"})
    EXPECT_EQ(sent(other)->status, 401) << other;
  for (const char* const other : {"POST /nowhere", "PUT /write"})
    EXPECT_EQ(sent(other)->status, 405) << other;
  EXPECT_EQ(sent("OPTIONS /write")->field("allow"), "POST, OPTIONS");
  EXPECT_EQ(sent("OPTIONS /short")->field("allow"), "GET, HEAD, OPTIONS");
}

}  // namespace
}  // namespace slackwater::tests::trust_test

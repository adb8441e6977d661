#include "api/door/http/server.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <thread>

#include "fields/base/error.h"
#include "tests/api/door/http/served.h"

// The real server, spoken to over real sockets.

namespace slackwater::tests::server_test {
namespace {

using namespace std::chrono_literals;

std::string inflated(const std::string& coded) {
  z_stream stream{};
  EXPECT_EQ(inflateInit2(&stream, 15 + 16), Z_OK);
  std::string plain(1 << 20, '\0');
  std::string input = coded;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_out = static_cast<uInt>(plain.size());
  EXPECT_EQ(inflate(&stream, Z_FINISH), Z_STREAM_END);
  plain.resize(stream.total_out);
  inflateEnd(&stream);
  return plain;
}

TEST(HttpServer, AnswersManyRequestsOnOneConnection) {
  const Served served;
  HttpClient client = served.client();
  for (int i = 0; i < 100; ++i) {
    const auto reply = client.get("/echo/" + std::to_string(i) + "?n=" + std::to_string(i));
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 200);
    EXPECT_EQ(reply->body, std::to_string(i) + "?n=" + std::to_string(i));
    EXPECT_EQ(reply->field("connection"), "keep-alive");
  }
}

TEST(HttpServer, AnswersPipelinedRequestsInTheirOrder) {
  const Served served;
  HttpClient client = served.client();
  std::string requests;
  for (int i = 0; i < 50; ++i) {
    requests += "GET /echo/" + std::to_string(i) + " HTTP/1.1\r\nHost: localhost\r\n\r\n";
  }
  ASSERT_TRUE(client.send(requests));
  for (int i = 0; i < 50; ++i) {
    const auto reply = client.receive();
    ASSERT_TRUE(reply) << i;
    EXPECT_EQ(reply->body, std::to_string(i) + "?");
  }
}

TEST(HttpServer, ReadsARequestThatComesInPieces) {
  const Served served;
  HttpClient client = served.client();
  const std::string request =
      "POST /write HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\n"
      "5\r\nhello\r\n6\r\n world\r\n0\r\n\r\n";
  for (const char c : request) {
    ASSERT_TRUE(client.send({&c, 1}));
    std::this_thread::sleep_for(200us);
  }
  const auto reply = client.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body, "11");
}

TEST(HttpServer, ClosesAfterTheAnswerWhereTheClientAsksForIt) {
  const Served served;
  HttpClient client = served.client();
  const auto reply = client.get("/short", "Connection: close\r\n");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->field("connection"), "close");
  EXPECT_TRUE(client.is_closed_within(5s));

  HttpClient old = served.client();
  ASSERT_TRUE(old.send("GET /short HTTP/1.0\r\n\r\n"));
  ASSERT_TRUE(old.receive());
  EXPECT_TRUE(old.is_closed_within(5s));
}

TEST(HttpServer, EveryAnswerCarriesTheFieldsOfTheHouse) {
  const Served served;
  for (const std::string target : {"/short", "/nothing/here"}) {
    const auto reply = served.get(target);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->field("server"), "slackwater");
    EXPECT_EQ(reply->field("x-content-type-options"), "nosniff");
    EXPECT_EQ(reply->field("access-control-allow-origin"), "*");
    EXPECT_EQ(reply->field("date").substr(3, 2), ", ");
    EXPECT_EQ(reply->field("slackwater-route"), "") << "ours, not the client's";
  }
}

TEST(HttpServer, APageRunsNothingUnlessItsHandlerHasAPolicy) {
  api::http::Router router;
  router.add("GET", "/bare", [](const api::http::Request&) {
    return text_response("<script>1</script>", "text/html; charset=utf-8");
  });
  router.add("GET", "/own", [](const api::http::Request&) {
    auto response = text_response("a page", "text/html");
    response.headers.emplace_back("content-security-policy", "default-src 'self'");
    return response;
  });
  router.add("GET", "/text", [](const api::http::Request&) { return text_response("{}"); });
  const Served served(router);
  const auto bare = served.get("/bare"), own = served.get("/own"), text = served.get("/text");
  ASSERT_TRUE(bare && own && text);
  EXPECT_EQ(bare->field("content-security-policy").find("default-src 'none'"), 0U);
  EXPECT_EQ(bare->field("content-security-policy").find("script-src"), std::string::npos);
  EXPECT_EQ(own->field("content-security-policy"), "default-src 'self'");
  EXPECT_EQ(text->field("content-security-policy"), "");
}

TEST(HttpServer, HeadTellsTheLengthOfWhatGetWouldSend) {
  const Served served;
  HttpClient client = served.client();
  ASSERT_TRUE(client.send("HEAD /long HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  const auto head = client.receive(false);
  const auto get = client.get("/long");  // would read a body first, had HEAD sent one
  ASSERT_TRUE(head && get);
  EXPECT_EQ(head->status, 200);
  EXPECT_EQ(get->body, long_body());
  EXPECT_EQ(head->field("content-length"), std::to_string(long_body().size()));
  EXPECT_EQ(head->field("etag"), get->field("etag"));
}

TEST(HttpServer, WhatTheClientHasIsNotSentAgain) {
  const Served served;
  HttpClient client = served.client();
  const auto first = client.get("/long");
  ASSERT_TRUE(first);
  EXPECT_EQ(first->field("cache-control"), "public, max-age=60");
  const std::string tag = first->field("etag");
  const auto again = client.get("/long", "If-None-Match: \"other\", W/" + tag + "\r\n");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->status, 304);
  EXPECT_EQ(again->body, "");
  EXPECT_EQ(again->field("etag"), tag);
  const auto changed = client.get("/short", "If-None-Match: " + tag + "\r\n");
  ASSERT_TRUE(changed);
  EXPECT_EQ(changed->status, 200);
  EXPECT_EQ(changed->field("cache-control"), "no-store");
}

TEST(HttpServer, CodesLongTextForClientsThatLikeIt) {
  const Served served;
  HttpClient client = served.client();
  const auto coded = client.get("/long", "Accept-Encoding: br, gzip;q=0.8\r\n");
  const auto plain = client.get("/long", "Accept-Encoding: gzip;q=0\r\n");
  const auto small = client.get("/short", "Accept-Encoding: gzip\r\n");
  ASSERT_TRUE(coded && plain && small);
  EXPECT_EQ(coded->field("content-encoding"), "gzip");
  EXPECT_EQ(coded->field("vary"), "Accept-Encoding");
  EXPECT_LT(coded->body.size(), long_body().size() / 2);
  EXPECT_EQ(inflated(coded->body), long_body());
  EXPECT_EQ(plain->field("content-encoding"), "");
  EXPECT_EQ(plain->field("vary"), "Accept-Encoding");
  EXPECT_EQ(small->field("content-encoding"), "");
  EXPECT_NE(coded->field("etag"), plain->field("etag")) << "a strong tag names bytes";
  const auto again = client.get(
      "/long", "Accept-Encoding: gzip\r\nIf-None-Match: " + coded->field("etag") + "\r\n");
  ASSERT_TRUE(again);
  EXPECT_EQ(again->status, 304);
}

TEST(HttpServer, LetsScriptsOfOtherSitesReadTheFieldsOfItsHandlers) {
  api::http::ServerOptions options;
  options.exposed_fields = {"House-Colour", "House-Number"};
  const Served served(example_router(), options);
  const auto reply = served.get("/short");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->field("access-control-expose-headers"),
            "Content-Disposition, ETag, Link, Location, Retry-After, House-Colour, House-Number");
}

TEST(HttpServer, TellsBrowsersWhatOtherSitesMayAsk) {
  const Served served;
  HttpClient client = served.client();
  ASSERT_TRUE(
      client.send("OPTIONS /long HTTP/1.1\r\nHost: localhost\r\nOrigin: https://a.example\r\n"
                  "Access-Control-Request-Method: GET\r\n\r\n"));
  const auto reply = client.receive(false);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 204);
  EXPECT_EQ(reply->field("access-control-allow-origin"), "*");
  EXPECT_EQ(reply->field("access-control-allow-methods"), "GET, HEAD, OPTIONS");
  EXPECT_EQ(reply->fields.count("content-length"), 0U) << "a 204 has none";
}

TEST(HttpServer, UnknownPathsAndMethodsAreProblemsThatSayWhatThereIs) {
  const Served served;
  HttpClient client = served.client();
  const auto missing = client.get("/shrt");
  ASSERT_TRUE(missing);
  EXPECT_EQ(missing->status, 404);
  EXPECT_EQ(missing->field("content-type"), "application/problem+json");
  const auto problem = nlohmann::json::parse(missing->body);
  EXPECT_EQ(problem.at("status"), 404);
  EXPECT_EQ(problem.at("instance"), "/shrt");
  EXPECT_NE(problem.at("detail").get<std::string>().find("/short"), std::string::npos);
  for (const std::string method : {"PUT", "DELETE", "BREW", "TRACE"}) {
    ASSERT_TRUE(client.send(method + " /short HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    const auto reply = client.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 405) << method;
    EXPECT_EQ(reply->field("allow"), "GET, HEAD, OPTIONS, POST");
  }
}

// What comes behind CONNECT is not HTTP: nothing of it is answered.
TEST(HttpServer, ConnectIsRefusedAndEndsTheConnection) {
  const Served served;
  HttpClient client = served.client();
  ASSERT_TRUE(
      client.send("CONNECT /short HTTP/1.1\r\nHost: localhost\r\n\r\n"
                  "GET /short HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  const auto reply = client.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 501);
  EXPECT_TRUE(client.is_closed_within(std::chrono::seconds(5)));
}

TEST(HttpServer, AClientThatIsDoneSendingStillGetsItsAnswer) {
  const Served served;
  HttpClient client = served.client();
  ASSERT_TRUE(client.send("GET /long HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  client.close_for_writing();
  const auto reply = client.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body, long_body());
  EXPECT_TRUE(client.is_closed_within(5s));
}

TEST(HttpServer, ALargeAnswerArrivesWhole) {
  const std::string large(20'000'000, 'x');
  const Served served(
      [&](const api::http::Request&) { return text_response(large, "application/netcdf"); });
  const auto reply = served.get("/");
  ASSERT_TRUE(reply);
  EXPECT_TRUE(reply->body == large);
}

TEST(HttpServer, StoppingLetsRequestsInProgressFinish) {
  std::atomic<bool> begun = false;
  Served served([&](const api::http::Request&) {
    begun = true;
    std::this_thread::sleep_for(300ms);
    return text_response("done");
  });
  HttpClient busy = served.client();
  HttpClient idle = served.client();
  ASSERT_TRUE(busy.send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  while (!begun) std::this_thread::sleep_for(1ms);
  const std::uint16_t port = served.server().port();
  served.server().stop();
  const auto reply = busy.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body, "done");
  EXPECT_TRUE(idle.is_closed_within(5s));
  EXPECT_THROW(HttpClient{port}, std::runtime_error);
  EXPECT_EQ(served.server().port(), 0);
}

TEST(HttpServer, StartsAgainOnTheSamePort) {
  std::uint16_t port = 0;
  for (int i = 0; i < 5; ++i) {
    api::http::ServerOptions options;
    options.port = port;
    Served served(example_router(), options);
    port = served.server().port();
    HttpClient kept_open = served.client();
    ASSERT_TRUE(kept_open.get("/short"));
    served.server().stop();
    served.server().start();
    EXPECT_TRUE(served.get("/short"));
  }
}

TEST(HttpServer, SaysWhyItCannotListen) {
  const Served first;
  api::http::ServerOptions options;
  options.port = const_cast<Served&>(first).server().port();
  try {
    const Served second(example_router(), options);
    FAIL() << "two servers on one port";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unavailable);
    EXPECT_NE(error.message().find("in use"), std::string::npos) << error.message();
  }
  options.address = "localhost";
  EXPECT_THROW(Served(example_router(), options), Error);
}

}  // namespace
}  // namespace slackwater::tests::server_test

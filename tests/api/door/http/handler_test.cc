#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/api/door/http/served.h"

// Handlers that fail, dawdle or echo what they should not: the server goes on.

namespace slackwater::tests::handler_test {
namespace {

using namespace std::chrono_literals;
using namespace slackwater::api::http;

Router failing_router() {
  Router router;
  router.add("GET", "/good", [](const Request&) { return text_response("good"); });
  router.add("GET", "/invalid", [](const Request&) -> Response {
    throw Error(ErrorKind::invalid_input, "z = -5 m; 0 to 80 m is expected");
  });
  router.add("GET", "/bug", [](const Request&) -> Response {
    expects(false, "the secret of the house");
    return {};
  });
  router.add("GET", "/internal", [](const Request&) -> Response {
    throw Error(ErrorKind::internal, "the secret of the house");
  });
  router.add("GET", "/number", [](const Request&) -> Response { throw 42; });
  router.add("GET", "/split", [](const Request&) {
    Response response = text_response("x");
    response.headers.emplace_back("Location", "/a\r\nSet-Cookie: evil");
    return response;
  });
  return router;
}

TEST(HandlerThatFails, IsAProblemThatTellsOnlyWhatTheClientCanMend) {
  std::mutex mutex;
  std::vector<std::string> log;
  ServerOptions options;
  options.on_failure = [&](const Request&, const std::string& what) {
    const std::lock_guard lock(mutex);
    log.push_back(what);
  };
  const Served served(failing_router(), options);
  HttpClient client = served.client();
  const auto invalid = client.get("/invalid");
  ASSERT_TRUE(invalid);
  EXPECT_EQ(invalid->status, 400);
  EXPECT_NE(invalid->body.find("0 to 80 m is expected"), std::string::npos);
  EXPECT_TRUE(log.empty());
  for (const std::string path : {"/bug", "/internal", "/number", "/split"}) {
    const auto reply = client.get(path);
    ASSERT_TRUE(reply) << path;
    EXPECT_EQ(reply->status, 500) << path;
    EXPECT_EQ(reply->body.find("secret"), std::string::npos) << reply->body;
    EXPECT_EQ(reply->field("set-cookie"), "") << path;
  }
  const auto good = client.get("/good");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->body, "good");
  ASSERT_EQ(log.size(), 4U);
  EXPECT_NE(log[0].find("the secret of the house"), std::string::npos);
}

TEST(HandlerWithATagOfItsOwn, KeepsItAndTheCodedBodyHasAnother) {
  const Served served([](const Request&) {
    Response response = text_response(long_body());
    response.headers.emplace_back("ETag", "\"run-7\"");
    return response;
  });
  HttpClient client = served.client();
  const auto plain = client.get("/");
  const auto coded = client.get("/", "Accept-Encoding: gzip\r\n");
  const auto again = client.get("/", "If-None-Match: \"run-7\"\r\n");
  ASSERT_TRUE(plain && coded && again);
  EXPECT_EQ(plain->field("etag"), "\"run-7\"");
  EXPECT_EQ(coded->field("etag"), "\"run-7-gzip\"");
  EXPECT_EQ(again->status, 304);
}

/// Four clients ask at once of a server too slow for any of them; each is told so.
void expect_four_late_answers(const Served& served) {
  std::vector<HttpClient> clients;
  for (int i = 0; i < 4; ++i) {
    clients.push_back(served.client());
    ASSERT_TRUE(clients.back().send("GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  }
  for (HttpClient& client : clients) {
    const auto reply = client.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->status, 503);
  }
}

TEST(HandlerThatDawdles, DoesNotKeepOthersWaiting) {
  const Served served([](const Request& request) {
    if (request.path == "/slow") std::this_thread::sleep_for(1s);
    return text_response(request.path);
  });
  HttpClient slow = served.client();
  ASSERT_TRUE(slow.send("GET /slow HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  std::this_thread::sleep_for(50ms);
  const auto from = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(served.get("/fast"));
  EXPECT_LT(std::chrono::steady_clock::now() - from, 800ms);
  const auto reply = slow.receive();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body, "/slow");
}

TEST(HandlerThatDawdles, IsAnsweredForWhenItsTimeIsUp) {
  ServerOptions options;
  options.limits.handler_time = 200ms;
  const Served served(
      [](const Request& request) {
        if (request.path == "/slow") std::this_thread::sleep_for(800ms);
        return text_response(request.path);
      },
      options);
  HttpClient client = served.client();
  const auto from = std::chrono::steady_clock::now();
  const auto late = client.get("/slow");
  ASSERT_TRUE(late);
  EXPECT_EQ(late->status, 503);
  EXPECT_LT(std::chrono::steady_clock::now() - from, 700ms);
  EXPECT_TRUE(client.is_closed_within(5s)) << "and no second answer follows";
}

TEST(HandlerThatDawdles, AllThreadsBusyStillEndsInAnAnswer) {
  std::atomic<int> runs = 0;
  ServerOptions options;
  options.limits.handler_time = 300ms;
  options.threads = 1;
  const Served served(
      [&](const Request&) {
        ++runs;
        std::this_thread::sleep_for(600ms);
        return text_response("late");
      },
      options);
  expect_four_late_answers(served);
  EXPECT_LE(runs, 2) << "what nobody waits for any more is not begun";
}

TEST(WorkThatTakesLong, IsPassedByShortAnswersAndDoneAFewAtATime) {
  std::atomic<int> at_work = 0;
  std::atomic<int> most_at_work = 0;
  Router router;
  router.add("GET", "/short", [](const Request&) { return text_response("short"); });
  router.add("GET", "/long", [&](const Request&) {
    return LongWork{[&] {
      most_at_work = std::max(most_at_work.load(), ++at_work);
      std::this_thread::sleep_for(200ms);
      --at_work;
      return text_response("long");
    }};
  });
  ServerOptions options;
  options.threads = 1;
  const Served served(router, options);
  std::vector<HttpClient> clients;
  for (int i = 0; i < 5; ++i) {
    clients.push_back(served.client());
    ASSERT_TRUE(clients.back().send("GET /long HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  }
  std::this_thread::sleep_for(50ms);
  const auto from = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(served.get("/short"));
  EXPECT_LT(std::chrono::steady_clock::now() - from, 500ms) << "in turn they would wait 950 ms";
  for (HttpClient& client : clients) {
    const auto reply = client.receive();
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->body, "long");
  }
  EXPECT_EQ(most_at_work, 1);
}

TEST(WorkThatTakesLong, FailsAsAShortAnswerWould) {
  std::mutex mutex;
  std::vector<std::string> log;
  ServerOptions options;
  options.on_failure = [&](const Request&, const std::string& what) {
    const std::lock_guard lock(mutex);
    log.push_back(what);
  };
  options.metrics = std::make_shared<Metrics>(std::vector<std::string>{"/long"});
  Router router;
  router.add("GET", "/long", [](const Request&) {
    return LongWork{[]() -> Response { throw Error(ErrorKind::internal, "the secret"); }};
  });
  const Served served(router, options);
  const auto reply = served.get("/long");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->status, 500);
  EXPECT_EQ(reply->body.find("secret"), std::string::npos) << reply->body;
  const std::string counted =
      R"(slackwater_http_requests_total{route="/long",method="GET",status="500"} 1)";
  for (int i = 0; i < 100 && options.metrics->exposition().find(counted) == std::string::npos; ++i)
    std::this_thread::sleep_for(10ms);
  EXPECT_NE(options.metrics->exposition().find(counted), std::string::npos);
  const std::lock_guard lock(mutex);
  EXPECT_EQ(log.size(), 1U);
}

TEST(WorkThatTakesLong, IsNotBegunWhenNobodyWaitsForItAnyMore) {
  std::atomic<int> runs = 0;
  ServerOptions options;
  options.limits.handler_time = 300ms;
  options.threads = 1;
  const Served served(
      [&](const Request&) {
        return LongWork{[&] {
          ++runs;
          std::this_thread::sleep_for(600ms);
          return text_response("late");
        }};
      },
      options);
  expect_four_late_answers(served);
  EXPECT_LE(runs, 2);
}

TEST(Handlers, RunAtOnceForManyClients) {
  std::atomic<int> total = 0;
  ServerOptions options;
  options.metrics = std::make_shared<Metrics>(std::vector<std::string>{});
  const Served served(
      [&](const Request&) {
        ++total;
        return text_response(long_body());
      },
      options);
  std::vector<std::thread> clients;
  std::atomic<int> right = 0;
  for (int i = 0; i < 8; ++i) {
    clients.emplace_back([&] {
      HttpClient client = served.client();
      for (int k = 0; k < 100; ++k) {
        const auto reply = client.get("/", k % 2 == 0 ? "Accept-Encoding: gzip\r\n" : "");
        if (reply && reply->status == 200) ++right;
        (void)options.metrics->exposition();
      }
    });
  }
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(right, 800);
  EXPECT_EQ(total, 800);
}

}  // namespace
}  // namespace slackwater::tests::handler_test

#include "api/door/http/monitoring.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "fields/base/error.h"
#include "tests/api/door/http/served.h"
#include "tests/support/contains.h"

namespace slackwater::tests::monitoring_test {
namespace {

using namespace slackwater::api::http;
using nlohmann::json;

const std::string from_afar = "X-Forwarded-For: 192.0.2.7\r\n";
const std::string with_token = from_afar + "Authorization: Bearer a-token-of-ours\r\n";
constexpr const char* secret = "what monitors are told";

Router monitored_router(Monitoring who) {
  Router router = example_router();
  const auto told = [](int status) {
    return [status](const Request&) {
      Response response = text_response(secret, "text/plain");
      response.status = status;
      return response;
    };
  };
  add_monitoring_routes(router, who, {told(200), told(503), told(200)});
  return router;
}

Served served_to(Monitoring who) {
  ServerOptions options;
  options.token = "a-token-of-ours";
  options.read_only = true;
  return Served(monitored_router(who), options);
}

/// Of /health, /health/fresh and /metrics.
using Statuses = std::array<int, 3>;

Statuses statuses_of(const Served& served, const std::string& fields) {
  const auto status = [&](const char* path) { return served.get(path, fields)->status; };
  return {status("/health"), status("/health/fresh"), status("/metrics")};
}

TEST(Monitoring, IsForThoseWhomTheOperatorChose) {
  const Statuses told{200, 503, 200}, refused{403, 403, 403}, nothing{404, 404, 404};
  struct Case {
    Monitoring who;
    Statuses here, afar, by_token;
  };
  for (const Case& of : {Case{Monitoring::everyone, told, told, told},
                         Case{Monitoring::health, told, {200, 503, 403}, told},
                         Case{Monitoring::local, told, refused, told},
                         Case{Monitoring::nobody, nothing, nothing, nothing}}) {
    const auto word = monitoring_words.at(static_cast<std::size_t>(of.who));
    const Served served = served_to(of.who);
    EXPECT_EQ(statuses_of(served, ""), of.here) << word;
    EXPECT_EQ(statuses_of(served, from_afar), of.afar) << word;
    EXPECT_EQ(statuses_of(served, with_token), of.by_token) << word;
    EXPECT_EQ(served.get("/short", from_afar)->status, 200) << word << ": nothing else is closed";
  }
}

TEST(Monitoring, OfThisMachineIsForNobodyWhomAnotherSpeaksThrough) {
  const Served served = served_to(Monitoring::local);
  const auto status = [&](const std::string& host, const std::string& fields) {
    HttpClient client = served.client();
    EXPECT_TRUE(client.send("GET /metrics HTTP/1.1\r\nHost: " + host + "\r\n" + fields + "\r\n"));
    return client.receive()->status;
  };
  EXPECT_EQ(status("localhost:8080", ""), 200);
  EXPECT_EQ(status("[::1]", ""), 200);
  for (const char* proxied : {"X-Forwarded-For: 127.0.0.1\r\n", "X-Forwarded-For:\r\n",
                              "x-forwarded-for: localhost\r\n", "Forwarded: for=127.0.0.1\r\n"})
    EXPECT_EQ(status("localhost", proxied), 403) << proxied;
  EXPECT_EQ(status("localhost", "Origin: https://evil.example\r\n"), 403)
      << "another site's page, in a browser here";
  EXPECT_EQ(status("evil.example", ""), 403) << "a name that DNS points here";
  EXPECT_EQ(status("192.0.2.7", ""), 403) << "a proxy that says who was asked, not who asks";
  for (const char* wrong : {"Bearer ", "Bearer a-token-of-our", "Basic a-token-of-ours"})
    EXPECT_EQ(status("ocean.example", std::string("Authorization: ") + wrong + "\r\n"), 403)
        << wrong;
}

// The rule is the handler's: a path is the same however it is written.
TEST(Monitoring, IsRefusedByWhateverNameAndMethodItIsAskedFor) {
  const Served served = served_to(Monitoring::local);
  for (const std::string target :
       {"/metrics", "/metrics/", "//metrics", "/%6detrics", "/metrics?x=1",
        "http://127.0.0.1/metrics", "/health/", "/health/fresh/", "/%68ealth/%66resh"}) {
    const auto reply = served.get(target, from_afar + "If-None-Match: *\r\n");
    ASSERT_TRUE(reply) << target;
    EXPECT_EQ(reply->status, 403) << target;
    EXPECT_EQ(reply->body.find(secret), std::string::npos) << target;
  }
  HttpClient client = served.client();
  ASSERT_TRUE(client.send("HEAD /metrics HTTP/1.1\r\nHost: localhost\r\n" + from_afar + "\r\n"));
  const auto head = client.receive(false);
  ASSERT_TRUE(head);
  EXPECT_EQ(head->status, 403);
}

TEST(Monitoring, IsRefusedInOurUsualWords) {
  const auto reply = served_to(Monitoring::health).get("/metrics", from_afar);
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->field("content-type"), "application/problem+json");
  EXPECT_EQ(reply->field("cache-control"), "no-store");
  const json problem = json::parse(reply->body);
  EXPECT_EQ(problem.at("status"), 403);
  EXPECT_EQ(problem.at("title"), "Forbidden");
  EXPECT_EQ(problem.at("instance"), "/metrics");
  for (const char* words : {"127.0.0.1", "not through a proxy", "Bearer", "--monitoring"})
    EXPECT_TRUE(contains(problem.at("detail"), words));
}

TEST(Monitoring, OfNobodyHasNoPathsAtAll) {
  const Router router = monitored_router(Monitoring::nobody);
  for (const char* path : {"/health", "/health/fresh", "/metrics"})
    EXPECT_EQ(router.methods_at(path), "") << path;
  const auto reply = served_to(Monitoring::nobody).get("/metrics");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->body.find("health"), std::string::npos) << reply->body;
  EXPECT_EQ(reply->body, [] {
    std::string body = served_to(Monitoring::nobody).get("/m3trics")->body;
    return body.replace(body.find("m3trics"), 7, "metrics");
  }()) << "as of any path that never was";
}

TEST(Monitoring, IsDescribedAsItIsServed) {
  const std::string health = "/paths/~1health/get", metrics = "/paths/~1metrics/get";
  const auto is_guarded = [](const json& document, const std::string& operation) {
    const json& get = document.at(json::json_pointer(operation));
    EXPECT_EQ(get.contains("security"), get.at("responses").contains("403")) << operation;
    return get.contains("security");
  };
  const json open = monitoring_document(Monitoring::everyone);
  EXPECT_FALSE(is_guarded(open, health));
  EXPECT_FALSE(is_guarded(open, metrics));
  const json half = monitoring_document(Monitoring::health);
  EXPECT_FALSE(is_guarded(half, health));
  EXPECT_TRUE(is_guarded(half, metrics));
  const json closed = monitoring_document(Monitoring::local);
  EXPECT_TRUE(is_guarded(closed, health));
  EXPECT_TRUE(is_guarded(closed, metrics));
  EXPECT_EQ(closed.at("paths").size(), 3U);
  EXPECT_EQ(monitoring_document(Monitoring::nobody), json::object());
}

TEST(Monitoring, IsNamedByOneOfFourWords) {
  for (std::size_t i = 0; i < monitoring_words.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(monitoring_named(monitoring_words.at(i))), i);
  EXPECT_EQ(monitoring_named("local"), Monitoring::local);
  for (const char* word : {"", "Local", "loc", "everyone ", "noone"}) {
    try {
      (void)monitoring_named(word);
      ADD_FAILURE() << word;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_TRUE(contains(error.message(), "everyone, health, local, nobody"));
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::monitoring_test

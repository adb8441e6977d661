#include "api/door/http/metrics.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <thread>

#include "api/door/http/health.h"
#include "tests/api/door/http/served.h"

namespace slackwater::tests::metrics_test {
namespace {

using namespace slackwater::api::http;
using namespace std::chrono_literals;

bool has_line(const std::string& text, const std::string& line) {
  return ("\n" + text).find("\n" + line + "\n") != std::string::npos;
}

TEST(Metrics, CountByRouteMethodAndStatus) {
  Metrics metrics({"/a", "/b\"\\"});
  metrics.served({"/a", "GET", 200, 700us, 1000});
  metrics.served({"/a", "GET", 200, 3ms, 1000});
  metrics.served({"/a", "HEAD", 304, 20s, 10});
  metrics.served({"/unheard", "BREW", 299, 1us, 0});
  metrics.served({"/b\"\\", "GET", 404, 1us, 0});
  const std::string text = metrics.exposition();
  const std::string total = "slackwater_http_requests_total";
  EXPECT_TRUE(has_line(text, total + R"({route="/a",method="GET",status="200"} 2)")) << text;
  EXPECT_TRUE(has_line(text, total + R"({route="/a",method="HEAD",status="304"} 1)"));
  EXPECT_TRUE(has_line(text, total + R"r({route="(other)",method="(other)",status="other"} 1)r"));
  EXPECT_TRUE(has_line(text, total + R"({route="/b\"\\",method="GET",status="404"} 1)"));
  EXPECT_TRUE(has_line(text, "slackwater_http_response_bytes_total 2010"));
}

TEST(Metrics, TheHistogramIsCumulative) {
  Metrics metrics({"/a"});
  metrics.served({"/a", "GET", 200, 500us, 0});  // on the bound: inside
  metrics.served({"/a", "GET", 200, 3ms, 0});
  metrics.served({"/a", "GET", 200, 20s, 0});
  const std::string text = metrics.exposition();
  const std::string bucket = "slackwater_http_request_duration_seconds_bucket{route=\"/a\",le=";
  EXPECT_TRUE(has_line(text, bucket + "\"0.0005\"} 1")) << text;
  EXPECT_TRUE(has_line(text, bucket + "\"0.0025\"} 1"));
  EXPECT_TRUE(has_line(text, bucket + "\"0.005\"} 2"));
  EXPECT_TRUE(has_line(text, bucket + "\"10\"} 2"));
  EXPECT_TRUE(has_line(text, bucket + "\"+Inf\"} 3"));
  EXPECT_TRUE(has_line(text, "slackwater_http_request_duration_seconds_count{route=\"/a\"} 3"));
  EXPECT_TRUE(has_line(text, "slackwater_http_request_duration_seconds_sum{route=\"/a\"} 20.0035"));
}

/// The grammar of the text format, line by line: comments, or name{labels} value.
TEST(Metrics, EveryLineIsOfTheExpositionFormat) {
  Metrics metrics({"/a"});
  metrics.served({"/a", "GET", 200, 1ms, 10});
  const std::regex line_form(
      R"re((# (HELP|TYPE) [a-z_]+ .+)|([a-z_]+(\{([a-z]+="([^"\\]|\\.)*",?)+\})? [0-9.e+-]+))re");
  std::istringstream text(metrics.exposition());
  int lines = 0;
  for (std::string line; std::getline(text, line); ++lines) {
    EXPECT_TRUE(std::regex_match(line, line_form)) << line;
  }
  EXPECT_GT(lines, 30);
}

TEST(Metrics, AreServedAndCountTheServer) {
  auto metrics = std::make_shared<Metrics>(std::vector<std::string>{"/short", "/metrics"});
  Router router = example_router();
  router.add("GET", "/metrics", metrics_handler(metrics));
  ServerOptions options;
  options.metrics = metrics;
  const Served served(router, options);
  HttpClient client = served.client();
  ASSERT_TRUE(client.get("/short"));
  ASSERT_TRUE(served.client().send("GARBAGE\r\n\r\n"));
  std::string text;
  for (int i = 0; i < 100 && text.find("(refused)\",method") == std::string::npos; ++i) {
    const auto reply = client.get("/metrics");
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->field("content-type"), "text/plain; version=0.0.4; charset=utf-8");
    text = reply->body;
  }
  EXPECT_TRUE(has_line(
      text, R"(slackwater_http_requests_total{route="/short",method="GET",status="200"} 1)"));
  EXPECT_TRUE(has_line(text, "slackwater_http_connections_total 2")) << text;
  EXPECT_TRUE(has_line(text, "slackwater_http_requests_in_flight 1")) << "this very one";
  const auto resident = std::stod(text.substr(text.find("\nprocess_resident_memory_bytes ") + 31));
  EXPECT_GT(resident, 1e6);
  EXPECT_LT(resident, 1e11);
}

TEST(Metrics, GaugesAreToldApartByTheirLabel) {
  const std::string text =
      exposition({{"slackwater_age_seconds", "Since then.", "site", {{"a", 12.5}, {"b\"", 3}}},
                  {"slackwater_nothing", "Without values.", "site", {}}});
  EXPECT_TRUE(has_line(text, "# TYPE slackwater_age_seconds gauge")) << text;
  EXPECT_TRUE(has_line(text, R"(slackwater_age_seconds{site="a"} 12.5)"));
  EXPECT_TRUE(has_line(text, R"(slackwater_age_seconds{site="b\""} 3)"));
  EXPECT_EQ(text.find("nothing"), std::string::npos);
}

TEST(Health, SaysTheWordAndWhatTheRootKnows) {
  auto metrics = std::make_shared<Metrics>(std::vector<std::string>{});
  HealthFacts facts;
  facts.facts = {{"newest_forecast", "2025-03-10T00:00:00Z"}};
  facts.details["sites"].push_back({{"site", "a"}});
  const Response good = completed(health_handler("1.2.3", metrics, [&] { return facts; })({}));
  EXPECT_EQ(good.status, 200);
  const auto document = nlohmann::json::parse(good.body);
  EXPECT_EQ(document.at("status"), "ok");
  EXPECT_GE(document.at("uptime_s").get<int>(), 0);
  EXPECT_EQ(document.at("version"), "1.2.3");
  EXPECT_EQ(document.at("newest_forecast"), "2025-03-10T00:00:00Z");
  EXPECT_EQ(document.at("sites").at(0).at("site"), "a");
}

TEST(Health, OldNewsIsAFailureForMonitorsAndNoneForBalancers) {
  auto metrics = std::make_shared<Metrics>(std::vector<std::string>{});
  HealthFacts facts;
  facts.status = "stale";
  facts.is_current = false;
  const auto status = [&](Asker asker) {
    return completed(health_handler(
                         "1", metrics, [&] { return facts; }, asker)({}))
        .status;
  };
  EXPECT_EQ(status(Asker::balancer), 200);
  EXPECT_EQ(status(Asker::monitor), 503);
  facts.can_serve = false;
  EXPECT_EQ(status(Asker::balancer), 503);
  facts = {};
  EXPECT_EQ(status(Asker::monitor), 200);
}

}  // namespace
}  // namespace slackwater::tests::metrics_test

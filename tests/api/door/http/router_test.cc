#include "api/door/http/router.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::tests::router_test {
namespace {

using namespace slackwater::api::http;

Response named(std::string name) {
  Response response;
  response.body = std::move(name);
  return response;
}

Router collections() {
  Router router;
  router.add("GET", "/", [](const Request&) { return named("landing"); });
  router.add("GET", "/collections", [](const Request&) { return named("collections"); });
  router.add("GET", "/collections/{collection}",
             [](const Request&, const PathParameters& p) { return named(p.at("collection")); });
  router.add("GET", "/collections/{collection}/instances/{instance}/position",
             [](const Request&, const PathParameters& p) {
               return named(p.at("collection") + " " + p.at("instance"));
             });
  router.add("GET", "/collections/{collection}/position",
             [](const Request&) { return named("position"); });
  router.add("GET", "/collections/currents/{query}", [](const Request&, const PathParameters& p) {
    return named("only " + p.at("query"));
  });
  router.add("POST", "/collections/{collection}", [](const Request&) { return named("posted"); });
  return router;
}

Response routed(const std::string& method, const std::string& path) {
  Request request;
  request.method = method;
  request.path = path;
  return completed(collections()(request));
}

std::string detail_of(const Response& response) {
  return nlohmann::json::parse(response.body).at("detail").get<std::string>();
}

TEST(Router, SendsAPathToItsHandler) {
  EXPECT_EQ(routed("GET", "/").body, "landing");
  EXPECT_EQ(routed("GET", "").body, "landing");
  EXPECT_EQ(routed("GET", "/collections").body, "collections");
  EXPECT_EQ(routed("HEAD", "/collections").body, "collections");
  EXPECT_EQ(routed("GET", "/collections/wind").body, "wind");
  EXPECT_EQ(routed("POST", "/collections/wind").body, "posted");
  EXPECT_EQ(routed("GET", "/collections/wind/instances/2025-03-10T00:00:00Z/position").body,
            "wind 2025-03-10T00:00:00Z");
}

TEST(Router, ToleratesASlashAtTheEndButNotInTheMiddle) {
  EXPECT_EQ(routed("GET", "/collections/").body, "collections");
  EXPECT_EQ(routed("GET", "/collections//").status, 404);
  EXPECT_EQ(routed("GET", "//collections").status, 200);  // the address ended in a slash
  EXPECT_EQ(routed("GET", "/collections//position").status, 404);
}

TEST(Router, FixedSegmentsWinFromTheLeft) {
  EXPECT_EQ(routed("GET", "/collections/currents/position").body, "only position");
  EXPECT_EQ(routed("GET", "/collections/wind/position").body, "position");
}

TEST(Router, DecodesSegmentsOnceAfterSplitting) {
  EXPECT_EQ(routed("GET", "/collections/a%20b").body, "a b");
  EXPECT_EQ(routed("GET", "/collections/%2541").body, "%41");
  EXPECT_EQ(routed("GET", "/collec%74ions").body, "collections");
  for (const char* hostile :
       {"/collections/..", "/collections/%2e%2e/x", "/collections/a%2fb", "/collections/%5c",
        "/collections/%00", "/collections/%4", "/collections/%g0", "/."}) {
    EXPECT_EQ(routed("GET", hostile).status, 400) << hostile;
  }
}

TEST(Router, AMissingPathSaysWhatIsNearby) {
  const Response top = routed("GET", "/colections");
  EXPECT_EQ(top.status, 404);
  EXPECT_NE(detail_of(top).find("/, /collections."), std::string::npos) << detail_of(top);
  const Response deep = routed("GET", "/collections/wind/instances/x/cube");
  EXPECT_NE(detail_of(deep).find("/collections/{collection}/instances/{instance}/position"),
            std::string::npos)
      << detail_of(deep);
}

TEST(Router, AMethodThatIsNotServedSaysWhichAre) {
  const Response refused = routed("DELETE", "/collections/wind");
  EXPECT_EQ(refused.status, 405);
  ASSERT_FALSE(refused.headers.empty());
  EXPECT_EQ(refused.headers.front().first, "Allow");
  EXPECT_EQ(refused.headers.front().second, "GET, HEAD, POST, OPTIONS");
  EXPECT_EQ(routed("POST", "/collections").status, 405);
}

TEST(Router, ARouteThatExistsTwiceOrAParameterThatDoesNotIsABug) {
  Router router;
  router.add("GET", "/a", [](const Request&) { return named("a"); });
  EXPECT_THROW(router.add("GET", "/a", [](const Request&) { return named("b"); }),
               ContractViolation);
  EXPECT_THROW(router.add("GET", "a", [](const Request&) { return named("b"); }),
               ContractViolation);
  EXPECT_THROW((void)PathParameters().at("x"), ContractViolation);
}

TEST(Router, WhatAHandlerLeavesForLaterIsRoutedTooAndFailsAsItWouldNow) {
  Router router;
  router.add("GET", "/later",
             [](const Request&) { return LongWork{[] { return named("done"); }}; });
  router.add("GET", "/never", [](const Request&) {
    return LongWork{[]() -> Response { throw Error(ErrorKind::internal, "of the house"); }};
  });
  Request request;
  request.method = "GET";
  request.path = "/later";
  const Outcome later = router(request);
  ASSERT_TRUE(std::holds_alternative<LongWork>(later)) << "nothing is begun";
  const Response done = completed(later);
  EXPECT_EQ(done.body, "done");
  EXPECT_EQ(done.route, "/later");
  request.path = "/never";
  const Response failed = completed(router(request));
  EXPECT_EQ(failed.status, 500);
  EXPECT_EQ(failed.route, "/never");
  EXPECT_NE(failed.for_the_log.find("of the house"), std::string::npos);
}

TEST(Router, LabelsAreThePatterns) {
  const auto labels = collections().labels();
  EXPECT_EQ(labels.size(), 6U) << "GET and POST of a collection share one";
  EXPECT_EQ(routed("GET", "/collections/wind").route, "/collections/{collection}");
  EXPECT_EQ(routed("GET", "/nothing").route, "") << "no route answered";
}

}  // namespace
}  // namespace slackwater::tests::router_test

// Which host stands in the links of EDR documents, where no --base-url says it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "api/door/edr/service.h"
#include "tests/api/door/edr/made_up_store.h"
#include "tests/support/contains.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::own_host_test {
namespace {

struct OwnHost : testing::Test {
  OwnHost() {
    fill_with_made_up_forecasts(folder / "store");
    api::edr::add_routes(router, std::make_shared<api::IssuedFields>(folder / "store"));
  }
  [[nodiscard]] std::string get(const std::string& host, const std::string& path,
                                const std::string& query = "f=json") const {
    api::http::Request request;
    request.method = "GET";
    request.host = host;
    request.path = path;
    request.query = query;
    const api::http::Response answer = api::http::completed(router(request));
    EXPECT_EQ(answer.status, 200) << path;
    return answer.body;
  }
  [[nodiscard]] std::string first_link(const std::string& host) const {
    return nlohmann::json::parse(get(host, "/collections"))["links"][0]["href"];
  }

  TemporaryFolder folder;
  api::http::Router router;
};

TEST_F(OwnHost, IsRepeatedWhereItIsOfThisMachineOrInNumbers) {
  for (const std::string host : {"localhost:8080", "127.0.0.1", "192.168.1.7:8080", "[::1]:80"})
    EXPECT_EQ(first_link(host), "http://" + host + "/collections");
}

TEST_F(OwnHost, OfAStrangerIsInNoDocument) {
  for (const std::string host :
       {"evil.example", "evil.example:8080", "127.0.0.1.evil.example", "localhost.evil.example",
        "127.0.0.1:80@evil.example", "10.0.0.1/evil.example", "", "[::1]evil.example"}) {
    EXPECT_EQ(first_link(host), "/collections") << host;
    for (const char* path : {"/", "/api", "/conformance", "/collections", "/collections/currents",
                             "/collections/currents/instances", "/collections/currents/items",
                             "/collections/currents/locations"})
      for (const char* query : {"f=json", "f=html"})
        EXPECT_FALSE(contains(get(host, path, query), "evil.example")) << host << path;
  }
}

}  // namespace
}  // namespace slackwater::tests::own_host_test

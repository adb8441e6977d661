#include "tests/api/door/edr/edr_service_for_tests.h"

#include <gtest/gtest.h>

#include <limits>
#include "fields/base/encode/percent.h"

namespace slackwater::tests {
namespace {

using nlohmann::json;

std::filesystem::path filled(const std::filesystem::path& folder) {
  fill_with_made_up_forecasts(folder);
  return folder;
}

api::http::Request request_for(const std::string& path, const QueryPairs& query) {
  api::http::Request request;
  request.method = "GET";
  request.path = path;
  request.host = "edr.test";
  for (const auto& [key, value] : query) {
    request.query += (request.query.empty() ? "" : "&") + key + "=";
    request.query += percent_encoded(value);
  }
  return request;
}

}  // namespace

EdrServiceForTests::EdrServiceForTests()
    : forecasts_(
          std::make_shared<api::IssuedFields>(filled(folder_ / "store"), std::chrono::hours(1))) {
  api::edr::add_routes(router_, forecasts_, base);
}

void EdrServiceForTests::issue(const Snapshot& snapshot) {
  commit_made_up_forecast(folder_ / "store", snapshot);
  forecasts_->refresh();
}

api::http::Response EdrServiceForTests::get_raw(const std::string& path,
                                                const std::string& query) const {
  api::http::Request request;
  request.method = "GET";
  request.path = path;
  request.query = query;
  request.host = "edr.test";
  return api::http::completed(router_(request));
}

api::http::Response EdrServiceForTests::get(const std::string& path, const QueryPairs& query,
                                            const std::string& accept) const {
  api::http::Request request = request_for(path, query);
  request.accept = accept;
  return api::http::completed(router_(request));
}

bool EdrServiceForTests::takes_long(const std::string& path, const QueryPairs& query) const {
  const api::http::Outcome outcome = router_(request_for(path, query));
  const auto* response = std::get_if<api::http::Response>(&outcome);
  if (response == nullptr) return true;
  EXPECT_EQ(response->status, 200) << path;
  return false;
}

api::http::Response EdrServiceForTests::get_and_leave(const std::string& path,
                                                      const QueryPairs& query) const {
  api::http::Request request = request_for(path, query);
  std::stop_source gone;
  request.stop = gone.get_token();
  api::http::Outcome outcome = router_(request);
  gone.request_stop();
  return api::http::completed(std::move(outcome));
}

json EdrServiceForTests::document(const std::string& path, const QueryPairs& query) const {
  const api::http::Response answer = get(path, query);
  EXPECT_EQ(answer.status, 200) << path << ": " << answer.body.substr(0, 400);
  const json body = json::parse(answer.body, nullptr, false);
  EXPECT_FALSE(body.is_discarded()) << path << " is no JSON";
  return body;
}

std::string EdrServiceForTests::refusal(int status, const std::string& path,
                                        const QueryPairs& query) const {
  const api::http::Response answer = get(path, query);
  EXPECT_EQ(answer.status, status) << path << ": " << answer.body.substr(0, 400);
  EXPECT_EQ(answer.media_type, "application/problem+json") << path;
  const json body = json::parse(answer.body, nullptr, false);
  return body.is_object() ? body.value("detail", std::string()) : std::string();
}

std::shared_ptr<const Field> EdrServiceForTests::in_force(const std::string& site) const {
  for (const auto& each : forecasts_->catalogue()->sites)
    if (each.site_id == site) return each.field;
  ADD_FAILURE() << "no site " << site;
  return nullptr;
}

const EdrServiceForTests& edr_service() {
  static const EdrServiceForTests service;
  return service;
}

std::vector<double> values_of(const json& coverage, const std::string& name) {
  std::vector<double> values;
  for (const json& value : coverage.at("ranges").at(name).at("values"))
    values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                     : value.get<double>());
  return values;
}

std::size_t links_with(const json& document, const std::string& relation) {
  std::size_t count = 0;
  for (const json& link : document.at("links")) {
    EXPECT_TRUE(link.contains("rel") && link.contains("type") && link.contains("href")) << link;
    if (link.value("rel", "") == relation) ++count;
  }
  return count;
}

}  // namespace slackwater::tests

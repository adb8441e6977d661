#include "tests/api/edr/edr_service_for_tests.h"

#include <gtest/gtest.h>

#include <limits>

#include "api/edr/percent_code.h"
#include "data/store/store.h"
#include "ingest/cf/forecast_file.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::tests {
namespace {

using nlohmann::json;

Snapshot small_forecast(const std::string& site, std::size_t columns, std::uint64_t seed) {
  MadeUpForecast size;
  size.columns = columns;
  size.hours = 12;
  size.members = 3;
  size.seed = seed;
  Snapshot made = made_up_forecast(size);
  made.site_id = site;
  made.site_name = "Site " + site;
  return made;
}

Snapshot farm_forecast() {
  Snapshot made = small_forecast("farm", 12, 21);
  for (std::size_t c = 0; c < made.columns.size(); ++c) {
    made.columns[c].point = GeoPoint::from_degrees(57.20 + 0.02 * static_cast<double>(c / 4),
                                                   2.40 + 0.02 * static_cast<double>(c % 4));
  }
  return made;
}

Snapshot dateline_forecast() {
  Snapshot made = small_forecast("dateline", 2, 31);
  made.columns[0].point = GeoPoint::from_degrees(-17, 179.99);
  made.columns[1].point = GeoPoint::from_degrees(-17, -179.99);
  return made;
}

void commit(const std::filesystem::path& folder, const Snapshot& made) {
  store::Store store = store::Store::open(folder, store::OpenMode::create_or_write);
  store::NewForecast row;
  row.content_file = store.staging_folder() / "made_up.nc";
  ingest::write_forecast(row.content_file, made);
  row.row.site_id = made.site_id;
  row.row.day = made.day;
  row.row.issued = made.issued;
  row.row.valid_from = made.time.front();
  row.row.valid_to = made.time.back();
  row.row.wind_policy = made.wind_policy;
  row.row.headline = made.headline;
  row.row.summary_json = "{}";
  row.row.code_version = "test";
  store.commit_forecasts(std::span(&row, 1));
}

std::filesystem::path filled(const std::filesystem::path& folder) {
  for (const Snapshot& made :
       {lone_forecast(0, 11), lone_forecast(1, 12), farm_forecast(), dateline_forecast()})
    commit(folder, made);
  return folder;
}

}  // namespace

Snapshot lone_forecast(int days_later, std::uint64_t seed) {
  Snapshot made = small_forecast("lone", 1, seed);
  const auto later = std::chrono::days(days_later);
  made.day += later;
  made.issued += later;
  for (UtcTime& time : made.time) time += later;
  return made;
}

EdrServiceForTests::EdrServiceForTests()
    : forecasts_(
          std::make_shared<api::IssuedFields>(filled(folder_ / "store"), std::chrono::hours(1))) {
  api::edr::add_routes(router_, forecasts_, base);
}

void EdrServiceForTests::issue(const Snapshot& snapshot) {
  commit(folder_ / "store", snapshot);
  forecasts_->refresh();
}

api::http::Response EdrServiceForTests::get_raw(const std::string& path,
                                                const std::string& query) const {
  api::http::Request request;
  request.method = "GET";
  request.path = path;
  request.query = query;
  request.host = "edr.test";
  return router_(request);
}

api::http::Response EdrServiceForTests::get(const std::string& path, const QueryPairs& query,
                                            const std::string& accept) const {
  api::http::Request request;
  request.method = "GET";
  request.path = path;
  request.host = "edr.test";
  request.accept = accept;
  for (const auto& [key, value] : query) {
    request.query += (request.query.empty() ? "" : "&") + key + "=";
    request.query += api::edr::percent_encoded(value);
  }
  return router_(request);
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

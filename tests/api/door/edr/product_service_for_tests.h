#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "api/door/edr/service.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "fields/base/encode/percent.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/api/door/edr/edr_service_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests {

/// The EDR service over a store of product files that a test ingests, called without sockets.
class ProductServiceForTests {
 public:
  static constexpr const char* base = "http://edr.test";

  ProductServiceForTests() {
    static_cast<void>(open());
    forecasts_ = std::make_shared<api::IssuedFields>(store_, std::chrono::hours(1));
    api::edr::add_routes(router_, forecasts_, base);
  }

  ProductServiceForTests& with(const ProductForTests& product) {
    return with_file(
        write_product(folder_ / ("product-" + std::to_string(++files_) + ".nc"), product));
  }
  ProductServiceForTests& with_file(const std::filesystem::path& file) {
    store::Store store = open();
    const auto products = ingest::ProductCatalogue::load(source_folder() / "data/products");
    static_cast<void>(
        api::ingest_file(store, products, file, {}, parse_utc("2025-03-13T00:00:00Z"), {}));
    forecasts_->refresh();
    return *this;
  }
  ProductServiceForTests& issue(const Snapshot& snapshot) {
    commit_made_up_forecast(store_, snapshot);
    forecasts_->refresh();
    return *this;
  }

  [[nodiscard]] std::shared_ptr<const api::ForecastCatalogue> catalogue() const {
    return forecasts_->catalogue();
  }
  [[nodiscard]] const std::filesystem::path& store() const noexcept { return store_; }

  [[nodiscard]] api::http::Response get(const std::string& path,
                                        const QueryPairs& query = {}) const {
    api::http::Request request;
    request.method = "GET";
    request.path = path;
    request.host = "edr.test";
    for (const auto& [key, value] : query)
      request.query += (request.query.empty() ? "" : "&") + key + "=" + percent_encoded(value);
    return api::http::completed(router_(request));
  }
  /// Whether it is left to the threads for long work.
  [[nodiscard]] bool takes_long(const std::string& path, const std::string& query) const {
    api::http::Request request;
    request.method = "GET";
    request.path = path;
    request.query = query;
    request.host = "edr.test";
    return std::holds_alternative<api::http::LongWork>(router_(request));
  }
  /// As it stands in a document.
  [[nodiscard]] api::http::Response get_link(const std::string& href) const {
    const std::string path = href.substr(std::string(base).size());
    api::http::Request request;
    request.method = "GET";
    request.path = path.substr(0, path.find('?'));
    request.query = path.find('?') == std::string::npos ? "" : path.substr(path.find('?') + 1);
    request.host = "edr.test";
    return api::http::completed(router_(request));
  }
  /// The body of an answer that must be a 200.
  [[nodiscard]] nlohmann::json document(const std::string& path,
                                        const QueryPairs& query = {}) const {
    const api::http::Response answer = get(path, query);
    EXPECT_EQ(answer.status, 200) << path << ": " << answer.body.substr(0, 400);
    return nlohmann::json::parse(answer.body, nullptr, false);
  }
  /// The sentence of a problem document, which the answer must be, with this status.
  [[nodiscard]] std::string refusal(int status, const std::string& path,
                                    const QueryPairs& query = {}) const {
    const api::http::Response answer = get(path, query);
    EXPECT_EQ(answer.status, status) << path << ": " << answer.body.substr(0, 400);
    const auto body = nlohmann::json::parse(answer.body, nullptr, false);
    return body.is_object() ? body.value("detail", std::string()) : std::string();
  }

 private:
  [[nodiscard]] store::Store open() const {
    return store::Store::open(store_, store::OpenMode::create_or_write);
  }

  TemporaryFolder folder_;
  std::filesystem::path store_ = folder_ / "store";
  std::shared_ptr<api::IssuedFields> forecasts_;
  api::http::Router router_;
  int files_ = 0;
};

}  // namespace slackwater::tests

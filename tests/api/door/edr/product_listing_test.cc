// How the collections of stored products are listed, described and credited.
#include <algorithm>
#include <cmath>
#include <set>

#include "tests/api/door/edr/stored_products_for_tests.h"

namespace slackwater::tests::edr_products {
namespace {

TEST(EdrProductListing, AStoreWithoutProductsHasNoCollectionsOfThem) {
  const ProductServiceForTests service;
  const json all = service.document("/collections").at("collections");
  for (const json& each : all)
    EXPECT_FALSE(each.at("id").get<std::string>().starts_with("product-"));
  EXPECT_NE(service.refusal(404, currents).find("product-KIND-ID"), std::string::npos);
}

TEST(EdrProductListing, EachKindIsListedWithItsExtentAndParameters) {
  std::set<std::string> ids;
  const json all = all_kinds().document("/collections").at("collections");
  for (const json& each : all) {
    const auto id = each.at("id").get<std::string>();
    if (!id.starts_with("product-")) continue;
    ids.insert("/collections/" + id);
    EXPECT_EQ(all_kinds().document("/collections/" + id), each);
    EXPECT_EQ(each.at("extent").at("temporal").at("interval")[0],
              json::array({"2025-03-10T00:00:00Z", "2025-03-10T23:00:00Z"}));
    EXPECT_TRUE(each.at("parameter_names").contains("forecast_period"));
    EXPECT_EQ(each.at("data_queries").size(), 5U);
  }
  EXPECT_EQ(ids, (std::set<std::string>{currents, wind, waves_of(all_kinds())}));
  const json box = all_kinds().document(currents).at("extent").at("spatial").at("bbox")[0];
  EXPECT_NEAR(box[0].get<double>(), 6.25, 1e-6);
  EXPECT_NEAR(box[3].get<double>(), 54.25, 1e-6);
}

TEST(EdrProductListing, AnswersNameProductFilesAndWhomToCredit) {
  const QueryPairs query{{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T06:00:00Z"}};
  const json from =
      all_kinds().document(std::string(currents) + "/position", query).at("slackwater:provenance");
  EXPECT_EQ(from.at("product"), "NWSHELF_ANALYSISFORECAST_PHY_004_013");
  EXPECT_EQ(from.at("sources_sha256").size(), 1U);
  EXPECT_EQ(from.at("sources_sha256")[0].get<std::string>().size(), 64U);
  EXPECT_NE(from.at("attributions").dump().find("Copernicus"), std::string::npos);
  for (const char* format : {"GeoJSON", "CSV", "NetCDF"}) {
    QueryPairs asked = query;
    asked.emplace_back("f", format);
    EXPECT_EQ(all_kinds().get(std::string(currents) + "/position", asked).status, 200) << format;
  }
  QueryPairs asked = query;
  asked.emplace_back("f", "CSV");
  const auto csv = all_kinds().get(std::string(currents) + "/position", asked);
  EXPECT_NE(std::find(csv.headers.begin(), csv.headers.end(),
                      std::pair<std::string, std::string>("Slackwater-Runs", "analysis")),
            csv.headers.end());
}

TEST(EdrProductListing, FilesThatWereCutAtOtherDepthsAreTwoCollections) {
  ProductServiceForTests service;
  ProductForTests shallow = current_product(day + std::chrono::days(1));
  shallow.depth_m = {0, 5};
  service.with(current_product(day)).with(shallow);
  ASSERT_EQ(service.catalogue()->products->size(), 2U);
  for (const auto& product : *service.catalogue()->products) {
    const json answer = service.document("/collections/" + product.id + "/position",
                                         {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
    const auto east = values_of(answer, east_current);
    EXPECT_EQ(east.size(), 24U);
    EXPECT_TRUE(std::none_of(east.begin(), east.end(), [](double v) { return std::isnan(v); }));
  }
}

TEST(EdrProductListing, ANewlyIngestedFileIsNoticed) {
  ProductServiceForTests service;
  service.with(current_product(day));
  EXPECT_EQ(service.catalogue()->products->size(), 1U);
  service.with(current_product(day + std::chrono::days(1))).with(wind_product(day));
  EXPECT_EQ(service.catalogue()->products->size(), 2U);
  const json answer = service.document(std::string(currents) + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_EQ(values_of(answer, east_current).size(), 48U);
}

TEST(EdrProductListing, LocationsAreTheColumnsOfSitesThatTheProductCovers) {
  ProductServiceForTests service;
  service.with(current_product(day));
  service.issue(forecast_at("here", 54, 6.5)).issue(forecast_at("elsewhere", 48, -2));
  const json features = service.document(std::string(currents) + "/locations").at("features");
  ASSERT_EQ(features.size(), 1U);
  EXPECT_EQ(features[0].at("id"), "here");
  const json& csv = features[0].at("links")[0];
  EXPECT_NE(csv.at("href").get<std::string>().find("datetime="), std::string::npos)
      << "an archive of years does not fit";
  EXPECT_EQ(service.get_link(csv.at("href")).status, 200);
  const json at_site = service.document(std::string(currents) + "/locations/here", {{"z", "5"}});
  const json at_point = service.document(std::string(currents) + "/position",
                                         {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_EQ(values_of(at_site, east_current), values_of(at_point, east_current));
  EXPECT_EQ(service.get(std::string(currents) + "/locations/nowhere").status, 404);
  EXPECT_EQ(service.get(std::string(currents) + "/locations/elsewhere").status, 404);
}

TEST(EdrProductListing, EveryExampleIsAnswered) {
  ProductServiceForTests service;
  service.with(current_product(day)).with(wind_product(day)).with(wave_product(day));
  service.with(monthly_means());
  service.issue(forecast_at("here", 54, 6.5));
  ASSERT_EQ(service.catalogue()->products->size(), 4U);
  for (const auto& product : *service.catalogue()->products) {
    const json queries = service.document("/collections/" + product.id).at("data_queries");
    std::size_t tried = 0;
    for (const auto& [name, query] : queries.items()) {
      const json& link = query.at("link");
      if (!link.contains("slackwater:example")) continue;
      const auto answer = service.get_link(link.at("slackwater:example"));
      EXPECT_EQ(answer.status, 200) << product.id << " " << name << answer.body.substr(0, 300);
      ++tried;
    }
    EXPECT_EQ(tried, 4U);
  }
}

TEST(EdrProductListing, TheInterfaceNamesThemWhereTheyAreAnswered) {
  const std::string id = std::string(currents).substr(13);
  const json definition = all_kinds().document("/api");
  for (const auto& [path, operations] : definition.at("paths").items()) {
    if (path.find("{collectionId}") == std::string::npos) continue;
    const json& reference = operations.at("get").at("parameters")[0].at("$ref");
    const json& parameter =
        definition.at(json::json_pointer(reference.get<std::string>().substr(1)));
    EXPECT_EQ(parameter.at("name"), "collectionId") << path;
    std::string own = path;
    own.replace(own.find("{collectionId}"), 14, id);
    const bool is_answered =
        own.find("instance") == std::string::npos &&
        (own.ends_with("/locations/{locationId}") || all_kinds().get(own).status != 404);
    EXPECT_EQ(parameter.at("schema").at("enum").dump().find(id) != std::string::npos, is_answered)
        << path;
  }
}

TEST(EdrProductListing, ThePagesAndTheInterfaceNameThem) {
  const std::string id = std::string(currents).substr(13);
  EXPECT_NE(all_kinds().get("/collections", {{"f", "HTML"}}).body.find(id), std::string::npos);
  EXPECT_NE(all_kinds().get(currents, {{"f", "HTML"}}).body.find("forecast_period"),
            std::string::npos);
  EXPECT_NE(all_kinds().get("/api", {{"f", "JSON"}}).body.find("\"" + id + "\""),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::edr_products

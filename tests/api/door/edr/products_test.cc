// The collections of stored products: their own values, their own times, levels and cells.
#include <cmath>
#include <fstream>
#include <set>

#include "data/store/layout.h"
#include "ingest/netcdf/file.h"
#include "tests/api/door/edr/product_service_for_tests.h"
#include "tests/support/made_up_forecast.h"

namespace slackwater::tests::edr_products_test {
namespace {

using nlohmann::json;

const UtcDay day = parse_day("2025-03-10");
const UtcTime midnight(day);
constexpr const char* currents =
    "/collections/product-currents-NWSHELF_ANALYSISFORECAST_PHY_004_013";
constexpr const char* wind = "/collections/product-wind-WIND_GLO_PHY_L4_NRT_012_004";
/// Values stand in files as float, and in answers with six digits.
constexpr double rounding = 5e-6;

std::string waves_of(const ProductServiceForTests& service) {
  for (const auto& product : *service.catalogue()->products)
    if (product.kind == api::ProductKind::waves) return "/collections/" + product.id;
  return "none";
}

const ProductServiceForTests& all_kinds() {
  static ProductServiceForTests service;
  static const bool is_filled = [] {
    service.with(current_product(day)).with(wind_product(day)).with(wave_product(day));
    return true;
  }();
  static_cast<void>(is_filled);
  return service;
}

ProductForTests forecast_of(UtcDay first, UtcTime run, double eastward_m_s) {
  ProductForTests product = current_product(first);
  product.reference_time = run;
  product.quantity("uo").value = [=](const ProductCell& cell) {
    return cell.longitude_deg > WaterForTests::land_east_of_deg ? std::nan("") : eastward_m_s;
  };
  return product;
}

Snapshot forecast_at(const std::string& site, double latitude_deg, double longitude_deg) {
  MadeUpForecast size;
  size.hours = 6;
  size.members = 2;
  Snapshot made = made_up_forecast(size);
  made.site_id = site;
  made.columns.front().point = GeoPoint::from_degrees(latitude_deg, longitude_deg);
  return made;
}

std::string notes_of(const json& answer) {
  return answer.at("slackwater:provenance").at("notes").dump();
}

TEST(EdrProducts, AStoreWithoutProductsHasNoCollectionsOfThem) {
  const ProductServiceForTests service;
  const json all = service.document("/collections").at("collections");
  for (const json& each : all)
    EXPECT_FALSE(each.at("id").get<std::string>().starts_with("product-"));
  EXPECT_NE(service.refusal(404, currents).find("see /collections"), std::string::npos);
}

TEST(EdrProducts, EachKindIsListedWithItsExtentAndParameters) {
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

TEST(EdrProducts, ValuesAtCellsAreTheFilesOwn) {
  const json answer = all_kinds().document(
      std::string(currents) + "/area",
      {{"coords", "POLYGON((6.35 53.85,6.65 53.85,6.65 54.15,6.35 54.15,6.35 53.85))"}});
  const json& axes = answer.at("domain").at("axes");
  ASSERT_EQ(axes.at("x").at("values").size(), 3U);
  ASSERT_EQ(axes.at("y").at("values").size(), 3U);
  ASSERT_EQ(axes.at("z").at("values"), json::array({0.0, 5.0, 10.0, 20.0, 30.0}));
  ASSERT_EQ(axes.at("t").at("values").size(), 24U);
  const auto east = values_of(answer, east_current);
  const auto north = values_of(answer, north_current);
  std::size_t i = 0;
  for (int t = 0; t < 24; ++t) {
    for (const double depth : {0.0, 5.0, 10.0, 20.0, 30.0}) {
      for (const double y : {53.9, 54.0, 54.1}) {
        for (const double x : {6.4, 6.5, 6.6}) {
          const ProductCell cell{midnight + std::chrono::hours(t), depth, y, x};
          ASSERT_NEAR(east[i], WaterForTests::eastward_m_s(cell), rounding) << i;
          ASSERT_NEAR(north[i], WaterForTests::northward_m_s(cell), rounding) << i;
          ++i;
        }
      }
    }
  }
  EXPECT_EQ(i, east.size());
}

TEST(EdrProducts, WindAndWavesAreTheFilesOwnToo) {
  const QueryPairs query{{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T06:00:00Z"}};
  const ProductCell cell{midnight + std::chrono::hours(6), 0, 54, 6.5};
  const json air = all_kinds().document(std::string(wind) + "/position", query);
  const double u = WaterForTests::eastward_wind_m_s(cell);
  const double v = WaterForTests::northward_wind_m_s(cell);
  EXPECT_NEAR(values_of(air, "eastward_wind").front(), u, 5e-5);
  EXPECT_NEAR(values_of(air, "wind_speed").front(), std::hypot(u, v), 5e-5);
  const double from_deg = std::atan2(-u, -v) * 180 / std::acos(-1.0);
  EXPECT_NEAR(std::remainder(values_of(air, "wind_from_direction").front() - from_deg, 360), 0,
              1e-3);
  const json sea = all_kinds().document(waves_of(all_kinds()) + "/position", query);
  EXPECT_NEAR(values_of(sea, "sea_surface_wave_significant_height").front(),
              WaterForTests::significant_height_m(cell), 1e-3);  // packed
}

TEST(EdrProducts, APlaceBetweenCellsAndLevelsIsInterpolatedAndOneTimeIsNot) {
  const json answer = all_kinds().document(
      std::string(currents) + "/position",
      {{"coords", "POINT(6.5 54.05)"}, {"z", "7.5"}, {"datetime", "2025-03-10T06:20:00Z"}});
  EXPECT_EQ(answer.at("domain").at("axes").at("t").at("values"),
            json::array({"2025-03-10T06:00:00Z"}));
  EXPECT_NE(notes_of(answer).find("the nearest"), std::string::npos);
  double mean = 0;
  for (const double depth : {5.0, 10.0})
    for (const double y : {54.0, 54.1})
      mean += WaterForTests::eastward_m_s({midnight + std::chrono::hours(6), depth, y, 6.5}) / 4;
  EXPECT_NEAR(values_of(answer, east_current).front(), mean, rounding);
}

TEST(EdrProducts, OneInstantIsTheSeriesThere) {
  const std::string path = std::string(currents) + "/position";
  const json series = all_kinds().document(path, {{"coords", "POINT(6.47 53.97)"}, {"z", "5"}});
  const json instant = all_kinds().document(
      path, {{"coords", "POINT(6.47 53.97)"}, {"z", "5"}, {"datetime", "2025-03-10T11:00:00Z"}});
  EXPECT_EQ(values_of(series, east_current).at(11), values_of(instant, east_current).front());
}

TEST(EdrProducts, LandIsRefusedAtAPointAndNullInAnArea) {
  EXPECT_NE(all_kinds()
                .refusal(404, std::string(currents) + "/position", {{"coords", "POINT(6.7 54)"}})
                .find("on land"),
            std::string::npos);
  const json answer = all_kinds().document(
      std::string(currents) + "/cube",
      {{"bbox", "6.55,53.95,6.75,54.05"}, {"z", "0"}, {"datetime", "2025-03-10T06:00:00Z"}});
  const auto east = values_of(answer, east_current);
  ASSERT_EQ(east.size(), 2U);
  EXPECT_FALSE(std::isnan(east[0]));
  EXPECT_TRUE(std::isnan(east[1]));
  EXPECT_NE(notes_of(answer).find("land"), std::string::npos);
}

TEST(EdrProducts, OutsideIsRefusedWithWhatIsHeld) {
  const std::string path = std::string(currents) + "/position";
  const char* held = "6.25 E to 6.75 E, 53.75 N to 54.25 N, 2025-03-10T00:00:00Z";
  for (const QueryPairs& query :
       {QueryPairs{{"coords", "POINT(9 54)"}},
        QueryPairs{{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-12T00:00:00Z"}},
        QueryPairs{{"coords", "POINT(6.5 54)"},
                   {"datetime", "2025-03-10T06:10:00Z/2025-03-10T06:20:00Z"}}})
    EXPECT_NE(all_kinds().refusal(404, path, query).find(held), std::string::npos);
  EXPECT_NE(all_kinds()
                .refusal(404, path, {{"coords", "POINT(6.5 54)"}, {"z", "400"}})
                .find("depth 0 to 30 m"),
            std::string::npos);
  EXPECT_NE(
      all_kinds()
          .refusal(404, std::string(currents) + "/area", {{"coords", "POLYGON((1 1,2 1,2 2,1 1))"}})
          .find(held),
      std::string::npos);
}

TEST(EdrProducts, BadInputGetsOneClearProblem) {
  const std::string path = std::string(currents) + "/position";
  const auto refused = [&](const QueryPairs& query) {
    return all_kinds().refusal(400, path, query);
  };
  EXPECT_NE(refused({}).find("coords"), std::string::npos);
  EXPECT_NE(refused({{"coords", "POINT(x)"}}).find("coords"), std::string::npos);
  EXPECT_NE(refused({{"coords", "POINT(6.5 54)"}, {"datetime", "noon"}}).find("datetime"),
            std::string::npos);
  EXPECT_NE(refused({{"coords", "POINT(6.5 54)"}, {"parameter-name", "salt"}}).find("salt"),
            std::string::npos);
  EXPECT_NE(refused({{"coords", "POINT(6.5 54)"}, {"depth", "5"}}).find("depth"),
            std::string::npos);
  EXPECT_NE(all_kinds()
                .refusal(400, waves_of(all_kinds()) + "/position",
                         {{"coords", "POINT(6.5 54)"}, {"z", "5"}})
                .find("no vertical"),
            std::string::npos);
  EXPECT_NE(all_kinds()
                .refusal(404, std::string(currents) + "/trajectory",
                         {{"coords", "LINESTRING(6.4 54,6.5 54)"}})
                .find("position"),
            std::string::npos);
  EXPECT_NE(all_kinds().refusal(404, std::string(currents) + "/instances").find("forecast_period"),
            std::string::npos);
}

TEST(EdrProducts, AnalysesAndRunsAreToldApart) {
  ProductServiceForTests service;
  service.with(current_product(day));
  service.with(forecast_of(day + std::chrono::days(1), midnight, 0.11));
  service.with(forecast_of(day + std::chrono::days(1), midnight + std::chrono::hours(12), 0.22));
  const json answer = service.document(std::string(currents) + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  const auto period = values_of(answer, "forecast_period");
  const auto east = values_of(answer, east_current);
  ASSERT_EQ(period.size(), 48U);
  EXPECT_EQ(period[23], 0) << "analysed";
  EXPECT_EQ(period[24], 12) << "of the newer run";
  EXPECT_EQ(period[47], 35);
  EXPECT_NEAR(east[30], 0.22, rounding);
  EXPECT_EQ(answer.at("slackwater:provenance").at("runs"),
            json::array({"analysis", "forecast of 2025-03-10T12:00:00Z"}));
}

TEST(EdrProducts, AnswersNameProductFilesAndWhomToCredit) {
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

TEST(EdrProducts, MeansSaySo) {
  ProductServiceForTests service;
  service.with(mean_current_product(day, 2, 24));
  const std::string id = service.catalogue()->products->front().id;
  const json answer = service.document("/collections/" + id + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "0"}});
  EXPECT_EQ(answer.at("domain").at("axes").at("t").at("values"),
            json::array({"2025-03-10T12:00:00Z", "2025-03-11T12:00:00Z"}));
  EXPECT_NE(notes_of(answer).find("means over 24 h"), std::string::npos);
}

TEST(EdrProducts, ANewlyIngestedFileIsNoticed) {
  ProductServiceForTests service;
  service.with(current_product(day));
  EXPECT_EQ(service.catalogue()->products->size(), 1U);
  service.with(current_product(day + std::chrono::days(1))).with(wind_product(day));
  EXPECT_EQ(service.catalogue()->products->size(), 2U);
  const json answer = service.document(std::string(currents) + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_EQ(values_of(answer, east_current).size(), 48U);
}

TEST(EdrProducts, LocationsAreTheColumnsOfSitesThatTheProductCovers) {
  ProductServiceForTests service;
  service.with(current_product(day));
  service.issue(forecast_at("here", 54, 6.5)).issue(forecast_at("elsewhere", 48, -2));
  const json features = service.document(std::string(currents) + "/locations").at("features");
  ASSERT_EQ(features.size(), 1U);
  EXPECT_EQ(features[0].at("id"), "here");
  const json at_site = service.document(std::string(currents) + "/locations/here", {{"z", "5"}});
  const json at_point = service.document(std::string(currents) + "/position",
                                         {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_EQ(values_of(at_site, east_current), values_of(at_point, east_current));
  EXPECT_EQ(service.get(std::string(currents) + "/locations/nowhere").status, 404);
  EXPECT_EQ(service.get(std::string(currents) + "/locations/elsewhere").status, 404);
}

TEST(EdrProducts, LevelsBelowTheBedAreNotShownButWhereTheyAreAskedFor) {
  ProductServiceForTests service;
  ProductForTests shoal = current_product(day);
  for (const char* name : {"uo", "vo"}) {
    shoal.quantity(name).value = [own = shoal.quantity(name).value](const ProductCell& cell) {
      return cell.depth_m > 15 ? std::nan("") : own(cell);
    };
  }
  service.with(shoal);
  const std::string path = std::string(currents) + "/position";
  const json native = service.document(path, {{"coords", "POINT(6.5 54)"}});
  EXPECT_EQ(native.at("domain").at("axes").at("z").at("values"), json::array({0.0, 5.0, 10.0}));
  EXPECT_EQ(notes_of(native), "[]");
  const json asked = service.document(path, {{"coords", "POINT(6.5 54)"}, {"z", "10,20"}});
  EXPECT_TRUE(std::isnan(values_of(asked, east_current).at(1)));
  EXPECT_NE(notes_of(asked).find("below"), std::string::npos);
}

TEST(EdrProducts, EveryExampleIsAnswered) {
  ProductServiceForTests service;
  service.with(current_product(day)).with(wind_product(day)).with(wave_product(day));
  service.issue(forecast_at("here", 54, 6.5));
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

TEST(EdrProducts, ThePagesAndTheInterfaceNameThem) {
  const std::string id = std::string(currents).substr(13);
  EXPECT_NE(all_kinds().get("/collections", {{"f", "HTML"}}).body.find(id), std::string::npos);
  EXPECT_NE(all_kinds().get(currents, {{"f", "HTML"}}).body.find("forecast_period"),
            std::string::npos);
  EXPECT_NE(all_kinds().get("/api", {{"f", "JSON"}}).body.find("\"" + id + "\""),
            std::string::npos);
}

TEST(EdrProducts, ADamagedFileIsNeverOpened) {
  ProductServiceForTests service;
  service.with(current_product(day)).with(current_product(day + std::chrono::days(1)));
  const auto& granules = service.catalogue()->products->front().granules;
  ASSERT_EQ(granules.size(), 2U);
  std::ofstream(store::content_file(service.store(), granules.back().content_sha256), std::ios::app)
      << "x";
  const std::string path = std::string(currents) + "/position";
  const json answer = service.document(path, {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_EQ(values_of(answer, east_current).size(), 24U);
  EXPECT_NE(notes_of(answer).find("damaged"), std::string::npos);
  std::ofstream(store::content_file(service.store(), granules.front().content_sha256),
                std::ios::app)
      << "x";
  const std::string refused = service.refusal(503, path, {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  EXPECT_NE(refused.find("store check"), std::string::npos);
  EXPECT_EQ(refused.find(service.store().string()), std::string::npos);
}

TEST(EdrProducts, TooMuchIsRefusedBeforeItIsRead) {
  EXPECT_NE(all_kinds()
                .refusal(400, std::string(currents) + "/cube",
                         {{"bbox", "6.3,53.8,6.7,54.2"},
                          {"z", "0/30"},
                          {"resolution-x", "200"},
                          {"resolution-y", "200"}})
                .find("at most 2000000 values"),
            std::string::npos);
}

TEST(EdrProducts, AllOfItIsLongWorkForItReadsFiles) {
  EXPECT_TRUE(all_kinds().takes_long(std::string(currents) + "/position",
                                     "coords=POINT(6.5%2054)&z=5&datetime=2025-03-10T06:00:00Z"));
}

TEST(EdrProducts, TheAntimeridianIsNoBorder) {
  ProductServiceForTests service;
  ProductForTests product = wind_product(day, 3);
  product.longitude_deg = {179.8, 179.9, 180, 180.1, 180.2};
  product.latitude_deg = {-17.1, -17, -16.9};
  product.quantity("eastward_wind").value = [](const ProductCell& cell) {
    return cell.longitude_deg - 175;
  };
  service.with(product);
  const std::string instant = "2025-03-10T01:00:00Z";
  for (const char* coords : {"POINT(-179.9 -17)", "POINT(180.1 -17)"}) {
    const json answer = service.document(std::string(wind) + "/position",
                                         {{"coords", coords}, {"datetime", instant}});
    EXPECT_NEAR(values_of(answer, "eastward_wind").front(), 5.1, 1e-4) << coords;
  }
  const json across = service.document(
      std::string(wind) + "/cube",
      {{"bbox", "179.85,-17.05,-179.85,-16.95"}, {"z", "10"}, {"datetime", instant}});
  const auto east = values_of(across, "eastward_wind");
  ASSERT_EQ(east.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(east[i], 4.9 + 0.1 * static_cast<double>(i), 1e-4);
}

TEST(EdrProducts, WhatIsReadInPartsIsTheSame) {
  ProductServiceForTests service;
  ProductForTests product = wind_product(day, 90);  // 90 x 230 x 230: read in two parts
  product.longitude_deg.clear();
  product.latitude_deg.clear();
  for (int i = 0; i < 230; ++i) {
    product.longitude_deg.push_back(5 + 0.01 * i);
    product.latitude_deg.push_back(53 + 0.01 * i);
  }
  const auto hour_of = [](const ProductCell& cell) { return hours_between(midnight, cell.time); };
  product.quantity("eastward_wind").value = hour_of;
  product.quantity("northward_wind").value = [](const ProductCell& cell) {
    return cell.latitude_deg - 50;
  };
  service.with(product);
  const json answer = service.document(
      std::string(wind) + "/cube",
      {{"bbox", "5,53,7.29,55.29"}, {"z", "10"}, {"resolution-x", "2"}, {"resolution-y", "2"}});
  const auto east = values_of(answer, "eastward_wind");
  const auto north = values_of(answer, "northward_wind");
  ASSERT_EQ(east.size(), 360U);
  for (std::size_t i = 0; i < east.size(); ++i) {
    EXPECT_NEAR(east[i], static_cast<double>(i / 4), 1e-4) << i;
    EXPECT_NEAR(north[i], i % 4 < 2 ? 3 : 5.29, 1e-4) << i;
  }
}

/// Each value of a variable of time, latitude and longitude that stands in the file, by place.
void expect_own_values(const ingest::netcdf::File& file, const char* variable, const json& answer,
                       const std::string& parameter, std::size_t time) {
  const auto latitudes = file.read_all(*file.find("latitude"));
  const auto longitudes = file.read_all(*file.find("longitude"));
  const auto all = file.read_all(*file.find(variable));
  const auto values = values_of(answer, parameter);
  const json& axes = answer.at("domain").at("axes");
  std::size_t compared = 0;
  for (std::size_t n = 0; n < values.size(); ++n) {
    const std::size_t columns = axes.at("x").at("values").size();
    const double x = axes.at("x").at("values")[n % columns].get<double>();
    const double y = axes.at("y").at("values")[n / columns].get<double>();
    for (std::size_t j = 0; j < latitudes.size(); ++j) {
      for (std::size_t i = 0; i < longitudes.size(); ++i) {
        if (std::abs(latitudes[j] - y) > 1e-5 || std::abs(longitudes[i] - x) > 1e-5) continue;
        const double own = all[(time * latitudes.size() + j) * longitudes.size() + i];
        ASSERT_EQ(std::isnan(own), std::isnan(values[n])) << parameter << " " << x << " " << y;
        if (std::isnan(own)) continue;
        EXPECT_NEAR(values[n], own, 1e-5 * std::max(1.0, std::abs(own))) << x << " " << y;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 10U) << variable;
}

TEST(EdrProducts, RealProductsAreServedAsTheyAre) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto path = shared / "data/arkona_2023-07/reduced_testdata_weather.nc";
  ProductServiceForTests service;
  service.with_file(path);
  EXPECT_EQ(service.catalogue()->products->size(), 3U);
  const auto file = ingest::netcdf::File::open(path);
  const QueryPairs query{
      {"bbox", "13,54,14.1,55.1"}, {"z", "0/1"}, {"datetime", "2023-07-20T13:00:00Z"}};
  const json sea = service.document("/collections/product-waves-CMEMS_GFS_MIX/cube", query);
  expect_own_values(file, "VHM0", sea, "sea_surface_wave_significant_height", 1);
  expect_own_values(file, "VMDR", sea, "sea_surface_wave_from_direction", 1);
  const json water = service.document("/collections/product-currents-CMEMS_GFS_MIX/cube", query);
  expect_own_values(file, "utotal", water, east_current, 1);
  expect_own_values(file, "vtotal", water, north_current, 1);
  EXPECT_NE(notes_of(water).find("Stokes"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::tests::edr_products_test

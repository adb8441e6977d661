// The collections of stored products: their own values, their own times, levels and cells.
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <set>
#include <tuple>

#include "api/issued/product_values.h"
#include "data/store/layout.h"
#include "fields/base/error.h"
#include "ingest/grib/grib_writer.h"
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
/// Values stand in files as float, and in answers with six digits: half of the sixth, and a little
/// for float, of values below 10 and of values below 100.
constexpr double rounding = 6e-6;
constexpr double rounding_of_tens = 6e-5;

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

/// Of January, February and March.
ProductForTests monthly_means() {
  ProductForTests product = current_product(day);
  product.global = {{"source", "cmems_mod_nws_phy-cur_anfc_1.5km_P1M-m"}};
  product.depth_m = {0, 5};
  product.time = {parse_utc("2025-01-16T12:00:00Z"), parse_utc("2025-02-15T00:00:00Z"),
                  parse_utc("2025-03-16T12:00:00Z")};
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

std::string refusal_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.message();
  }
  return "none";
}

std::string notes_of(const json& answer) {
  return answer.at("slackwater:provenance").at("notes").dump();
}

TEST(EdrProducts, AStoreWithoutProductsHasNoCollectionsOfThem) {
  const ProductServiceForTests service;
  const json all = service.document("/collections").at("collections");
  for (const json& each : all)
    EXPECT_FALSE(each.at("id").get<std::string>().starts_with("product-"));
  EXPECT_NE(service.refusal(404, currents).find("product-KIND-ID"), std::string::npos);
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
  EXPECT_NEAR(values_of(air, "eastward_wind").front(), u, rounding_of_tens);
  EXPECT_NEAR(values_of(air, "wind_speed").front(), std::hypot(u, v), rounding_of_tens);
  const double from_deg = std::atan2(-u, -v) * 180 / std::acos(-1.0);
  EXPECT_NEAR(std::remainder(values_of(air, "wind_from_direction").front() - from_deg, 360), 0,
              1e-3);
  const json sea = all_kinds().document(waves_of(all_kinds()) + "/position", query);
  EXPECT_NEAR(values_of(sea, "sea_surface_wave_significant_height").front(),
              WaterForTests::significant_height_m(cell), 1e-3);  // packed
}

// Two runs: what stands beside the wave height is of the run that gives it.
TEST(EdrProducts, WindSeaAndSwellApartAreOfTheRunThatGivesTheHeight) {
  ProductServiceForTests service;
  const auto run_with = [](UtcTime run, double swell_m, double from_deg) {
    ProductForTests product = wave_product(day);
    product.reference_time = run;
    product.quantities.push_back({"VHM0_SW1", "sea_surface_primary_swell_wave_significant_height",
                                  "m", false, [=](const ProductCell&) { return swell_m; }});
    product.quantities.push_back({"VMDR_WW", "sea_surface_wind_wave_from_direction", "degree",
                                  false, [=](const ProductCell&) { return from_deg; }});
    return product;
  };
  service.with(run_with(midnight - std::chrono::hours(12), 0.5, 350))
      .with(run_with(midnight, 0.75, 10));
  const json answer =
      service.document(waves_of(service) + "/position",
                       {{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T06:00:00Z"}});
  const char* swell = "sea_surface_primary_swell_wave_significant_height";
  EXPECT_NEAR(values_of(answer, swell).front(), 0.75, rounding);
  EXPECT_NEAR(values_of(answer, "sea_surface_wind_wave_from_direction").front(), 10, 1e-3);
  EXPECT_EQ(values_of(answer, "forecast_period").front(), 6);
  EXPECT_EQ(answer.at("parameters").at(swell).at("unit").at("symbol").at("value"), "m");
  EXPECT_FALSE(answer.at("parameters").contains("sea_surface_wind_wave_mean_period"))
      << "the product has none";
  const json alone = service.document(
      waves_of(service) + "/position",
      {{"coords", "POINT(6.5 54)"}, {"parameter-name", swell}, {"datetime", "2025-03-10"}});
  EXPECT_EQ(alone.at("ranges").size(), 1U);
}

TEST(EdrProducts, GustsStandBesideTheWindAndNotInItsPlace) {
  ProductServiceForTests service;
  ProductForTests product = wind_product(day);
  product.quantities.push_back(
      {"gust", "wind_speed_of_gust", "m s-1", false, [](const ProductCell&) { return 17.5; }});
  service.with(product);
  const QueryPairs query{{"coords", "POINT(6.5 54)"}, {"datetime", "2025-03-10T06:00:00Z"}};
  const json answer = service.document(std::string(wind) + "/position", query);
  EXPECT_NEAR(values_of(answer, "wind_speed_of_gust").front(), 17.5, rounding_of_tens);
  const ProductCell cell{midnight + std::chrono::hours(6), 0, 54, 6.5};
  EXPECT_NEAR(values_of(answer, "eastward_wind").front(), WaterForTests::eastward_wind_m_s(cell),
              rounding_of_tens);
  EXPECT_FALSE(all_kinds()
                   .document(std::string(wind) + "/position", query)
                   .at("parameters")
                   .contains("wind_speed_of_gust"));
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
                .find("6.70000 54.00000 on land"),
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
  for (const char* none : {"/instances", "/items"}) {
    const std::string refused = all_kinds().refusal(404, std::string(currents) + none);
    EXPECT_NE(refused.find("forecast_period"), std::string::npos) << refused;
    EXPECT_NE(refused.find("position, radius, area, cube or locations"), std::string::npos);
  }
}

TEST(EdrProducts, AnalysesAndRunsAreToldApart) {
  ProductServiceForTests service;
  service.with(current_product(day));
  service.with(forecast_of(day, midnight - std::chrono::hours(12), 0.33));  // its time is analysed
  service.with(forecast_of(day + std::chrono::days(1), midnight, 0.11));
  service.with(forecast_of(day + std::chrono::days(1), midnight + std::chrono::hours(12), 0.22));
  const json answer = service.document(std::string(currents) + "/position",
                                       {{"coords", "POINT(6.5 54)"}, {"z", "5"}});
  const auto period = values_of(answer, "forecast_period");
  const auto east = values_of(answer, east_current);
  ASSERT_EQ(period.size(), 48U);
  for (int hour = 0; hour < 24; ++hour) {
    EXPECT_EQ(period[hour], 0) << "analysed";
    EXPECT_NEAR(east[hour],
                WaterForTests::eastward_m_s({midnight + std::chrono::hours(hour), 5, 54, 6.5}),
                rounding);
  }
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

TEST(EdrProducts, AMeanAnswersForAllOfItsTime) {
  ProductServiceForTests service;
  service.with(monthly_means());
  const std::string path =
      "/collections/" + service.catalogue()->products->front().id + "/position";
  const auto times_of = [&](const std::string& datetime) {
    return service.document(path, {{"coords", "POINT(6.5 54)"}, {"z", "0"}, {"datetime", datetime}})
        .at("domain")
        .at("axes")
        .at("t")
        .at("values");
  };
  const json january = json::array({"2025-01-16T12:00:00Z"});
  const json february = json::array({"2025-02-15T00:00:00Z"});
  EXPECT_EQ(times_of("2025-01-01T00:00:00Z"), january);
  EXPECT_EQ(times_of("2025-01-31T23:00:00Z"), january);
  EXPECT_EQ(times_of("2025-02-01T00:00:00Z"), february) << "of two that meet the later";
  EXPECT_EQ(times_of("2025-02-02T00:00:00Z/2025-02-03T00:00:00Z"), february);
  EXPECT_EQ(times_of("2025-02-01T00:00:00Z/2025-03-01T00:00:00Z"), february);
  EXPECT_EQ(times_of("2025-01-31T00:00:00Z/2025-02-02T00:00:00Z"),
            json::array({january[0], february[0]}));
}

TEST(EdrProducts, InAGapNothingIsMadeUp) {
  ProductServiceForTests service;
  ProductForTests product = current_product(day, 48);
  product.time.erase(product.time.begin() + 3, product.time.begin() + 23);
  service.with(product);
  const std::string path = std::string(currents) + "/position";
  const auto at = [](const char* datetime) {
    return QueryPairs{{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", datetime}};
  };
  for (const char* datetime : {"2025-03-10T02:10:00Z", "2025-03-10T12:00:00Z"}) {
    const std::string refused = service.refusal(404, path, at(datetime));
    EXPECT_NE(refused.find("after 2025-03-10T02:00:00Z and before 2025-03-10T23:00:00Z"),
              std::string::npos)
        << refused;
  }
  EXPECT_EQ(service.get(path, at("2025-03-10T02:00:00Z")).status, 200);
  EXPECT_EQ(service.get(path, at("2025-03-10T23:20:00Z")).status, 200);
}

TEST(EdrProducts, DailyInstantsHangTogetherThoughEachHasItsFile) {
  ProductServiceForTests service;
  for (const int i : {0, 1, 2, 3, 4, 9, 10, 11})
    service.with(current_product(day + std::chrono::days(i), 1));
  const std::string path = std::string(currents) + "/position";
  const auto at = [](const char* datetime) {
    return QueryPairs{{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", datetime}};
  };
  for (const auto& [asked, given] : {std::pair{"2025-03-12T07:00:00Z", "2025-03-12T00:00:00Z"},
                                     std::pair{"2025-03-12T17:00:00Z", "2025-03-13T00:00:00Z"},
                                     std::pair{"2025-03-10T01:00:00Z", "2025-03-10T00:00:00Z"},
                                     std::pair{"2025-03-20T23:00:00Z", "2025-03-21T00:00:00Z"}}) {
    const json answer = service.document(path, at(asked));
    EXPECT_EQ(answer.at("domain").at("axes").at("t").at("values"), json::array({given})) << asked;
    EXPECT_NE(notes_of(answer).find("between the product's times"), std::string::npos);
  }
  for (const char* asked : {"2025-03-14T03:00:00Z", "2025-03-18T20:00:00Z"}) {
    EXPECT_NE(service.refusal(404, path, at(asked))
                  .find("after 2025-03-14T00:00:00Z and before 2025-03-19T00:00:00Z"),
              std::string::npos)
        << asked;
  }
}

TEST(EdrProducts, ADamagedDayHasNoValuesOfTheNext) {
  ProductServiceForTests service;
  for (int i = 0; i < 3; ++i) service.with(current_product(day + std::chrono::days(i)));
  for (const auto& row : service.catalogue()->products->front().granules) {
    if (*row.first_time != midnight + std::chrono::days(1)) continue;
    std::ofstream(store::content_file(service.store(), row.content_sha256), std::ios::app) << "x";
  }
  const std::string refused = service.refusal(
      404, std::string(currents) + "/position",
      {{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"datetime", "2025-03-11T13:00:00Z"}});
  EXPECT_NE(refused.find("after 2025-03-10T23:00:00Z and before 2025-03-12T00:00:00Z"),
            std::string::npos)
      << refused;
  EXPECT_NE(refused.find("1 stored file, damaged"), std::string::npos) << refused;
}

TEST(EdrProducts, OfAnEnsembleTheMeanIsGivenAndSaysSo) {
  constexpr std::array<double, 3> member_m_s{1, 2, 6};
  std::vector<ingest::GribField> fields;
  for (std::size_t member = 0; member < member_m_s.size(); ++member) {
    for (const int step : {0, 3, 6}) {
      for (const char* name : {"10u", "10v"}) {
        ingest::GribField field{
            name, midnight, step, static_cast<int>(member + 1), {53.5, 54, 54.5}, {6, 6.5, 7}, {}};
        field.values.assign(9, member_m_s[member] + step);
        fields.push_back(std::move(field));
      }
    }
  }
  const TemporaryFolder folder;
  ingest::write_grib(folder / "ensemble.grib2", fields, 2, true);
  ProductServiceForTests service;
  service.with_file(folder / "ensemble.grib2");
  ASSERT_EQ(service.catalogue()->products->size(), 1U);
  const json answer =
      service.document("/collections/" + service.catalogue()->products->front().id + "/position",
                       {{"coords", "POINT(6.5 54)"}});
  const auto east = values_of(answer, "eastward_wind");
  ASSERT_EQ(east.size(), 3U);
  for (std::size_t i = 0; i < east.size(); ++i)
    EXPECT_NEAR(east[i], 3 + 3 * static_cast<double>(i), rounding) << i;
  EXPECT_EQ(values_of(answer, "forecast_period"), (std::vector<double>{0, 3, 6}));
  EXPECT_NE(notes_of(answer).find("means of 3 members of an ensemble"), std::string::npos);
}

TEST(EdrProducts, EachOfSeveralPointsHasItsOwnDepth) {
  ProductServiceForTests service;
  service.with(current_product(day)).issue(forecast_at("here", 54, 6.5));
  for (const std::string& collection :
       {std::string(currents), std::string("/collections/currents")}) {
    const std::string path = collection + "/position";
    const json both = service.document(path, {{"coords", "MULTIPOINT Z((6.5 54 0),(6.5 54 20))"}});
    const json& coverages = both.at("coverages");
    ASSERT_EQ(coverages.size(), 2U) << collection;
    for (std::size_t i = 0; i < 2; ++i) {
      const json one =
          service.document(path, {{"coords", "POINT(6.5 54)"}, {"z", i == 0 ? "0" : "20"}});
      EXPECT_EQ(coverages[i].at("domain").at("axes").at("z"), one.at("domain").at("axes").at("z"));
      EXPECT_EQ(values_of(coverages[i], east_current), values_of(one, east_current)) << collection;
    }
    EXPECT_NE(values_of(coverages[0], east_current), values_of(coverages[1], east_current));
  }
  EXPECT_NE(service
                .refusal(404, std::string(currents) + "/position",
                         {{"coords", "MULTIPOINT Z((6.5 54 400),(6.5 54 500))"}})
                .find("depth 0 to 30 m"),
            std::string::npos);
  const json half = service.document(std::string(currents) + "/position",
                                     {{"coords", "MULTIPOINT Z((6.5 54 5),(6.5 54 500))"}});
  EXPECT_FALSE(std::isnan(values_of(half.at("coverages")[0], east_current).front()));
  EXPECT_TRUE(std::isnan(values_of(half.at("coverages")[1], east_current).front()));
  EXPECT_NE(notes_of(half).find("does not reach have no value: it holds depth 0 to 30 m"),
            std::string::npos);
  EXPECT_EQ(notes_of(service.document(std::string(currents) + "/position",
                                      {{"coords", "MULTIPOINT Z((6.5 54 0),(6.5 54 30))"}}))
                .find("does not reach"),
            std::string::npos);
}

TEST(EdrProducts, ARadiusHoldsTheCellsWithinIt) {
  const json answer = all_kinds().document(std::string(currents) + "/radius",
                                           {{"coords", "POINT(6.5 54)"},
                                            {"within", "12"},  // east 6.5 km a cell, north 11.1 km
                                            {"within-units", "km"},
                                            {"z", "5"},
                                            {"datetime", "2025-03-10T06:00:00Z"}});
  const auto east = values_of(answer, east_current);
  ASSERT_EQ(east.size(), 9U);
  std::size_t i = 0;
  for (const double y : {53.9, 54.0, 54.1}) {
    for (const double x : {6.4, 6.5, 6.6}) {
      const double value = WaterForTests::eastward_m_s({midnight + std::chrono::hours(6), 5, y, x});
      if (y != 54.0 && x != 6.5) {
        EXPECT_TRUE(std::isnan(east[i])) << i;
      } else {
        EXPECT_NEAR(east[i], value, rounding) << i;
      }
      ++i;
    }
  }
}

TEST(EdrProducts, FilesThatWereCutAtOtherDepthsAreTwoCollections) {
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

TEST(EdrProducts, OneLevelIsToldAsOne) {
  ProductServiceForTests service;
  ProductForTests product = current_product(day);
  product.depth_m = {5};
  service.with(product);
  EXPECT_NE(service
                .refusal(404, std::string(currents) + "/position",
                         {{"coords", "POINT(6.5 54)"}, {"z", "10"}})
                .find("depth 5 m alone"),
            std::string::npos);
}

TEST(EdrProducts, AMissingHeightTakesNothingElseAway) {
  ProductServiceForTests service;
  ProductForTests product = wave_product(day);
  product.quantity("VHM0").value = [](const ProductCell& cell) {
    return cell.time == midnight + std::chrono::hours(3) ? std::nan("") : 1.5;
  };
  service.with(product);
  const json answer =
      service.document(waves_of(service) + "/position", {{"coords", "POINT(6.5 54)"}});
  EXPECT_TRUE(std::isnan(values_of(answer, "sea_surface_wave_significant_height").at(3)));
  EXPECT_EQ(values_of(answer, "sea_surface_wave_from_direction").at(3), 265);
  EXPECT_EQ(values_of(answer, "forecast_period").at(3), 0);
}

TEST(EdrProducts, ManyRunsAreCountedInTheHeader) {
  ProductServiceForTests service;
  service.with(current_product(day));
  for (int i = 1; i < 10; ++i) {
    const UtcTime run = midnight + std::chrono::days(i) - std::chrono::hours(12);
    service.with(forecast_of(day + std::chrono::days(i), run, 0.1));
  }
  const auto csv = service.get(std::string(currents) + "/position",
                               {{"coords", "POINT(6.5 54)"}, {"z", "5"}, {"f", "CSV"}});
  ASSERT_EQ(csv.status, 200) << csv.body;
  const auto runs = std::find_if(csv.headers.begin(), csv.headers.end(), [](const auto& header) {
    return header.first == "Slackwater-Runs";
  });
  ASSERT_NE(runs, csv.headers.end());
  EXPECT_EQ(runs->second, "analysis; 9 forecasts, 2025-03-10T12:00:00Z to 2025-03-18T12:00:00Z");
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

TEST(EdrProducts, TheInterfaceNamesThemWhereTheyAreAnswered) {
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
  ProductServiceForTests service;
  service.with(current_product(day));
  const auto asked = [&](int status, const std::string& resolution) {
    return service.refusal(status, std::string(currents) + "/cube",
                           {{"bbox", "6.3,53.8,6.7,54.2"},
                            {"z", "0/30"},
                            {"resolution-x", resolution},
                            {"resolution-y", resolution}});
  };
  EXPECT_NE(asked(400, "200").find("at most 2000000 values"), std::string::npos);
  const auto& granule = service.catalogue()->products->front().granules.front();
  std::ofstream(store::content_file(service.store(), granule.content_sha256), std::ios::app) << "x";
  static_cast<void>(asked(503, "200"));
  EXPECT_NE(asked(400, "800").find("at most 2000000 values"), std::string::npos) << "not opened";
}

TEST(EdrProducts, MoreFilesThanMayBeOpenedAreRefusedWithAStretchThatFits) {
  api::StoredProduct product;
  product.standard_names = api::quantities_of(product.kind);
  for (int i = 0; i < 1003; ++i) {
    store::GranuleRow row;
    row.first_time = midnight + std::chrono::days(i);
    row.last_time = *row.first_time + std::chrono::hours(23);
    row.bounds = {6, 53, 7, 55};
    row.content_sha256.assign(64, '0');
    product.granules.push_back(row);
  }
  api::ProductWindow window{6.4, 53.9, 6.6, 54.1, midnight, *product.granules.back().last_time};
  const std::string refusal = refusal_of([&] { api::ProductView("none", product, window); });
  EXPECT_NE(refusal.find("into 1003 stored files"), std::string::npos) << refusal;
  EXPECT_NE(refusal.find("e.g. to 2025-03-12T23:00:01Z/2027-12-07T23:00:00Z"), std::string::npos)
      << refusal;
  window.from = parse_utc("2025-03-12T23:00:01Z");
  EXPECT_NE(refusal_of([&] { api::ProductView("none", product, window); }).find("cannot be read"),
            std::string::npos);
}

TEST(EdrProducts, MemoryIsBoundedByAllRunsAtOneTime) {
  ProductServiceForTests service;
  for (int run = 0; run < 3; ++run)
    service.with(forecast_of(day, midnight - std::chrono::hours(12 * run), 0.1));
  const api::StoredProduct& product = service.catalogue()->products->front();
  const api::ProductWindow window{6.5, 54, 6.5, 54, midnight, midnight + std::chrono::hours(5)};
  const std::vector<GeoPoint> place{GeoPoint::from_degrees(54, 6.5)};
  const auto values_with = [&](std::size_t most) {
    const api::ProductView view(service.store(), product, window, most);
    std::vector<UtcTime> times;
    for (const TimeCell& cell : view.time()) times.push_back(cell.centre());
    return view.values(place, times, view.levels_m());
  };
  // Within 0.3 degrees all 5 x 5 cells, at 5 levels, of both components.
  const std::size_t of_a_run = std::size_t{2} * 5 * 5 * 5;
  EXPECT_EQ(values_with(3 * of_a_run).value.front().size(), 30U);
  EXPECT_NE(refusal_of([&] { values_with(3 * of_a_run - 1); }).find("of all its runs"),
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
    EXPECT_NEAR(values_of(answer, "eastward_wind").front(), 5.1, rounding) << coords;
  }
  const json across = service.document(
      std::string(wind) + "/cube",
      {{"bbox", "179.85,-17.05,-179.85,-16.95"}, {"z", "10"}, {"datetime", instant}});
  const auto east = values_of(across, "eastward_wind");
  ASSERT_EQ(east.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(east[i], 4.9 + 0.1 * static_cast<double>(i), rounding);
}

/// A wind round the Earth, cells ten degrees apart, whose columns begin at a longitude.
ProductForTests global_wind(double west_deg) {
  ProductForTests product = wind_product(day, 1);
  product.longitude_deg.clear();
  product.latitude_deg.clear();
  for (int i = 0; i < 36; ++i) product.longitude_deg.push_back(west_deg + 10 * i);
  for (int j = -8; j <= 8; ++j) product.latitude_deg.push_back(10 * j);
  return product;
}

/// That wind at a cell, whichever turn its longitude is counted in.
double global_eastward_m_s(double longitude_deg, double latitude_deg) {
  return 0.1 * latitude_deg + std::cos(longitude_deg * std::acos(-1.0) / 180);
}

TEST(EdrProducts, AProductRoundTheEarthHasNoSeam) {
  for (const double west_deg : {-180.0, 0.0}) {
    ProductServiceForTests service;
    ProductForTests product = global_wind(west_deg);
    product.quantity("eastward_wind").value = [](const ProductCell& cell) {
      return global_eastward_m_s(cell.longitude_deg, cell.latitude_deg);
    };
    service.with(product);
    for (const auto& [bbox, columns, rows] :
         {std::tuple{"-180,-80,180,80", 36U, 17U}, std::tuple{"0,-80,359,80", 36U, 17U},
          std::tuple{"170,-10,-170,10", 3U, 3U}, std::tuple{"-20,-10,20,10", 5U, 3U},
          std::tuple{"160,-1,350,1", 20U, 1U}}) {
      const json answer =
          service.document(std::string(wind) + "/cube", {{"bbox", bbox}, {"z", "10"}});
      const json& axes = answer.at("domain").at("axes");
      const json& x = axes.at("x").at("values");
      const json& y = axes.at("y").at("values");
      EXPECT_EQ(x.size(), columns) << west_deg << " " << bbox;
      EXPECT_EQ(y.size(), rows) << west_deg << " " << bbox;
      const auto east = values_of(answer, "eastward_wind");
      ASSERT_EQ(east.size(), x.size() * y.size());
      for (std::size_t i = 0; i < east.size(); ++i)
        ASSERT_NEAR(east[i], global_eastward_m_s(x[i % x.size()], y[i / x.size()]), rounding)
            << west_deg << " " << bbox << " " << x[i % x.size()];
    }
    for (const double x : {-180.0, -175.0, -5.0, 0.0, 5.0, 175.0, 180.0, 355.0}) {
      const json answer = service.document(std::string(wind) + "/position",
                                           {{"coords", "POINT(" + std::to_string(x) + " 50)"}});
      const double low = 10 * std::floor(x / 10);
      const double share = (x - low) / 10;
      const double expected =
          (1 - share) * global_eastward_m_s(low, 50) + share * global_eastward_m_s(low + 10, 50);
      EXPECT_NEAR(values_of(answer, "eastward_wind").front(), expected, rounding)
          << west_deg << " " << x;
    }
    const json coarse = service.document(
        std::string(wind) + "/cube",
        {{"bbox", "-180,-80,180,80"}, {"z", "10"}, {"resolution-x", "5"}, {"resolution-y", "1"}});
    EXPECT_EQ(coarse.at("domain").at("axes").at("x").at("values"),
              json::array({-180.0, -90.0, 0.0, 90.0, 180.0}))
        << "as they were asked";
    const std::vector<double> of_quarters{-1, 0, 1, 0, -1};
    const auto quarters = values_of(coarse, "eastward_wind");
    ASSERT_EQ(quarters.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(quarters[i], of_quarters[i], rounding) << i;
    for (const auto& [coords, cells] :
         {std::pair{"POLYGON((165 5,195 5,195 25,165 25,165 5))", 6U},
          std::pair{"POLYGON((-180 5,-165 5,-165 25,-180 25,-180 5))", 4U},
          std::pair{"POLYGON((-15 5,15 5,15 25,-15 25,-15 5))", 6U}}) {
      const auto east = values_of(
          service.document(std::string(wind) + "/area", {{"coords", coords}}), "eastward_wind");
      EXPECT_EQ(east.size(), cells) << coords;
      EXPECT_TRUE(std::none_of(east.begin(), east.end(), [](double v) { return std::isnan(v); }))
          << west_deg << " " << coords;
    }
    const json ends = service.document(std::string(wind) + "/position",
                                       {{"coords", "MULTIPOINT((-180 20),(180 20))"}});
    for (const json& end : ends.at("coverages"))
      EXPECT_NEAR(values_of(end, "eastward_wind").front(), 1, rounding) << west_deg;
  }
}

TEST(EdrProducts, BothEndsOfAProductNearlyRoundTheEarthAreAnswered) {
  ProductServiceForTests service;
  ProductForTests product = global_wind(20);
  product.longitude_deg.resize(33);  // 20 to 340
  product.quantity("eastward_wind").value = [](const ProductCell& cell) {
    return cell.longitude_deg / 100;
  };
  service.with(product);
  const json answer =
      service.document(std::string(wind) + "/cube", {{"bbox", "-30,-1,30,1"}, {"z", "10"}});
  EXPECT_EQ(answer.at("domain").at("axes").at("x").at("values"),
            json::array({-30.0, -20.0, 20.0, 30.0}));
  const auto east = values_of(answer, "eastward_wind");
  const std::vector<double> expected{3.3, 3.4, 0.2, 0.3};
  ASSERT_EQ(east.size(), expected.size());
  for (std::size_t i = 0; i < east.size(); ++i) EXPECT_NEAR(east[i], expected[i], rounding) << i;
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
    EXPECT_NEAR(east[i], static_cast<double>(i / 4), rounding_of_tens) << i;
    EXPECT_NEAR(north[i], i % 4 < 2 ? 3 : 5.29, rounding) << i;
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

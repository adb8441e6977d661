// The collections of stored products: their own values, their own times, levels and cells.
#include <algorithm>
#include <cmath>

#include "ingest/netcdf/file.h"
#include "tests/api/door/edr/stored_products_for_tests.h"

namespace slackwater::tests::edr_products {
namespace {

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
}  // namespace slackwater::tests::edr_products

#include "api/issued/stored_products.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "fields/base/time.h"

namespace slackwater::api::stored_products_test {
namespace {

const UtcTime midnight = parse_utc("2025-03-10T00:00:00Z");

store::GranuleRow row_of(const std::string& product, const std::string& dataset,
                         std::vector<std::string> names) {
  static std::int64_t id = 0;
  store::GranuleRow row;
  row.id = ++id;
  row.product_id = product;
  row.dataset_id = dataset;
  row.standard_names = std::move(names);
  row.first_time = midnight;
  row.last_time = midnight + std::chrono::hours(23);
  row.bounds = {2, 53, 3, 54};
  return row;
}

const std::vector<std::string>& currents() { return quantities_of(ProductKind::currents); }

std::vector<std::string> ids_of(const std::vector<store::GranuleRow>& rows) {
  std::vector<std::string> ids;
  for (const StoredProduct& product : stored_products(rows)) ids.push_back(product.id);
  return ids;
}

TEST(StoredProducts, EachDatasetAndKindIsOne) {
  auto both = quantities_of(ProductKind::waves);
  both.insert(both.end(), {"eastward_wind", "northward_wind"});
  EXPECT_EQ(ids_of({row_of("PHY", "hourly", currents()), row_of("PHY", "daily", currents()),
                    row_of("PHY", "hourly", currents()), row_of("MIX", "", both)}),
            (std::vector<std::string>{"product-currents-daily", "product-currents-hourly",
                                      "product-waves-MIX", "product-wind-MIX"}));
}

TEST(StoredProducts, TwoComponentsInTwoFilesAreOneAndOneAloneIsNone) {
  const auto east = row_of("PHY", "", {currents()[0]});
  const auto north = row_of("PHY", "", {currents()[1]});
  EXPECT_EQ(ids_of({east, north}), std::vector<std::string>{"product-currents-PHY"});
  EXPECT_TRUE(ids_of({east}).empty());
  const auto gusts = row_of("AIR", "", {"eastward_wind", "wind_speed_of_gust"});
  EXPECT_TRUE(ids_of({gusts}).empty()) << "a gust is no second component";
}

TEST(StoredProducts, StrangersAtDifferentPlacesAreTwoAndKeepTheirNames) {
  const auto here = row_of("cf", "", currents());
  auto elsewhere = row_of("cf", "", currents());
  elsewhere.bounds = {10, 40, 11, 41};
  auto third = row_of("cf", "", currents());
  third.bounds = {20, 40, 21, 41};
  const auto id_of = [&](const std::vector<store::GranuleRow>& rows, double west_deg) {
    for (const StoredProduct& product : stored_products(rows))
      if (product.bounds.west_deg == west_deg) return product.id;
    return std::string("none");
  };
  const std::string id = id_of({here, elsewhere}, 2);
  EXPECT_EQ(id.size(), std::string("product-currents-cf-123456").size());
  EXPECT_EQ(id, id_of({here}, 2)) << "a stranger alone as well";
  EXPECT_NE(id, id_of({here, elsewhere}, 10));
  EXPECT_EQ(id, id_of({third, here}, 2)) << "whatever else is there, and in whatever order";
  EXPECT_EQ(id_of({here, elsewhere}, 10), id_of({elsewhere, third}, 10)) << "after a prune";
}

TEST(StoredProducts, FilesOnOtherLevelsAreTwo) {
  auto shallow = row_of("PHY", "hourly", currents());
  shallow.vertical = VerticalKind::depth_m;
  shallow.lowest_level_m = 0.5;
  shallow.highest_level_m = 30;
  auto deep = shallow;
  deep.highest_level_m = 60;
  const std::vector<std::string> both = ids_of({shallow, deep});
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NE(both[0], both[1]);
  EXPECT_EQ(both, ids_of({deep, shallow}));
  EXPECT_EQ(ids_of({shallow, shallow}), std::vector<std::string>{"product-currents-hourly"});
}

TEST(StoredProducts, WhatInstrumentsMeasuredAndWhatStandsStillIsNone) {
  auto mooring = row_of("cf", "", currents());
  mooring.is_point_series = true;
  mooring.status = DataStatus::observation;
  auto bed = row_of("GEBCO", "", {"sea_floor_depth_below_geoid"});
  bed.first_time.reset();
  bed.last_time.reset();
  EXPECT_TRUE(ids_of({mooring, bed}).empty());
}

TEST(StoredProducts, ExtentAndRunsAreThoseOfAllFiles) {
  auto analysis = row_of("PHY", "", currents());
  auto run = row_of("PHY", "", currents());
  run.status = DataStatus::forecast;
  run.reference_time = midnight + std::chrono::hours(12);
  run.first_time = midnight + std::chrono::hours(24);
  run.last_time = midnight + std::chrono::hours(47);
  run.bounds = {1, 53, 2.5, 55};
  for (store::GranuleRow* row : {&analysis, &run}) {
    row->vertical = VerticalKind::depth_m;
    row->lowest_level_m = 0.5;
    row->highest_level_m = 60;
  }
  const StoredProduct product = stored_products({analysis, run}).front();
  EXPECT_EQ(product.from, midnight);
  EXPECT_EQ(product.to, *run.last_time);
  EXPECT_EQ(product.bounds, (BoundingBox{1, 53, 3, 55}));
  EXPECT_EQ(product.highest_level_m, 60);
  EXPECT_TRUE(product.has_analysis);
  EXPECT_EQ(product.runs, std::vector<UtcTime>{*run.reference_time});
}

TEST(StoredProducts, IdsAreFitForAPath) {
  const std::string id = ids_of({row_of("A b/c?d", "", currents())}).front();
  EXPECT_EQ(id, "product-currents-A_b_c_d");
}

}  // namespace
}  // namespace slackwater::api::stored_products_test

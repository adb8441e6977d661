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
}

TEST(StoredProducts, StrangersAtDifferentPlacesAreTwo) {
  auto elsewhere = row_of("cf", "", currents());
  const auto here = row_of("cf", "", currents());
  elsewhere.bounds = {10, 40, 11, 41};
  const auto products = stored_products({here, elsewhere});
  ASSERT_EQ(products.size(), 2U);
  EXPECT_EQ(products[0].id, "product-currents-cf");
  EXPECT_EQ(products[0].bounds.west_deg, 10) << "the first that was ingested has the plain name";
  EXPECT_EQ(products[1].id, "product-currents-cf-2");
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
  }
  analysis.highest_level_m = 30;
  run.highest_level_m = 60;
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

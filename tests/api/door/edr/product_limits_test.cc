// How much of a stored product is read at once, and what is never opened.
#include <fstream>

#include "api/issued/product_values.h"
#include "data/store/layout.h"
#include "tests/api/door/edr/stored_products_for_tests.h"

namespace slackwater::tests::edr_products {
namespace {

TEST(EdrProductLimits, ADamagedFileIsNeverOpened) {
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

TEST(EdrProductLimits, TooMuchIsRefusedBeforeItIsRead) {
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

TEST(EdrProductLimits, MoreFilesThanMayBeOpenedAreRefusedWithAStretchThatFits) {
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

TEST(EdrProductLimits, MemoryIsBoundedByAllRunsAtOneTime) {
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

TEST(EdrProductLimits, AllOfItIsLongWorkForItReadsFiles) {
  EXPECT_TRUE(all_kinds().takes_long(std::string(currents) + "/position",
                                     "coords=POINT(6.5%2054)&z=5&datetime=2025-03-10T06:00:00Z"));
}

TEST(EdrProductLimits, WhatIsReadInPartsIsTheSame) {
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
    const std::size_t row = i / 4;
    EXPECT_NEAR(east[i], static_cast<double>(row), rounding_of_tens) << i;
    EXPECT_NEAR(north[i], i % 4 < 2 ? 3 : 5.29, rounding) << i;
  }
}

}  // namespace
}  // namespace slackwater::tests::edr_products

#include "api/pipeline/load_site_data.h"

#include <gtest/gtest.h>

#include "api/pipeline/ingest_files.h"
#include "fields/base/error.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api {
namespace {

using std::chrono::days;
using std::chrono::hours;
using tests::WaterForTests;

const UtcDay day = parse_day("2025-03-10");
const UtcTime midnight(day);

/// A store with the files that a test puts into it.
class SmallStore {
 public:
  SmallStore& with(const tests::ProductForTests& product) {
    const auto file = folder_ / ("product-" + std::to_string(++files_) + ".nc");
    const auto products = ingest::ProductCatalogue::load(tests::source_folder() / "data/products");
    static_cast<void>(ingest_file(store_, products, tests::write_product(file, product), {},
                                  midnight + days(3), {}));
    return *this;
  }
  SiteData load(const Site& site) {
    return load_site_data(store_, site, midnight, midnight + days(1));
  }

 private:
  tests::TemporaryFolder folder_;
  store::Store store_ = store::Store::open(folder_ / "store", store::OpenMode::create_or_write);
  int files_ = 0;
};

Site site_at(double latitude_deg, double longitude_deg) {
  Site site;
  site.id = "test_site";
  site.point = GeoPoint::from_degrees(latitude_deg, longitude_deg);
  return site;
}

const Site in_the_water =
    site_at(WaterForTests::site_latitude_deg, WaterForTests::site_longitude_deg);

std::string refusal(SmallStore& store, const Site& site) {
  try {
    (void)store.load(site);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    return error.message();
  }
  return "none";
}

TEST(SiteData, HoldsTheStoredWaterAndAirAtTheSite) {
  SmallStore store;
  store.with(tests::current_product(day)).with(tests::wind_product(day));
  store.with(tests::wave_product(day));
  const SiteData data = store.load(in_the_water);
  ASSERT_EQ(data.columns.size(), 1u);
  EXPECT_TRUE(data.has_currents());
  const ColumnData& column = data.columns[0];
  ASSERT_EQ(column.current.pieces.size(), 1u);
  const VectorColumn& current = column.current.pieces[0].column;
  ASSERT_EQ(current.times(), 24u);
  for (std::size_t t = 0; t < 24; ++t) {
    for (std::size_t k = 0; k < current.levels(); ++k) {
      const tests::ProductCell cell{current.time[t].centre(), current.levels_m[k],
                                    WaterForTests::site_latitude_deg,
                                    WaterForTests::site_longitude_deg};
      // Floats of less than 1 m/s.
      EXPECT_NEAR(current.value[current.offset(t, k)].real(), WaterForTests::eastward_m_s(cell),
                  1e-6);
      EXPECT_NEAR(current.value[current.offset(t, k)].imag(), WaterForTests::northward_m_s(cell),
                  1e-6);
    }
  }
  ASSERT_EQ(column.wind.pieces.size(), 1u);
  EXPECT_EQ(column.wind.pieces[0].column.times(), 24u);
  EXPECT_EQ(column.significant_height.pieces.size(), 1u);
  EXPECT_EQ(column.peak_period.pieces.size(), 1u);
  EXPECT_EQ(column.wave_direction.pieces.size(), 1u);
}

TEST(SiteData, TheSiteSaysHowDeepTheWaterIsThenTheBathymetryThenTheCurrents) {
  SmallStore store;
  store.with(tests::current_product(day));
  EXPECT_EQ(store.load(in_the_water).columns[0].water_depth.source, "deepest wet level");
  store.with(tests::bathymetry_product());
  const WaterDepth depth = store.load(in_the_water).columns[0].water_depth;
  EXPECT_EQ(depth.source, "bathymetry");
  EXPECT_NEAR(depth.depth_m, WaterForTests::depth_m, 1e-4);
  Site stated = in_the_water;
  stated.water_depth_m = 27;
  EXPECT_EQ(store.load(stated).columns[0].water_depth.source, "site");
  EXPECT_EQ(store.load(stated).columns[0].water_depth.depth_m, 27);
}

TEST(SiteData, WhatIsStoredKnowsWhenItWasPublished) {
  SmallStore store;
  auto currents = tests::current_product(day);
  currents.global = {{"date_issued", "2025-03-11T06:00:00Z"}};
  auto waves = tests::wave_product(day);
  waves.global = {{"date_issued", "2031-01-01T00:00:00Z"}};  // but it is in hand
  store.with(currents).with(tests::wind_product(day)).with(waves);
  const SiteData data = store.load(in_the_water);
  const ColumnData& column = data.columns.at(0);
  EXPECT_EQ(column.current.pieces.at(0).origin->published, parse_utc("2025-03-11T06:00:00Z"));
  EXPECT_EQ(column.wind.pieces.at(0).origin->published, std::nullopt);
  EXPECT_EQ(column.significant_height.pieces.at(0).origin->published, midnight + days(3));
}

TEST(SiteData, ColumnsOnLandAreLeftOutAndCounted) {
  SmallStore store;
  store.with(tests::current_product(day));
  Site site = in_the_water;
  site.columns = {in_the_water.point, GeoPoint::from_degrees(54.1, 6.7),
                  GeoPoint::from_degrees(54.1, 6.4)};
  const SiteData data = store.load(site);
  EXPECT_EQ(data.columns.size(), 2u);
  EXPECT_EQ(data.dry_columns, 1u);
}

TEST(SiteData, ASiteThatCannotBeServedIsToldWhy) {
  SmallStore store;
  EXPECT_NE(refusal(store, in_the_water).find("the store holds nothing for site test_site"),
            std::string::npos);
  store.with(tests::current_product(day));
  EXPECT_NE(refusal(store, site_at(54.1, 6.7)).find("is on land"), std::string::npos);
  EXPECT_NE(refusal(store, site_at(54.0, 6.0)).find("lies outside the stored currents"),
            std::string::npos);
}

}  // namespace
}  // namespace slackwater::api

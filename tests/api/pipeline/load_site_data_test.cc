#include "api/pipeline/load_site_data.h"

#include <gtest/gtest.h>

#include <cmath>

#include "api/pipeline/ingest/ingest_files.h"
#include "fields/base/error.h"
#include "fields/record/choose.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/point_series_for_tests.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::load_site_data_test {
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
  SmallStore& with(const tests::PointSeriesForTests& series) {
    const auto file = folder_ / ("series-" + std::to_string(++files_) + ".nc");
    const auto products = ingest::ProductCatalogue::load(tests::source_folder() / "data/products");
    static_cast<void>(ingest_file(store_, products, tests::write_point_series(file, series), {},
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

/// A series of a day at so many kilometres east and north of the site.
tests::PointSeriesForTests series_at(double east_km, double north_km,
                                     std::vector<double> depth_m = {}) {
  constexpr double km_per_degree = 111.2;  // of the sphere; the tests stay 10 % away from a reach
  const double here = std::cos(WaterForTests::site_latitude_deg * 3.14159265 / 180);
  tests::PointSeriesForTests series;
  series.latitude_deg = WaterForTests::site_latitude_deg + north_km / km_per_degree;
  series.longitude_deg = WaterForTests::site_longitude_deg + east_km / (km_per_degree * here);
  series.time = tests::stepping_times(day, 1, 60);
  series.depth_m = std::move(depth_m);
  series.value = [](UtcTime, double) { return Horizontal(0.5, 0.25); };
  return series;
}

TEST(SiteData, ASeriesSpeaksAsFarInEveryDirection) {
  struct Direction {
    double east = 0, north = 0;
  };
  for (const Direction to :
       std::vector<Direction>{{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {0.7, 0.7}, {-0.7, 0.7}}) {
    SCOPED_TRACE(std::to_string(to.east) + " " + std::to_string(to.north));
    const auto winds = [&](double away_km) {
      SmallStore store;
      store.with(tests::current_product(day))
          .with(series_at(away_km * to.east, away_km * to.north));
      return store.load(in_the_water).columns.at(0).wind.pieces.size();
    };
    EXPECT_EQ(winds(45), 1u) << "a mast, 50 km";
    EXPECT_EQ(winds(55), 0u);
    const auto currents = [&](double away_km) {
      SmallStore store;
      store.with(tests::current_product(day))
          .with(series_at(away_km * to.east, away_km * to.north, {5}));
      return store.load(in_the_water).columns.at(0).current.pieces.size();
    };
    EXPECT_EQ(currents(9), 2u) << "a current meter, 10 km, beside the product";
    EXPECT_EQ(currents(11), 1u);
  }
}

/// The waves of the product with this name and meaning for their period; "": without any.
tests::ProductForTests waves_with(const std::string& name, const std::string& standard_name) {
  auto waves = tests::wave_product(day);
  if (name.empty()) {
    std::erase_if(waves.quantities, [](const auto& q) { return q.name == "VTPK"; });
    return waves;
  }
  auto& period = waves.quantity("VTPK");
  period.name = name;
  period.standard_name = standard_name;
  period.value = [](const tests::ProductCell&) { return 6.0; };
  return waves;
}

TEST(SiteData, APeriodThatIsNotThePeaksIsConvertedAndSaysSo) {
  const std::string mean = "sea_surface_wave_mean_period_from_variance_spectral_density_";
  struct Case {
    std::string name, standard_name;
    double ratio;
    std::string note;
  };
  for (const Case& c :
       {Case{"VTPK", "sea_surface_wave_period_at_variance_spectral_density_maximum", 1, ""},
        Case{"VTM10", mean + "inverse_frequency_moment", 1.107, "1.11 times the energy period"},
        Case{"VTM02", mean + "second_frequency_moment", 1.287,
             "1.29 times the zero-crossing period"}}) {
    SCOPED_TRACE(c.name);
    SmallStore store;
    store.with(tests::current_product(day)).with(waves_with(c.name, c.standard_name));
    const SiteData data = store.load(in_the_water);
    const ColumnData& column = data.columns.at(0);
    ASSERT_EQ(column.peak_period.pieces.size(), 1u);
    for (const double period : column.peak_period.pieces[0].column.value)
      EXPECT_NEAR(period, 6 * c.ratio, 0.02);
    EXPECT_EQ(column.wave_period_note.empty(), c.note.empty()) << column.wave_period_note;
    EXPECT_NE(column.wave_period_note.find(c.note), std::string::npos) << column.wave_period_note;
  }
}

TEST(SiteData, HeightsWithoutAnyPeriodSaySo) {
  SmallStore store;
  store.with(tests::current_product(day)).with(waves_with("", ""));
  const SiteData data = store.load(in_the_water);
  EXPECT_TRUE(data.columns.at(0).peak_period.pieces.empty());
  EXPECT_NE(data.columns.at(0).wave_period_note.find("no period of the waves is stored"),
            std::string::npos);
  SmallStore none;
  none.with(tests::current_product(day));
  EXPECT_EQ(none.load(in_the_water).columns.at(0).wave_period_note, "") << "no waves, no word";
}

TEST(SiteData, ThePeaksOwnPeriodWinsOverAConvertedOne) {
  SmallStore store;
  auto waves = tests::wave_product(day);
  waves.quantities.push_back(waves.quantity("VTPK"));
  waves.quantities.back().name = "VTM10";
  waves.quantities.back().standard_name =
      "sea_surface_wave_mean_period_from_variance_spectral_density_inverse_frequency_moment";
  store.with(tests::current_product(day)).with(waves);
  const SiteData data = store.load(in_the_water);
  EXPECT_EQ(data.columns.at(0).peak_period.pieces.size(), 1u);
  EXPECT_EQ(data.columns.at(0).wave_period_note, "");
}

TEST(SiteData, OfTwoWaveProductsEachHasThePeriodOfItsOwnFile) {
  // The regional one, whose height speaks, has an energy period alone; the global one a peak's.
  const std::string energy =
      "sea_surface_wave_mean_period_from_variance_spectral_density_inverse_frequency_moment";
  SmallStore store;
  auto global = tests::wave_product(day);
  global.title = "GLOBAL_ANALYSISFORECAST_WAV_001_027";
  global.quantity("VTPK").value = [](const tests::ProductCell&) { return 11.0; };
  store.with(tests::current_product(day)).with(waves_with("VTM10", energy)).with(global);
  const SiteData data = store.load(in_the_water);
  const ColumnData& column = data.columns.at(0);
  const Chosen<double> height = choose(column.significant_height, {}, {});
  Choice like;
  like.like = &height.stretches;
  const Chosen<double> period = choose(column.peak_period, {}, like);
  ASSERT_EQ(height.origin.front()->product_id, "NWSHELF_ANALYSISFORECAST_WAV_004_014");
  ASSERT_EQ(period.column.times(), height.column.times());
  for (const double value : period.column.value) EXPECT_NEAR(value, 6 * 1.107, 0.02);
  EXPECT_NE(column.wave_period_note.find(
                "no peak period of NWSHELF_ANALYSISFORECAST_WAV_004_014 is stored: it is computed"),
            std::string::npos)
      << column.wave_period_note;
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
}  // namespace slackwater::api::load_site_data_test

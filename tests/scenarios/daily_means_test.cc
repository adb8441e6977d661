// Daily and six-hourly means of a tidal sea with known truth, through the real ingest: what the
// forecast made from them says of the hours.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "api/made_up/synthetic/product_files.h"
#include "api/pipeline/daily_job.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "fields/base/constants.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::daily_means_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

constexpr int hourly_days = 6;
constexpr int mean_days = 12;

api::SyntheticOceanSettings settings() {
  api::SyntheticOceanSettings s;
  s.days = mean_days + 5;
  return s;
}

/// The true currents at the site, averaged, as the provider of the shelf product would cut them.
ProductForTests means_of(const api::SyntheticOcean& ocean, int averaging_h) {
  ProductForTests product =
      mean_current_product(ocean.settings().first_day, mean_days, averaging_h);
  if (averaging_h == 24) {  // as the daily files are: a title, stamps at noon, no bounds
    product.title = "NWSHELF_ANALYSISFORECAST_PHY_004_013 daily mean fields";
    product.cell_methods.clear();
  }
  product.depth_m = {0, 5, 10, 20};
  product.latitude_deg = {48.80, 48.85, 48.90};
  product.longitude_deg = {-2.60, -2.55, -2.50};
  for (ProductQuantity& q : product.quantities) {
    const bool north = q.name == "vo";
    q.value = [&ocean, north, averaging_h](const ProductCell& cell) {
      // One water for all cells: the site's.
      Horizontal sum{};
      const Duration averaging = hours(averaging_h);
      const int parts = 4 * averaging_h;
      for (int i = 0; i < parts; ++i) {
        const UtcTime time = cell.time - averaging / 2 + averaging * (2 * i + 1) / (2 * parts);
        sum += ocean.current_truth(ocean.settings().site, cell.depth_m, time).value();
      }
      return (north ? sum.imag() : sum.real()) / parts;
    };
  }
  return product;
}

struct Issued {
  Snapshot snapshot;
  double inside = 0;  ///< share of the true components within p10 to p90, over 72 hours
};

Issued issue(const api::SyntheticOcean& ocean, int averaging_h, bool with_hourly_record) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  const auto products = ingest::ProductCatalogue::load(source_folder() / "data" / "products");
  const UtcDay first = ocean.settings().first_day;
  const UtcTime end = UtcTime(first) + days(mean_days);
  std::vector<std::filesystem::path> files{
      write_product(folder / "means.nc", means_of(ocean, averaging_h)),
      api::write_wind_analysis(ocean, first, first + days(mean_days - 1), folder.path()),
      api::write_wind_forecast(ocean, end, 72, folder.path())};
  if (with_hourly_record) {
    for (const auto& file : api::write_current_product(ocean, first, first + days(hourly_days - 1),
                                                       folder.path(), {3, 3}))
      files.push_back(file);
  }
  for (const auto& file : files)
    static_cast<void>(api::ingest_file(store, products, file, {}, end + hours(4), {}));
  Site site;
  site.id = site.name = "bay";
  site.point = ocean.settings().site;
  site.water_depth_m = ocean.settings().site_depth_m;
  calibration::ForecastOptions options;
  options.issued = end + hours(5);
  const SiteData data = api::load_site_data(store, site, UtcTime(first), end + days(3));
  Issued issued;
  issued.snapshot = api::daily_job(data, options).forecast.snapshot;
  const Snapshot& s = issued.snapshot;
  const ForecastColumn& column = s.columns.front();
  double inside = 0;
  double all = 0;
  for (std::size_t t = 1; t < s.time.size(); ++t) {
    for (std::size_t k = 0; k < s.depth_m.size(); ++k) {
      const std::size_t o = t * s.depth_m.size() + k;
      const auto truth = ocean.current_truth(site.point, s.depth_m[k], s.time[t]);
      if (!truth || !has_value(column.current_status[o])) continue;
      const Horizontal miss = column.current_m_s[o] - *truth;
      const double band = constants::normal_p90 * column.current_sigma_m_s[o];
      inside += (std::abs(miss.real()) <= band ? 1 : 0) + (std::abs(miss.imag()) <= band ? 1 : 0);
      all += 2;
    }
  }
  issued.inside = inside / all;
  std::printf("means over %d h, %s: 80 %% band holds %.0f %% of the truth. %s\n", averaging_h,
              with_hourly_record ? "hourly record of before" : "no record of the tide",
              100 * issued.inside, s.headline.c_str());
  return issued;
}

TEST(DailyMeans, TheBandHoldsTheTruthWhereAnEarlierRecordTellsOfTheTide) {
  const api::SyntheticOcean ocean(settings());
  for (const int averaging_h : {24, 12, 6}) {
    const Issued issued = issue(ocean, averaging_h, true);
    ASSERT_TRUE(issued.snapshot.averaged);
    EXPECT_EQ(issued.snapshot.averaged->averaging, Duration(hours(averaging_h)));
    EXPECT_TRUE(issued.snapshot.averaged->unresolved_tide_m_s);
    EXPECT_TRUE(issued.snapshot.degraded);
    // Means over 6 h hold a part of the tide, which is forecast from the means, and worse.
    EXPECT_GE(issued.inside, averaging_h == 6 ? 0.65 : 0.75) << averaging_h;
  }
}

TEST(DailyMeans, WithoutOneTheBandIsBlindAndTheHeadlineSaysSo) {
  const api::SyntheticOcean ocean(settings());
  const Issued issued = issue(ocean, 24, false);
  ASSERT_TRUE(issued.snapshot.averaged);
  EXPECT_FALSE(issued.snapshot.averaged->unresolved_tide_m_s);
  EXPECT_TRUE(issued.snapshot.degraded);
  EXPECT_NE(issued.snapshot.headline.find(
                "daily means: they do not hold the tide, and its size is not known"),
            std::string::npos)
      << issued.snapshot.headline;
  EXPECT_LT(issued.inside, 0.7) << "or the sea was no tidal one, and this test shows nothing";
}

}  // namespace
}  // namespace slackwater::tests::daily_means_test

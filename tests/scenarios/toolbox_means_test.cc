// Hourly means of a tide of 1 m/s, stamped as the provider's own files are and as the Copernicus
// Marine toolbox cuts them: what the forecast made from them says of the next day.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "api/pipeline/daily_job.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/load_site_data.h"
#include "ingest/copernicus/product_catalogue.h"
#include "tests/support/product_files_for_tests.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::toolbox_means_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;

constexpr UtcDay first = std::chrono::sys_days{std::chrono::year(2025) / 3 / 1};
constexpr int days_known = 15;
constexpr double omega_rad_h = 2 * std::numbers::pi / 12.4206;  // M2

double tide_m_s(UtcTime time) {
  return std::cos(omega_rad_h * hours_between(UtcTime(first), time));
}
/// Its exact mean over an hour.
double mean_m_s(UtcTime middle) {
  return tide_m_s(middle) * std::sin(omega_rad_h / 2) / (omega_rad_h / 2);
}

/// @param cut_by_toolbox  stamped at the start of the hour, else in its middle
ProductForTests tide_of(bool cut_by_toolbox) {
  ProductForTests product = current_product(first, 24 * days_known);
  product.title = "Atlantic-Iberian Biscay Irish- Ocean Physics Analysis and Forecast";
  product.global = {{"source", "CMEMS IBI-MFC"}, {"institution", "Nologin"}};
  if (cut_by_toolbox) product.global["copernicusmarine_version"] = "2.1.1";
  const Duration to_middle = cut_by_toolbox ? Duration(minutes(30)) : Duration(0);
  if (!cut_by_toolbox)
    for (UtcTime& time : product.time) time += minutes(30);
  product.quantity("uo").value = [=](const ProductCell& cell) {
    return mean_m_s(cell.time + to_middle);
  };
  product.quantity("vo").value = [](const ProductCell&) { return 0.0; };
  return product;
}

/// Root mean square of what the next day's current is off, m/s.
double next_days_error_m_s(bool cut_by_toolbox) {
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  const auto products = ingest::ProductCatalogue::load(source_folder() / "data" / "products");
  const UtcTime end = UtcTime(first) + days(days_known);
  ProductForTests wind = wind_product(first, 24 * (days_known + 3));
  for (ProductQuantity& q : wind.quantities) q.value = [](const ProductCell&) { return 0.0; };
  for (const auto& file : {write_product(folder / "tide.nc", tide_of(cut_by_toolbox)),
                           write_product(folder / "wind.nc", wind)})
    static_cast<void>(api::ingest_file(store, products, file, {}, end + hours(4), {}));
  Site site;
  site.id = site.name = "strait";
  site.point =
      GeoPoint::from_degrees(WaterForTests::site_latitude_deg, WaterForTests::site_longitude_deg);
  site.water_depth_m = WaterForTests::depth_m;
  calibration::ForecastOptions options;
  options.issued = end + hours(5);
  const SiteData data = api::load_site_data(store, site, UtcTime(first), end + days(2));
  const Snapshot made = api::daily_job(data, options).forecast.snapshot;
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t t = 0; t < made.time.size(); ++t) {
    if (made.time[t] < end || made.time[t] > end + days(1)) continue;
    const Horizontal said = made.columns.front().current_m_s[t * made.depth_m.size()];
    sum += std::norm(said - Horizontal(tide_m_s(made.time[t]), 0));
    ++count;
  }
  EXPECT_GE(count, 24U);
  return std::sqrt(sum / static_cast<double>(count));
}

// Half an hour late, a tide of 1 m/s would be 0.18 m/s off: sqrt(1/2) times 2 sin(w/4).
TEST(ToolboxMeans, TheNextDaysTideIsAsRightAsFromTheProvidersOwnFiles) {
  const double native = next_days_error_m_s(false);
  const double cut = next_days_error_m_s(true);
  std::printf("next day's error in a tide of 1 m/s: native %.4f, cut by the toolbox %.4f m/s\n",
              native, cut);
  EXPECT_LT(native, 0.03);
  EXPECT_LT(cut, 0.03);
  EXPECT_NEAR(cut, native, 0.005);
}

}  // namespace
}  // namespace slackwater::tests::toolbox_means_test

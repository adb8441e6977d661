// A weather ensemble from its GRIB file to the numbers in the issued file.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "api/made_up/synthetic/product_files.h"
#include "api/pipeline/daily_job.h"
#include "api/pipeline/further_members.h"
#include "api/pipeline/ingest/ingest_files.h"
#include "api/pipeline/job_summary.h"
#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "ingest/cf/forecast/forecast_file.h"
#include "ingest/copernicus/product_catalogue.h"
#include "ingest/grib/grib_writer.h"
#include "ingest/netcdf/file.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::wind_ensemble_test {
namespace {

using std::chrono::days;
using std::chrono::hours;

constexpr int members = 30;
constexpr int horizon_h = 48;

/// Member n, control included: a wind that turns at a pace of its own. From 3 h on they spread more
/// than an analysis errs, so that the winds issued are theirs.
Horizontal member_wind(int number, double lead_h) {
  const double own = number == 0 ? 0.0 : 0.5 * number - 8.0;
  return {8.0 + 0.5 * own * std::min(1.0, lead_h / 3), 2.0 - 0.1 * own * lead_h / 6};
}

/// Three-hourly steps of all members over the site, as a weather centre sends them.
std::filesystem::path write_ensemble(const GeoPoint& site, UtcTime issued,
                                     const std::filesystem::path& folder) {
  std::vector<ingest::GribField> fields;
  for (int number = 0; number <= members; ++number) {
    for (int step = 0; step <= horizon_h; step += 3) {
      for (const bool east : {true, false}) {
        ingest::GribField field;
        field.short_name = east ? "10u" : "10v";
        field.reference_time = issued;
        field.step_hours = step;
        field.member = number;
        for (int i = -2; i <= 2; ++i) {
          field.latitude_deg.push_back(std::round(site.latitude_deg()) + 0.5 * i);
          field.longitude_deg.push_back(std::round(site.longitude_deg()) + 0.5 * i);
        }
        const Horizontal wind = member_wind(number, step);
        field.values.assign(25, east ? wind.real() : wind.imag());
        fields.push_back(std::move(field));
      }
    }
  }
  auto path = folder / "ensemble.grib2";
  ingest::write_grib(path, fields, 2, true);
  return path;
}

TEST(WindEnsemble, ItsNumbersStandInTheIssuedFileBesideTheWindsTheyName) {
  const tests::TemporaryFolder folder;
  const SyntheticOcean ocean;
  const UtcDay first = ocean.settings().first_day;
  const UtcDay day = first + days(3);
  const UtcTime end = UtcTime(day) + days(1);
  const Site site = find_site(write_site_yaml(ocean, folder.path()).string(), {});
  std::vector<std::filesystem::path> files =
      write_current_product(ocean, first, day, folder.path());
  files.push_back(write_wind_analysis(ocean, first, day, folder.path()));
  files.push_back(write_ensemble(site.point, end, folder.path()));
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  const auto products =
      ingest::ProductCatalogue::load(tests::source_folder() / "data" / "products");
  for (const auto& file : files)
    static_cast<void>(ingest_file(store, products, file, {}, UtcTime{}, {}));

  calibration::ForecastOptions options;
  options.day = day;
  options.issued = end + hours(5);
  options.horizon = hours(horizon_h);
  const SiteData data = load_site_data(store, site, UtcTime(day) - calibration::history_wanted,
                                       end + options.horizon);
  const DailyJob job = daily_job(data, options);
  ingest::write_forecast(folder / "issued.nc", job.forecast.snapshot);

  const auto file = ingest::netcdf::File::open(folder / "issued.nc");
  const auto* numbers = file.find("wind_member");
  ASSERT_NE(numbers, nullptr);
  EXPECT_EQ(numbers->dimensions, (std::vector<std::string>{"realization"}));
  EXPECT_EQ(numbers->type, ingest::netcdf::Type::int32);
  EXPECT_EQ(numbers->text("comment"), "ensemble: NWP_ecmf issued " + format_utc(end));
  const std::vector<double> number = file.read_all(*numbers);
  ASSERT_EQ(number.size(), 24U);
  EXPECT_EQ(std::set(number.begin(), number.end()).size(), 24U) << "none drives twice";
  const std::vector<double> east = file.read_all(*file.find("eastward_wind_member"));
  const std::vector<double> north = file.read_all(*file.find("northward_wind_member"));
  for (std::size_t m = 0; m < 24; ++m) {
    for (int lead_h = 6; lead_h <= horizon_h; lead_h += 3) {
      const auto at = static_cast<std::size_t>(lead_h) * 24 + m;
      const Horizontal said = member_wind(static_cast<int>(number[m]), lead_h);
      // Half a step of the file (0.5 mm/s) and the packing.
      EXPECT_LT(std::abs(Horizontal(east[at], north[at]) - said), 2e-3)
          << number[m] << ' ' << lead_h;
    }
  }

  const auto summary = job_summary(job);
  const auto& winds = summary["columns"][0]["wind_members"];
  EXPECT_EQ(winds["product"], "NWP_ecmf");
  EXPECT_EQ(winds["reference_time"], format_utc(end));
  EXPECT_EQ(winds["of_members"], members);
  for (std::size_t m = 0; m < 24; ++m) EXPECT_EQ(winds["number"][m], number[m]);

  const Snapshot read = ingest::read_forecast(folder / "issued.nc");
  EXPECT_EQ(read.columns[0].wind_member_number,
            job.forecast.snapshot.columns[0].wind_member_number);
  EXPECT_EQ(read.wind_ensemble, job.forecast.snapshot.wind_ensemble);

  // Further members have further winds, until all have blown once.
  static_cast<void>(publish(store, job, ForecastOrigin::forecast));
  const Snapshot more = with_further_members(store, store.list_forecasts().front(), members + 1);
  const std::vector<int>& all = more.columns[0].wind_member_number;
  ASSERT_EQ(all.size(), members);
  EXPECT_EQ(std::set(all.begin(), all.end()).size(), members);
  EXPECT_TRUE(std::equal(number.begin(), number.end(), all.begin()));
}

}  // namespace
}  // namespace slackwater::api::wind_ensemble_test

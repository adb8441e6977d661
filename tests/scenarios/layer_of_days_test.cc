// Otranto in August: the base of the mixed layer comes from the product's own temperatures.
#include "calibration/day/column/layer_of_days.h"

#include <gtest/gtest.h>

#include <cmath>

#include "api/pipeline/load_site_data.h"
#include "calibration/day/daily_forecast.h"
#include "ingest/netcdf/file.h"
#include "tests/scenarios/real_pairs.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::api::layer_of_days_test {
namespace {

/// The 0.2 K crossing of one cell of the file, searched in steps of a centimetre.
double crossing_m(const ingest::netcdf::File& file, std::size_t day, std::size_t j, std::size_t i) {
  const std::vector<double> depth = file.read_all(*file.find("depth"));
  std::vector<double> kelvin(depth.size());
  const std::vector<std::size_t> start{day, 0, j, i};
  const std::vector<std::size_t> count{1, depth.size(), 1, 1};
  file.read(*file.find("thetao"), start, count, std::span<double>(kelvin));
  const auto at = [&](double d) {
    std::size_t k = 1;
    while (depth[k] < d) ++k;
    const double share = (d - depth[k - 1]) / (depth[k] - depth[k - 1]);
    return kelvin[k - 1] + share * (kelvin[k] - kelvin[k - 1]);
  };
  double d = 10;
  while (std::abs(at(d) - at(10)) < 0.2) d += 0.01;
  return d;
}

TEST(LayerOfDays, TheTemperaturesOfAnAugustAreReadWhereNoDepthIsStated) {
  SLACKWATER_NEEDS_SHARED(shared);
  const auto currents = shared / "data/otranto_2023-08/currents";
  const tests::TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  tests::ingest_all(store, {shared / "data/otranto_2023-08"}, false);
  const auto file = ingest::netcdf::File::open(currents / "CMEMS_med_2023815_raw.nc");
  constexpr std::size_t j = 20;
  constexpr std::size_t i = 20;
  const GeoPoint cell = GeoPoint::from_degrees(file.read_all(*file.find("lat"))[j],
                                               file.read_all(*file.find("lon"))[i]);
  const Site site = tests::site_of("otranto", {cell});
  const UtcDay day = parse_day("2023-08-17");
  const SiteData data = load_site_data(store, site, UtcTime(day) - calibration::history_wanted,
                                       UtcTime(day) + std::chrono::days(2));
  calibration::ForecastPlan plan;
  plan.day = day;
  plan.issued = plan.end_of_day();
  const calibration::LayerOfDays layer =
      calibration::layer_of_days(calibration::layer_record(data.columns.front(), plan), plan.day);
  ASSERT_EQ(layer.size(), 4U) << "14 to 17 August";
  for (std::size_t d = 0; d < 4; ++d) {
    const auto figure = layer.at(parse_day("2023-08-14") + std::chrono::days(static_cast<int>(d)));
    EXPECT_NEAR(figure.depth_m, crossing_m(file, d, j, i), 0.05);
    EXPECT_EQ(figure.source, "thetao");
  }

  calibration::ForecastOptions job;
  job.day = day;
  job.issued = plan.issued;
  const calibration::DailyForecast forecast = calibration::make_forecast(data, job);
  bool is_named = false;
  for (const calibration::Calibration& form : forecast.columns.front().forms) {
    if (const auto* p = calibration::find_parameter(form, "mixed_layer_depth"))
      is_named = p->source.find("thetao") != std::string::npos;
  }
  EXPECT_TRUE(is_named) << "the calibration says where its layer comes from";
}

}  // namespace
}  // namespace slackwater::api::layer_of_days_test

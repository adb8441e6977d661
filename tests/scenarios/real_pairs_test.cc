#include "tests/scenarios/real_pairs.h"

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

// The D -> D+1 pairs of reference/baselines.md: our persistence and day-mean must be that page's,
// to its last digit (tolerance: half of it, plus float storage), so that our skill is measured with
// the ruler everyone else uses.

namespace slackwater::tests {
namespace {

constexpr double half_last_digit = 0.6e-4;

api::HindcastOptions pair_options(const char* from, const char* to, double deepest_m) {
  api::HindcastOptions options;
  options.from = parse_day(from);
  options.to = parse_day(to);
  options.horizon = std::chrono::hours(24);
  options.verify.bands = {{0, deepest_m}};
  options.verify.leads = {{0, 24}};
  return options;
}

TEST(RealPairs, BrestWindowsReproduceTheBaselinesPage) {
  SLACKWATER_NEEDS_SHARED(shared);
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, {shared / "data/brest/windows"}, true);
  api::Site site = site_of("brest", {GeoPoint::from_degrees(46.83334, -6.083328)});
  site.columns.clear();
  site.water_depth_m = 4400;
  std::vector<api::SkillEntry> skill;
  for (const char* const day : {"2023-11-02", "2024-06-01", "2024-08-05"}) {
    const auto report = api::hindcast(store, site, pair_options(day, day, 150), {});
    skill.insert(skill.end(), report.skill.begin(), report.skill.end());
  }
  EXPECT_NEAR(set_error(skill, "persistence"), 0.2306, half_last_digit);
  EXPECT_NEAR(set_error(skill, "day-mean"), 0.1652, half_last_digit);
  EXPECT_NEAR(set_error(skill, "oracle-mean"), 0.1473, half_last_digit);
  // Our wind is bilinear where the page takes the nearest cell: the slab moves in the fourth digit.
  EXPECT_NEAR(set_error(skill, "reference-slab"), 0.0499, 0.001);
  EXPECT_LT(set_error(skill, "forecast"), set_error(skill, "persistence"));
}

TEST(RealPairs, OtrantoReproducesTheBaselinesPage) {
  SLACKWATER_NEEDS_SHARED(shared);
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, {shared / "data/otranto_2021-10/currents"}, true);
  ingest_all(store, {shared / "data/otranto_2021-10/wind"}, false);
  const std::vector<GeoPoint> cells = wet_cells(store, 1, 3);
  ASSERT_EQ(cells.size(), 394U);
  const auto report = api::hindcast(store, site_of("otranto", cells),
                                    pair_options("2021-10-12", "2021-10-13", 120), {});
  EXPECT_NEAR(set_error(report.skill, "persistence"), 0.1228, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "day-mean"), 0.1197, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "oracle-mean"), 0.0882, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "reference-slab"), 0.1111, 0.002);
  EXPECT_LT(set_error(report.skill, "forecast"), 1.2 * set_error(report.skill, "day-mean"));
}

TEST(RealPairs, ElbaReproducesTheBaselinesPage) {
  SLACKWATER_NEEDS_SHARED(shared);
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, {shared / "data/elba_2014-05"}, true);
  const std::vector<GeoPoint> cells = wet_cells(store, 0, 1);
  ASSERT_EQ(cells.size(), 168U);
  const auto report = api::hindcast(store, site_of("elba", cells),
                                    pair_options("2014-05-17", "2014-05-19", 120), {});
  EXPECT_EQ(report.forecasts.size(), 3U);
  EXPECT_NEAR(set_error(report.skill, "persistence"), 0.0678, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "day-mean"), 0.0693, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "oracle-mean"), 0.0395, half_last_digit);
  EXPECT_NEAR(set_error(report.skill, "reference-slab"), 0.0548, 0.002);
  EXPECT_LT(set_error(report.skill, "forecast"), set_error(report.skill, "day-mean"));
}

TEST(RealPairs, WavesAreScoredAgainstTheBuoyOfHollandseKustNoord) {
  SLACKWATER_NEEDS_SHARED(shared);
  const TemporaryFolder folder;
  store::Store store = store::Store::open(folder / "store", store::OpenMode::create_or_write);
  ingest_all(store, {shared / "data/dutch_coast_2017-10"}, false);
  api::Site site = site_of("hkn", {GeoPoint::from_degrees(52.6887, 4.242)});
  site.columns.clear();
  site.water_depth_m = 23;
  api::JobOptions job;
  job.day = parse_day("2017-10-28");
  job.issued = parse_utc("2017-10-29T05:00:00Z");
  job.horizon = std::chrono::hours(24);
  const auto data = api::load_site_data(store, site, UtcTime(*job.day) - api::history_read,
                                        UtcTime(*job.day) + std::chrono::days(2));
  const api::DailyForecast forecast = api::make_forecast(data, job);
  EXPECT_TRUE(forecast.snapshot.degraded);
  EXPECT_NE(forecast.snapshot.headline.find("currents"), std::string::npos)
      << forecast.snapshot.headline;
  static_cast<void>(api::publish(store, forecast, job));
  const auto skill = api::verify(store, site, {});
  const std::string height = "sea_surface_wave_significant_height";
  const auto ours = api::set_rmse(skill, height, "forecast", {0, 24});
  const auto held = api::set_rmse(skill, height, "persistence", {0, 24});
  ASSERT_TRUE(ours && held);
  EXPECT_EQ(skill.front().truth.substr(0, 7), "station") << skill.front().truth;
  EXPECT_LT(*ours, *held) << "the wave model knew of the storm";
  EXPECT_GT(*ours, 0.1) << "a model is not the buoy";
}

}  // namespace
}  // namespace slackwater::tests
